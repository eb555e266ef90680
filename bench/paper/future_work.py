"""§6, future work: disconnected models, and several regions, with evidence of what answers them."""
import itertools
import json
import pathlib
import statistics
import tempfile

from paper.edited_copies import edited_copy, run_tool, true_pairs
from parts.common import ROOT, run, table
from parts.subjects import QUALITY_MESHES, in_parallel, match, name_of

TITLE = "Future work, answered"
INTRODUCTION = "The two questions of §6, and what `--algorithm regions` does about them, measured beside the paper's lazy-greedy."

EXAMPLES = ("bear", "shirt_long", "dog_toy")
EDITS = {"loop": ["loop:1"], "loops": ["loop:3"], "twist": ["twist:1"], "extrude": ["extrude:40"], "delete": ["delete:60"],
         "several": ["delete:30", "extrude:30", "loop:1", "rip:6", "collapse:3"]}
SEEDS = (1, 2, 3)
MANY_PARTS = ("mh_hm08_base", "tbm_vintage_rotary_phone", "mh2_bot")
CUBES = 40
WAYS = {"lazy-greedy": ["--algorithm", "lazy-greedy"], "regions, connectivity": ["--no-positions"], "regions": []}


def subjects(options):
    names = QUALITY_MESHES if options.meshes.is_dir() else []
    return [ROOT / "examples" / f"{name}.obj" for name in EXAMPLES] + [options.meshes / f"{name}.obj" for name in names]


def figures_of(found, truth):
    faces = sum(len(region["faces"]) for region in found["regions"])
    right = true_pairs(found, truth)
    return {"recall": right / max(1, len(truth)), "precision": right / max(1, faces), "regions": len(found["regions"]),
            "matched": faces, "ambiguous": sum(len(r["faces"]) for r in found["regions"] if r.get("ambiguous"))}


def measure_edit(job):
    options, mesh, edit, seed = job
    row = {"mesh": name_of(mesh), "edit": edit, "seed": seed}
    try:
        with edited_copy(options, mesh, EDITS[edit] + ["renumber"], seed) as (target, truth):
            return row | {way: figures_of(match(options, mesh, target, *more), truth) for way, more in WAYS.items()}
    except LookupError as reason:
        return row | {"skipped": str(reason)}


def measure_parts(job):
    options, name, mesh = job
    components = json.loads(run([options.program, "check", mesh, "--json"], statuses=(0, 1)))[0]["components"]
    with edited_copy(options, mesh, ["renumber"], 1) as (target, truth):
        return {"model": name, "components": len(components), "faces": len(truth)} | {
            way: figures_of(match(options, mesh, target, *more), truth) for way, more in WAYS.items()}


def measure(options):
    jobs = [(options, mesh, edit, seed) for mesh, edit, seed in itertools.product(subjects(options), EDITS, SEEDS)]
    with tempfile.TemporaryDirectory() as folder:
        cubes = pathlib.Path(folder, "cubes.obj")
        run_tool(options, "make_shape", f"cubes:{CUBES}", cubes)
        models = [(f"{CUBES} cubes", cubes)] + [(name, options.meshes / f"{name}.obj") for name in MANY_PARTS
                                                if options.meshes.is_dir()]
        parts = in_parallel(options, measure_parts, [(options, name, mesh) for name, mesh in models])
    return {"edits": in_parallel(options, measure_edit, jobs[::12] if options.quick else jobs), "parts": parts}


def mean(rows, way, key):
    return statistics.mean(row[way][key] for row in rows)


def parts_table(raw):
    rows = []
    for row in raw["parts"]:
        rows.append([row["model"], row["components"], f"{row['faces']:,}"] +
                    [f"{row[way]['matched']:,}" for way in WAYS] +
                    [f"{row[way]['ambiguous']:,}" for way in list(WAYS)[1:]] + [f"{row['regions']['recall']:.4f}"])
    return table(["model", "components", "faces"] + [f"{way}: faces matched" for way in WAYS] +
                 [f"{way}: ambiguous" for way in list(WAYS)[1:]] + ["regions: recall"], rows)


def edits_table(raw):
    done = [row for row in raw["edits"] if "skipped" not in row]
    rows = []
    for edit in EDITS:
        here = [row for row in done if row["edit"] == edit]
        if here:
            rows.append([f"`{' '.join(EDITS[edit])}`", len(here)] + [f"{mean(here, way, 'recall'):.3f}" for way in WAYS] +
                        [f"{mean(here, way, 'precision'):.3f}" for way in WAYS] + [f"{mean(here, 'regions', 'regions'):.1f}"])
    return table(["edit", "pairs"] + [f"{way}: recall" for way in WAYS] + [f"{way}: precision" for way in WAYS] +
                 ["regions found"], rows)


def page(raw):
    return ["\n## \"How hard is it to extend the lazy-greedy algorithm to handle disconnected models?\"\n",
            "Growing is easy to extend: one anchor for each component. Hard is to know which component lies on which. Equal "
            "components are laid on each other whole, and where several are equal (eyes, bolts), connectivity cannot choose: "
            "positions do, if the model did not move; else one way is taken and all of it is reported ambiguous. Models and "
            "renumbered copies of them; lazy-greedy ends with one component.\n",
            parts_table(raw),
            "\n## \"Is there a way to generalize the lazy-greedy approach to handle disconnected matching regions in a way that "
            "maintains distance and intuitive correspondence as much as possible?\"\n",
            "Many anchors burn at once, each a region of its own; regions that meet and agree are united, and where they "
            "disagree a seam stays between them. [How it works](../how-it-works.md) tells the rest. Connectivity alone decides "
            "nearly everything; edge lengths and positions, where there are any, decide what it leaves open (\"maintains "
            "distance\"). Edited copies of shipped and real models, seeds "
            f"{', '.join(map(str, SEEDS))}; *recall* is the share of surviving faces matched to the true face by the true "
            "rotation, *precision* the share of what was matched that is true.\n",
            edits_table(raw),
            f"\n{sum('skipped' in row for row in raw['edits'])} pairs are left out: the edit does not fit the model.\n"]
