"""The guarantee of §5 on planted mismatches: how often a match at least as good is found, by the width of corridors."""
import concurrent.futures
import json
import os
import pathlib
import subprocess

SEEDS, QUICK_SEEDS = 400, 30
# ε / δ from, up to; the paper promises from 2 on.
CLASSES = [(0, 1), (1, 1.5), (1.5, 2), (2, 3), (3, 5), (5, float("inf"))]
# Algorithm, and which of the two anchors it is grown from.
RUNS = {"lazy-greedy": ("lazy-greedy", "anchor"), "lazy-greedy, anywhere": ("lazy-greedy", "anywhere"),
        "greedy": ("greedy", "anchor"), "regions": ("regions", "anchor"), "regions, anywhere": ("regions", "anywhere")}


def matched(options, row, algorithm, anchor):
    folder = pathlib.Path(options.build) / "planted"
    command = [options.program, "match", folder / f"{row['name']}-source.obj", folder / f"{row['name']}-target.obj", "-o",
               os.devnull, "--json", "--quiet", "--algorithm", algorithm, "--orientation", "preserving", "--no-positions",
               "--anchor", anchor]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=True)
    return json.loads(ended.stdout)["matched_faces"]


def try_one(job):
    options, row = job
    return {**row, **{name: matched(options, row, algorithm, row[anchor]) for name, (algorithm, anchor) in RUNS.items()}}


def measure(options):
    made = subprocess.run([str(pathlib.Path(options.build) / "make_instances"), "planted",
                           str(pathlib.Path(options.build) / "planted"), "--count",
                           str(QUICK_SEEDS if options.quick else SEEDS)], check=True, capture_output=True, text=True).stdout
    rows = [json.loads(line) for line in made.splitlines()]
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        return {"rows": list(pool.map(try_one, [(options, row) for row in rows], chunksize=8))}


def table(header, rows):
    cells = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in cells) + "\n"


def class_of(row):
    """Classes are open below and closed above, so that ε > 2δ begins one."""
    ratio = row["epsilon"] / row["delta"]
    return next(index for index, (_, up_to) in enumerate(CLASSES) if ratio <= up_to)


def name_of(bounds):
    low, high = bounds
    return f"> {low:g}" if high == float("inf") else f"{low:g} … {high:g}"


def as_good(rows, name):
    return f"{sum(row[name] >= row['planted'] for row in rows)}"


def page(raw):
    lines, worst = [], []
    for index, bounds in enumerate(CLASSES):
        rows = [row for row in raw["rows"] if class_of(row) == index]
        if not rows:
            continue
        lines.append([name_of(bounds), len(rows)] + [as_good(rows, name) for name in RUNS])
        worst.append([name_of(bounds), len(rows)] + [f"{min(row[name] / row['planted'] for row in rows):.2%}" for name in RUNS])
    promised = [row for row in raw["rows"] if row["epsilon"] > 2 * row["delta"]]
    short = max((row["planted"] - row["lazy-greedy"] for row in promised), default=0)
    return ["\n## The guarantee of §5\n",
            "Grids, tubes, tori and spheres with one to four places changed, written by `make_instances planted`: δ is the "
            "longest rim of a mismatch in edges, ε the least width between mismatches, or to the boundary, in quads, both "
            "measured. Each is matched by `quadmatch match --anchor`, from a true pair in the middle of a corridor, or from "
            "one *anywhere*. How often at least as many faces are matched as were planted in one region; the paper promises "
            "it of lazy-greedy where ε > 2δ:\n",
            table(["ε / δ", "instances", *RUNS], lines),
            "\nThe worst instance of each class, faces matched by faces planted:\n",
            table(["ε / δ", "instances", *RUNS], worst),
            f"\n{len(promised)} instances with ε > 2δ; there lazy-greedy from the middle falls short of the planted match by "
            f"{max(short, 0)} faces at most. Why it can, however wide the corridors are: "
            "[design note 014](design/014-guarantee.md).\n"]
