"""Tables 5.1 and 5.2 for our examples and for real meshes, beside the paper's; quality beside speed."""
import json
import pathlib
import statistics
import tempfile

from paper.edited_copies import edited_copy, recall
from parts import skeleton
from parts.common import ROOT, run, table

TITLE = "Tables 5.1 and 5.2"
INTRODUCTION = ("How far the skeleton graph compresses a mesh, and how long a match takes. The paper's models are not public: "
                "its rows stand first, on a machine of 2009, ours below.")

# Table 5.2 of the paper: vertices and edges of the mesh, seconds.
PAPER = [("bear", 1070, 2110, 0.04), ("chick", 932, 1827, 0.02), ("shirt", 3099, 6134, 0.12), ("director", 9958, 19889, 0.72),
         ("tommy", 10281, 20530, 0.76), ("body", 13238, 26457, 1.08), ("girl", 6976, 13903, 0.65)]
ALGORITHMS = ("greedy", "lazy-greedy", "regions", "exact")
# Exact is asked where it may answer: small meshes.
MOST_FACES_FOR_EXACT = 850
SECONDS_FOR_EXACT = 10
REPEATS = 3
EXAMPLES = ROOT / "examples"
# Similar models, alternate poses, and across edits, as the paper's second meshes are.
PAIRS = [("bear", "bear_no_ears_posed"), ("bear", "bear_posed"), ("shirt_long", "shirt_short"), ("fig_4_1", "fig_4_2"),
         ("dog_toy", "dog_toy")]


def light(faces):
    """The size of each edit of a light day's work."""
    share = max(2, faces // 100)
    return [f"delete:{share}", f"extrude:{share}", "collapse:3", "rip:8", f"refine:{share}", "renumber"]


def matched(options, source, target, algorithm, truth=None):
    """What the program says of a match, with the median of its times; None where it is not asked."""
    faces = max(faces_of(source), faces_of(target))
    limit = ["--time-limit", SECONDS_FOR_EXACT] if algorithm == "exact" else []
    if limit and faces > MOST_FACES_FOR_EXACT:
        return None
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder, "m.json")
        command = [options.program, "match", source, target, "-o", file, "--json", "--algorithm", algorithm, *limit]
        told = [json.loads(run(command, statuses=(0, 1))) for _ in range(1 if limit else REPEATS)]
        row = {"milliseconds": statistics.median(each["milliseconds"]["matching"] for each in told),
               "matched": told[0]["matched_faces"]}
        if limit:
            row |= {"proved": told[0]["optimality"]["proved"], "bound": told[0]["optimality"]["bound"]}
        if truth is not None:
            row["recall"] = recall(json.loads(file.read_text(encoding="utf-8")), truth)
        return row


def faces_of(mesh):
    with open(mesh, encoding="utf-8") as file:
        return sum(line.startswith("f ") for line in file)


def measure_pairs(options):
    rows = []
    for source, target in PAIRS:
        paths = [EXAMPLES / f"{name}.obj" for name in (source, target)]
        rows.append({"source": source, "target": target, **skeleton.sizes_of(options, paths[0])} |
                    {name: matched(options, *paths, name) for name in ALGORITHMS})
    return rows


def measure_edited(options):
    rows = []
    for mesh in meshes(options):
        try:
            with edited_copy(options, mesh, light(faces_of(mesh)), seed=1) as (target, truth):
                rows.append({"model": mesh.stem, **skeleton.sizes_of(options, mesh)} |
                            {name: matched(options, mesh, target, name, truth) for name in ALGORITHMS})
        except LookupError as reason:
            rows.append({"model": mesh.stem, "skipped": str(reason)})
    return rows


def meshes(options):
    found = sorted(EXAMPLES.glob("*.obj")) + sorted(options.meshes.glob("*.obj"))
    return found[:3] if options.quick else found


def measure(options):
    return {"skeletons": [{"model": mesh.stem, **skeleton.sizes_of(options, mesh)} for mesh in meshes(options)],
            "pairs": measure_pairs(options), "edited": measure_edited(options)}


def skeleton_rows(raw):
    rows = [[f"*{name}*", f"{v:,}", f"{e:,}", f"{sv:,}", f"{se:,}", f"{r} %"] for name, v, e, sv, se, r in skeleton.PAPER]
    for row in raw["skeletons"]:
        rows.append([row["model"]] + [f"{row[key]:,}" for key in skeleton.KEYS[:-1]] + [f"{row[skeleton.KEYS[-1]]:.0f} %"])
    return rows


def milliseconds(row):
    return f"{row['milliseconds']:.1f}" if row else "-"


def quads(row):
    if row is None:
        return "-"
    return f"{row['matched']:,}" + ("" if row.get("proved", True) else f" (at most {row['bound']:,})")


def share(row):
    return f"{row['recall']:.3f}" if row else "-"


def page(raw):
    page = ["\n## Table 5.1: skeleton graphs\n", "The paper's models in italics; ours by `quadmatch skeleton`.\n",
            table(skeleton.HEADER, skeleton_rows(raw)),
            "\n## Table 5.2: matching two models\n",
            "The paper's, in italics, by lazy-greedy; ours between shipped examples: similar models, alternate poses, a "
            "model and itself. Milliseconds of matching alone, one thread, medians of three runs; quads matched. *Exact* "
            f"proves that there is no larger region, or says how large one can be at most after {SECONDS_FOR_EXACT} seconds; "
            f"it is asked where neither mesh has more than {MOST_FACES_FOR_EXACT} faces.\n"]
    header = ["models", "vertices", "edges"] + [f"{name}, ms" for name in ALGORITHMS] + [f"{name}, quads" for name in ALGORITHMS]
    rows = [[f"*{name}*", f"{v:,}", f"{e:,}", "", f"{1000 * seconds:.0f}"] + [""] * 6 for name, v, e, seconds in PAPER]
    for row in raw["pairs"]:
        rows.append([f"{row['source']}, {row['target']}", f"{row['vertices']:,}", f"{row['edges']:,}"] +
                    [milliseconds(row[name]) for name in ALGORITHMS] + [quads(row[name]) for name in ALGORITHMS])
    page.append(table(header, rows))
    page += ["\n## Quality beside speed\n",
             "Each mesh and a copy with a light day's edits (`edit_mesh` with delete, extrude and refine of 1 % of the faces, "
             "collapse:3, rip:8, renumber). *Recall*: surviving faces matched to the true face by the true rotation. Exact "
             "finds the largest single region; regions finds many.\n"]
    header = ["model"] + [f"{name}, ms" for name in ALGORITHMS] + [f"{name}, recall" for name in ALGORITHMS]
    done = [row for row in raw["edited"] if "skipped" not in row]
    rows = [[row["model"]] + [milliseconds(row[name]) for name in ALGORITHMS] + [share(row[name]) for name in ALGORITHMS]
            for row in done]
    rows.append(["**mean**"] + [""] * len(ALGORITHMS) + [mean_recall(done, name) for name in ALGORITHMS])
    page.append(table(header, rows))
    page += [f"\n{row['model']} is left out: {row['skipped']}.\n" for row in raw["edited"] if "skipped" in row]
    return page


def mean_recall(rows, name):
    values = [row[name]["recall"] for row in rows if row[name]]
    return f"**{statistics.mean(values):.3f}**" if values else "-"
