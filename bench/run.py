#!/usr/bin/env python3
"""Measure quadmatch and write docs/results.md, with the raw figures beside it in docs/results/.

usage: bench/run.py [--only speed,edited,skeleton,quality,regions,pairs] [--meshes FOLDER] [--tools FOLDER]

Needs a release build (cmake --preset release && cmake --build --preset release). Speed is measured on our own bear and,
where the collection of real meshes stands beside the project, on two bodies of it; the other parts need that collection
and its tools. Parts that are not run keep their last raw figures.
"""
import argparse
import json
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
RAW = ROOT / "docs" / "results"
PROGRAM = ROOT / "build" / "release" / "quadmatch"
BENCH = ROOT / "build" / "release" / "bench" / "quadmatch_bench"
REPETITIONS = 3

# Table 5.1 of the paper: vertices and edges of the mesh, then of its skeleton graph, then the reduction.
PAPER_TABLE_5_1 = [("bear", 1070, 2110, 202, 393, 81), ("chick", 932, 1827, 32, 56, 97), ("shirt", 3099, 6134, 518, 1015, 83),
                   ("director", 9958, 19889, 2510, 5001, 75), ("tommy", 10281, 20530, 2496, 4973, 76),
                   ("body", 13238, 26457, 3176, 6339, 76), ("girl", 6976, 13903, 2340, 4647, 66)]
SPEED_COLUMNS = ["build", "anchors", "regions", "lazy-greedy", "greedy"]
SKELETON_KEYS = ["vertices", "edges", "graph_vertices", "graph_edges", "reduction_percent"]
# The meshes on which a prototype of the paper's algorithm was measured, and its mean recall over the edits below.
QUALITY_MESHES = ["mh_male_casualsuit01", "mh_proxy741", "pairs/mh_male_generic_muscle/a", "tbm_duck_sculpture", "osd_rook",
                  "tbm_skull", "fe_plate_holes", "qt_trex"]
PROTOTYPE_RECALL = {"renumber": 0.8468, "delete": 0.8669, "extrude": 0.7749, "collapse": 0.8304, "rip": 0.7774,
                    "refine": 0.8454, "loop": 0.5797, "loops": 0.3249, "unloop": 0.5086, "twist": 0.6735,
                    "handle": 0.8467, "light": 0.7278, "heavy": 0.4180}


# One body, edited: the lightest edit, five light ones, and thirty with two loops; as the quality tool has them.
LIGHT = ["delete:1%", "extrude:1%", "collapse:3", "rip:8", "refine:1%"]
SPEED_EDITS = {"renumber": [], "delete": ["delete:3%"], "extrude": ["extrude:1%"], "loop": ["loop:1"], "light": LIGHT,
               "heavy": 6 * LIGHT + ["loop:2"]}
# Name: seeds, pose, options of the program.
REGION_RUNS = {"plain": ("1,2,21,22,23", "", ""), "connectivity": ("1,2", "", "--no-positions"),
               "bent": ("1,2", "bend:60", ""), "noisy": ("1,2", "noise:5", ""), "sculpted": ("1,2", "sculpt:30", "")}


def run(command, **options):
    print("  $", " ".join(str(word) for word in command), flush=True)
    return subprocess.run([str(word) for word in command], check=True, text=True, capture_output=True, **options).stdout


def keep(name, value):
    RAW.mkdir(parents=True, exist_ok=True)
    (RAW / name).write_text(json.dumps(value, indent=1) + "\n", encoding="utf-8")


def kept(name):
    path = RAW / name
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


