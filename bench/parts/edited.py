"""How much more edited pairs cost than a pair that is only renumbered."""
import json
import statistics

from parts.common import Bar, bar_table, keep, kept, run, table
from parts.subjects import edited_copy, edits_named

EDITS = ["renumber", "delete", "extrude", "loop", "light", "heavy"]
MOST = {**{edit: 6 for edit in EDITS[1:]}, "heavy": 15}


def measure(options):
    mesh = options.meshes / "pairs/mh_male_generic_muscle/a.obj"
    figures = {}
    for name in EDITS:
        with edited_copy(mesh, edits_named(name), seed=1) as (source, copy, _):
            figures[name] = [json.loads(run([options.program, "match", source, copy, "--json", "--quiet"]))
                             ["milliseconds"]["matching"] for _ in range(5)]
    keep(options, "edited.json", figures)


def ratios(figures):
    base = statistics.median(figures["renumber"])
    return {name: statistics.median(times) / base for name, times in figures.items()}


def bars(options):
    figures = kept(options, "edited.json")
    return [Bar(f"edited body: time of {name} / renumbered", ratio, MOST[name], at_most=True)
            for name, ratio in ratios(figures).items() if name in MOST] if figures else []


def page(options):
    figures = kept(options, "edited.json")
    if not figures:
        return []
    rows = [[name, f"{statistics.median(times):.1f}", f"{ratios(figures)[name]:.1f}"] for name, times in figures.items()]
    return ["\n### An edited body\n", "The male_generic body of 13,650 quads against edited copies of it: wall-clock "
            "milliseconds of matching, medians of five runs of the program, and the ratio to the copy that is only "
            "renumbered.\n", table(["edit", "ms", "ratio"], rows), "\n" + bar_table(bars(options))]
