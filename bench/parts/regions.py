"""Quality of the default algorithm under every condition that changes what it may look at."""
import statistics

from parts.common import Bar, bar_table, keep, kept, table
from parts.subjects import SYMMETRIC, measure_quality

# Name: seeds, pose, options of the program.
RUNS = {"plain": ("1,2,21,22,23", "", ""), "connectivity": ("1,2", "", "--no-positions"), "bent": ("1,2", "bend:60", ""),
        "noisy": ("1,2", "noise:5", ""), "sculpted": ("1,2", "sculpt:30", "")}
KEYS = ("recall", "near", "precision", "far", "covered")

SURE = ("renumber", "delete", "refine", "handle", "extrude", "rip", "collapse")
LOOP_KINDS = ("loop", "loops", "unloop", "twist")
POSED_BARS = {"recall": {"loop": 0.98, "twist": 0.98, "light": 0.98, "loops": 0.97, "unloop": 0.94, "heavy": 0.90,
                         **{edit: 0.98 for edit in SURE}}}
BARS = {"plain": {"recall": {**{edit: 0.999 for edit in SURE}, "loop": 0.998, "loops": 0.998, "light": 0.998, "twist": 0.995,
                             "unloop": 0.98, "heavy": 0.95},
                  "precision": {**{edit: 0.99 for edit in (*SURE, "loop", "loops", "unloop", "light")}, "twist": 0.975,
                                "heavy": 0.98},
                  "far": {**{edit: 0.001 for edit in (*SURE, *LOOP_KINDS, "light")}, "heavy": 0.005}},
        "connectivity": {"near": {edit: 0.995 for edit in LOOP_KINDS}, "recall": {"heavy": 0.85}},
        "bent": POSED_BARS, "noisy": POSED_BARS, "sculpted": POSED_BARS}


def measure(options):
    for name, (seeds, pose, more) in RUNS.items():
        keep(options, f"regions-{name}.json", measure_quality(options, seeds, more.split(), pose))


def runs_kept(options):
    found = {name: kept(options, f"regions-{name}.json") for name in RUNS}
    return {name: told(name, rows) for name, rows in found.items() if rows}


def told(name, rows):
    """Posed, the symmetric mesh is left out."""
    return [row for row in rows if not RUNS[name][1] or row["mesh"] != SYMMETRIC]


def mean(rows, edit, key="recall"):
    values = [row[key] for row in rows if row["edit"] == edit and key in row]
    return statistics.mean(values) if values else None


def bars(options):
    found = []
    for name, rows in runs_kept(options).items():
        for key, by_edit in BARS[name].items():
            for edit, bound in by_edit.items():
                value = mean(rows, edit, key)
                if value is not None:
                    found.append(Bar(f"regions, {name}: {key} of {edit}", value, bound, at_most=key == "far"))
    return found


def page(options):
    runs = runs_kept(options)
    if not runs:
        return []
    page = ["\n## Quality of regions\n",
            "The same meshes and edits by the default algorithm. *Worst* is the lowest recall of a pair, *covered* the "
            "share of surviving faces matched at all.\n"]
    for name, rows in runs.items():
        seeds, pose, more = RUNS[name]
        page.append(f"\n### {name}\n")
        page.append(f"Seeds {seeds}" + (f", every copy posed by `{pose}`" if pose else "") +
                    (f", with `{more}`" if more else "") + ".\n")
        if pose:
            page.append(f"Without {SYMMETRIC}, which is rotation-symmetric: posed, nothing tells its turns apart.\n")
        lines = []
        for edit in dict.fromkeys(row["edit"] for row in rows):
            group = [row for row in rows if row["edit"] == edit and "recall" in row]
            if group:
                lines.append([edit, len(group)] + [f"{mean(group, edit, key):.4f}" for key in KEYS] +
                             [f"{min(row['recall'] for row in group):.4f}"])
        page.append(table(["edit", "pairs", *KEYS, "worst"], lines))
        unsound = sum(1 for row in rows if row.get("faults") or "failed" in row)
        page.append(f"\n{unsound} unsound by the independent verifier.\n")
    all_bars = bars(options)
    missed = [bar for bar in all_bars if bar.missed_by]
    page.append(f"\n### Bars\n\n{len(all_bars) - len(missed)} of {len(all_bars)} are met.\n" +
                ("\n" + bar_table(missed) if missed else ""))
    return page