def conditions():
    cpu = next((line.split(":", 1)[1].strip() for line in open("/proc/cpuinfo", encoding="utf-8")
                if line.startswith("model name")), platform.machine())
    return {"cpu": cpu, "system": f"{platform.system()} {platform.release()}",
            "compiler": run(["g++", "--version"]).splitlines()[0],
            "version": run([PROGRAM, "--version"]).strip(),
            "commit": run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"]).strip()}


def measure_speed(options):
    subjects = [("bear", ROOT / "examples" / "bear.obj", 4)]
    if options.meshes.is_dir():
        subjects += [("male_generic body", options.meshes / "pairs/mh_male_generic_muscle/a.obj", 3),
                     ("female1605 body", options.meshes / "pairs/mh_female1605_male1591/a.obj", 5)]
    figures = {"conditions": conditions(), "repetitions": REPETITIONS, "subjects": {}}
    for name, path, steps in subjects:
        with tempfile.TemporaryDirectory() as folder:
            output = run([BENCH, path, steps, f"{folder}/finest.obj", "--benchmark_format=json",
                          f"--benchmark_repetitions={REPETITIONS}", "--benchmark_enable_random_interleaving=true",
                          "--benchmark_min_time=0.1"])
        times = {}
        for row in json.loads(output)["benchmarks"]:
            if row["run_type"] == "iteration":
                entry = times.setdefault(row["run_name"], {"ms": [], "matched": row.get("matched", 0)})
                entry["ms"].append(round(row["cpu_time"], 4))
        figures["subjects"][name] = times
    keep("speed.json", figures)


def measure_edited(options):
    """Edited pairs against the renumbered one: milliseconds of matching as the program tells them, medians of five."""
    mesh = options.meshes / "pairs/mh_male_generic_muscle/a.obj"
    faces = sum(line.startswith("f ") for line in mesh.open(encoding="utf-8"))
    figures = {}
    for name, edits in SPEED_EDITS.items():
        sized = [edit if not edit.endswith("%") else f"{edit.split(':')[0]}:{faces * int(edit.split(':')[1][:-1]) // 100}"
                 for edit in edits]
        with tempfile.TemporaryDirectory() as folder:
            copy = pathlib.Path(folder, "copy.obj")
            run([sys.executable, options.tools / "edit_mesh.py", mesh, copy, f"{folder}/truth.json", "--seed", "1", *sized])
            figures[name] = [json.loads(run([PROGRAM, "match", mesh, copy, "--json", "--quiet"]))["milliseconds"]["matching"]
                             for _ in range(5)]
    keep("edited.json", figures)


def measure_skeletons(options):
    meshes = sorted((ROOT / "examples").glob("*.obj")) + sorted(options.meshes.glob("*.obj"))
    rows = []
    for mesh in meshes:
        row = skeleton_of(mesh)
        if options.tools.is_dir():  # no edit: only renumbered
            with tempfile.TemporaryDirectory() as folder:
                copy = pathlib.Path(folder, mesh.name)
                run([sys.executable, options.tools / "edit_mesh.py", mesh, copy, f"{folder}/truth.json"])
                shuffled = skeleton_of(copy)
            row["same when renumbered"] = {key: row[key] for key in row if key != "model"} == \
                                          {key: shuffled[key] for key in row if key != "model"}
        rows.append(row)
    keep("skeleton.json", rows)


def skeleton_of(mesh):
    figures = json.loads(run([PROGRAM, "skeleton", mesh, "--json", "--quiet"]))
    return {"model": mesh.stem, **{key: figures[0][key] for key in SKELETON_KEYS}}


def measure_quality(options):
    meshes = [options.meshes / f"{name}.obj" for name in QUALITY_MESHES]
    for algorithm in ("lazy-greedy", "greedy"):
        with tempfile.TemporaryDirectory() as folder:
            rows = pathlib.Path(folder, "rows.json")
            run([sys.executable, options.tools / "quality.py", "--matcher",
                 f"{PROGRAM} match {{a}} {{b}} -o {{m}} --quiet --algorithm {algorithm}", "--json", rows, *meshes])
            keep(f"quality-{algorithm}.json", json.loads(rows.read_text(encoding="utf-8")))


def measure_regions(options):
    """The engine under every condition that changes what it may look at."""
    meshes = [options.meshes / f"{name}.obj" for name in QUALITY_MESHES]
    for name, (seeds, pose, more) in REGION_RUNS.items():
        with tempfile.TemporaryDirectory() as folder:
            rows = pathlib.Path(folder, "rows.json")
            run([sys.executable, options.tools / "quality.py", "--matcher",
                 f"{PROGRAM} match {{a}} {{b}} -o {{m}} --quiet {more}", "--seeds", seeds, "--json", rows,
                 *(["--pose", pose] if pose else []), *meshes])
            keep(f"regions-{name}.json", json.loads(rows.read_text(encoding="utf-8")))


def measure_pairs(options):
    folders = sorted(path for path in (options.meshes / "pairs").iterdir() if path.is_dir())
    lines = {}
    for algorithm in ("regions", "lazy-greedy", "greedy"):
        output = run([sys.executable, options.tools / "real_pairs.py", "--matcher",
                      f"{PROGRAM} match {{a}} {{b}} -o {{m}} --quiet --algorithm {algorithm}", *folders])
        lines[algorithm] = output.splitlines()
    keep("pairs.json", lines)


def table(header, rows):
    cells = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in cells) + "\n"


def speed_page(figures):
    where = figures["conditions"]
    page = ["## Speed\n", "One thread, processor time. Medians of %d runs, interleaved at random; %s, %s, %s at %s.\n" % (
        figures["repetitions"], where["cpu"], where["compiler"], where["version"], where["commit"]),
        "Every mesh is refined by Catmull-Clark step by step and matched with a copy whose vertices, faces and first "
        "corners are in random order. *Anchors* are vertex codes, both skeletons and the colouring; *regions*, "
        "*lazy-greedy* and *greedy* are the whole match from two meshes in memory. Nanoseconds per quad.\n"]
    for name, times in figures["subjects"].items():
        median = {key: statistics.median(entry["ms"]) for key, entry in times.items()}
        sizes = sorted({int(key.split("/")[1]) for key in times})
        rows = []
        for size in sizes:
            per_quad = {what: median[f"{what}/{size}"] * 1e6 / size for what in SPEED_COLUMNS}
            rows.append([f"{size:,}", f"{times[f'regions/{size}']['matched']:,.0f}"] +
                        [f"{per_quad[what]:.0f}" for what in SPEED_COLUMNS])
        page.append(f"\n### {name}\n")
        page.append(table(["quads", "matched by regions", "build one mesh", "anchors", "regions", "lazy-greedy", "greedy"], rows))
        largest = sizes[-1]
        tiny, ours = median[f"read-tinyobjloader/{largest}"], median[f"read-quadmatch/{largest}"]
        parsing = ours - median[f"build-in-file-order/{largest}"]
        base = next((size for size in sizes if size >= 10000), sizes[0])
        matched = {what: median[f"{what}/{largest}"] for what in ("regions", "lazy-greedy")}
        growth = {what: matched[what] / largest / (median[f"{what}/{base}"] / base) for what in matched}
        bliss = median[f"bliss/{sizes[0]}"]
        page.append(f"\nThe finest mesh as a file: tinyobjloader reads it in {tiny:,.0f} ms, quadmatch in {parsing:,.0f} ms: "
                    f"**{tiny / parsing:.1f} times as fast**; with the connectivity, which tinyobjloader does not make, in "
                    f"{ours:,.0f} ms: {tiny / ours:.1f} times as fast. Matching takes regions "
                    f"{matched['regions']:,.0f} ms and lazy-greedy {matched['lazy-greedy']:,.0f} ms: "
                    f"**{matched['regions'] / tiny:.2f} and {matched['lazy-greedy'] / tiny:.2f} of tinyobjloader's time for "
                    f"one of the two files**. From {base:,} to {largest:,} quads the cost of a quad grows "
                    f"{growth['regions']:.2f} and {growth['lazy-greedy']:.2f} times. At {sizes[0]:,} quads bliss needs "
                    f"{bliss:,.1f} ms to say that the two graphs are the same, and regions "
                    f"{median[f'regions/{sizes[0]}']:,.1f} ms to match them: **1/{bliss / median[f'regions/{sizes[0]}']:.0f}**.\n")
    return page


def edited_page(figures):
    base = statistics.median(figures["renumber"])
    rows = [[name, f"{statistics.median(times):.1f}", f"{statistics.median(times) / base:.1f}"]
            for name, times in figures.items()]
    return ["\n### An edited body\n", "The male_generic body of 13,650 quads against edited copies of it: wall-clock "
            "milliseconds of matching, medians of five runs of the program, and the ratio to the copy that is only "
            "renumbered.\n", table(["edit", "ms", "ratio"], rows)]


def regions_page(runs):
    page = ["\n## Quality of regions\n",
            "The same meshes and edits by the default algorithm. *Worst* is the lowest recall of a pair, *covered* the "
            "share of surviving faces matched at all.\n"]
    keys = ("recall", "near", "precision", "far", "covered")
    for name, rows in runs.items():
        seeds, pose, more = REGION_RUNS[name]
        page.append(f"\n### {name}\n")
        page.append(f"Seeds {seeds}" + (f", every copy posed by `{pose}`" if pose else "") +
                    (f", with `{more}`" if more else "") + ".\n")
        if pose:  # the rook is rotation-symmetric: posed, nothing tells its turns apart
            rows = [row for row in rows if row["mesh"] != "osd_rook"]
            page.append("Without osd_rook, which is rotation-symmetric.\n")
        lines = []
        for edit in dict.fromkeys(row["edit"] for row in rows):
            group = [row for row in rows if row["edit"] == edit and "recall" in row]
            if group:
                lines.append([edit, len(group)] + [f"{statistics.mean(row[key] for row in group):.4f}" for key in keys] +
                             [f"{min(row['recall'] for row in group):.4f}"])
        page.append(table(["edit", "pairs", *keys, "worst"], lines))
        unsound = sum(1 for row in rows if row.get("faults") or "failed" in row)
        page.append(f"\n{unsound} unsound by the independent verifier.\n")
    return page


def skeleton_page(rows):
    page = ["\n## Skeleton graphs\n", "The paper's Table 5.1:\n",
            table(["model", "vertices", "edges", "skeleton vertices", "skeleton edges", "reduction"],
                  [[name, f"{v:,}", f"{e:,}", f"{sv:,}", f"{se:,}", f"{r} %"] for name, v, e, sv, se, r in PAPER_TABLE_5_1]),
            "\nOurs, by `quadmatch skeleton`: the shipped examples and the real meshes.\n"]
    ours = [[row["model"]] + [f"{row[key]:,}" for key in SKELETON_KEYS[:-1]] + [f"{row[SKELETON_KEYS[-1]]:.0f} %"]
            for row in rows]
    page.append(table(["model", "vertices", "edges", "skeleton vertices", "skeleton edges", "reduction"], ours))
    checked = [row for row in rows if "same when renumbered" in row]
    same = sum(row["same when renumbered"] for row in checked)
    if checked:
        page.append(f"\nRenumbered copies of {len(checked)} meshes gave the same sizes for {same} of them.\n")
    return page


def quality_page(by_algorithm):
    page = ["\n## Quality on edited copies\n",
            "Eight real meshes, each edit with seeds 1 and 2, true correspondence known, connectivity only. *Recall*: "
            "surviving faces matched to the true face by the true rotation. *Prototype* is the paper's lazy-greedy as an "
            "earlier prototype had it, the bar for ours.\n"]
    means = {algorithm: {edit: statistics.mean(row["recall"] for row in rows if row["edit"] == edit and "recall" in row)
                         for edit in PROTOTYPE_RECALL} for algorithm, rows in by_algorithm.items()}
    def mean(rows, edit, key):
        return statistics.mean(row[key] for row in rows if row["edit"] == edit and key in row)
    lazy = by_algorithm["lazy-greedy"]
    rows = [[edit, f"{PROTOTYPE_RECALL[edit]:.3f}", f"{means['greedy'][edit]:.3f}", f"{means['lazy-greedy'][edit]:.3f}"] +
            [f"{mean(lazy, edit, key):.3f}" for key in ("near", "precision", "far", "covered")] for edit in PROTOTYPE_RECALL]
    rows.append(["**mean**"] + [f"**{statistics.mean(values):.3f}**" for values in
                                (PROTOTYPE_RECALL.values(), means["greedy"].values(), means["lazy-greedy"].values())] + [""] * 4)
    page.append(table(["edit", "prototype", "greedy", "lazy-greedy", "near", "precision", "far", "covered"], rows))
    unsound = sum(1 for rows in by_algorithm.values() for row in rows if row.get("faults") or "failed" in row)
    pairs = sum(1 for rows in by_algorithm.values() for row in rows if "recall" in row)
    page.append(f"\n{pairs} matches, {unsound} of them unsound by the independent verifier.\n")
    return page


def pairs_page(lines):
    page = ["\n## Real pairs\n", "Versions of real models; *known* are the faces whose partner positions tell.\n"]
    for algorithm, output in lines.items():
        page += [f"\n`--algorithm {algorithm}`\n", "```text", *output, "```"]
    return page


def write_page():
    page = ["# Results\n", "Every figure on this page was made by `bench/run.py`, which also keeps the raw ones in "
            "`docs/results/`. Run it again after `cmake --preset release && cmake --build --preset release`.\n"]
    if kept("speed.json"):
        page += speed_page(kept("speed.json"))
    if kept("edited.json"):
        page += edited_page(kept("edited.json"))
    if kept("skeleton.json"):
        page += skeleton_page(kept("skeleton.json"))
    if kept("quality-lazy-greedy.json"):
        page += quality_page({name: kept(f"quality-{name}.json") for name in ("greedy", "lazy-greedy")})
    runs = {name: kept(f"regions-{name}.json") for name in REGION_RUNS if kept(f"regions-{name}.json")}
    if runs:
        page += regions_page(runs)
    if kept("pairs.json"):
        page += pairs_page(kept("pairs.json"))
    (ROOT / "docs" / "results.md").write_text("\n".join(page).rstrip() + "\n", encoding="utf-8")


PARTS = {"speed": measure_speed, "edited": measure_edited, "skeleton": measure_skeletons, "quality": measure_quality,
         "regions": measure_regions, "pairs": measure_pairs}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default=",".join(PARTS))
    parser.add_argument("--meshes", type=pathlib.Path, default=ROOT.parent / "shared" / "meshes")
    parser.add_argument("--tools", type=pathlib.Path, default=ROOT.parent / "shared" / "tools")
    options = parser.parse_args()
    for part in options.only.split(",") if options.only else []:
        if part in ("edited", "quality", "regions", "pairs") and not (options.meshes.is_dir() and options.tools.is_dir()):
            print(f"{part}: skipped, no collection of meshes at {options.meshes}")
            continue
        print(part, flush=True)
        PARTS[part](options)
    write_page()


if __name__ == "__main__":
    main()
