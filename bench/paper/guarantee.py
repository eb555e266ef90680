"""The guarantee of §5 on planted mismatches: how often a match at least as good is found, by the width of corridors."""
import json
import os
import subprocess

from parts.common import Bar, bar_table, run, table
from parts.subjects import in_parallel

TITLE = "The guarantee"
INTRODUCTION = ("§5 promises a match at least as good as any whose mismatches have boundary complexity δ at most and between which "
                "lies a width of ε > 2δ. Planted mismatches show when that is so.")

SEEDS, QUICK_SEEDS = 400, 30
# ε / δ from, up to; the paper promises from 2 on.
CLASSES = [(0, 1), (1, 1.5), (1.5, 2), (2, 3), (3, 5), (5, float("inf"))]
# Algorithm, and which of the two anchors it is grown from.
RUNS = {"lazy-greedy": ("lazy-greedy", "anchor"), "lazy-greedy, anywhere": ("lazy-greedy", "anywhere"),
        "greedy": ("greedy", "anchor"), "regions": ("regions", "anchor"), "regions, anywhere": ("regions", "anywhere")}


def matched(options, row, algorithm, anchor):
    folder = options.build / "planted"
    command = [options.program, "match", folder / f"{row['name']}-source.obj", folder / f"{row['name']}-target.obj", "-o",
               os.devnull, "--json", "--quiet", "--algorithm", algorithm, "--orientation", "preserving", "--no-positions",
               "--anchor", anchor]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=True)
    return json.loads(ended.stdout)["matched_faces"]


def try_one(job):
    options, row = job
    return {**row, **{name: matched(options, row, algorithm, row[anchor]) for name, (algorithm, anchor) in RUNS.items()}}


def measure(options):
    made = run([options.build / "make_instances", "planted", options.build / "planted", "--count",
                QUICK_SEEDS if options.quick else SEEDS])
    rows = [json.loads(line) for line in made.splitlines()]
    return {"rows": in_parallel(options, try_one, [(options, row) for row in rows])}


def class_of(row):
    """Classes are open below and closed above, so that ε > 2δ begins one."""
    ratio = row["epsilon"] / row["delta"]
    return next(index for index, (_, up_to) in enumerate(CLASSES) if ratio <= up_to)


def name_of(bounds):
    low, high = bounds
    return f"> {low:g}" if high == float("inf") else f"{low:g} … {high:g}"


def as_good(rows, name):
    return f"{sum(row[name] >= row['planted'] for row in rows)}"


def promised(raw):
    return [row for row in raw["rows"] if row["epsilon"] > 2 * row["delta"]]


def bars(raw):
    rows = promised(raw)
    return [Bar(f"{name}: share of the promised matches that are at least as large",
                sum(row[name] >= row["planted"] for row in rows) / max(1, len(rows)), 1.0) for name in ("lazy-greedy", "regions")]


def page(raw):
    classes = [(bounds, [row for row in raw["rows"] if class_of(row) == index]) for index, bounds in enumerate(CLASSES)]
    classes = [(name_of(bounds), rows) for bounds, rows in classes if rows]
    found = [[name, len(rows)] + [as_good(rows, run_name) for run_name in RUNS] for name, rows in classes]
    worst = [[name, len(rows)] + [f"{min(row[run_name] / row['planted'] for row in rows):.2%}" for run_name in RUNS]
             for name, rows in classes]
    short = max((row["planted"] - row["lazy-greedy"] for row in promised(raw)), default=0)
    return [bar_table(bars(raw)),
            "\nGrids, tubes, tori and spheres with one to four places changed, written by `make_instances planted`: δ is the "
            "longest rim of a mismatch in edges, ε the least width between mismatches, or to the boundary, in quads, both "
            "measured. Each is matched by `quadmatch match --anchor`, from a true pair in the middle of a corridor, or from "
            "one *anywhere*. How often at least as many faces are matched as were planted in one region; the promise is from "
            "2 on, and of lazy-greedy:\n",
            table(["ε / δ", "instances", *RUNS], found),
            "\nThe worst instance of each class, faces matched by faces planted:\n",
            table(["ε / δ", "instances", *RUNS], worst),
            f"\nIn {len(promised(raw))} instances ε > 2δ. There lazy-greedy from the middle falls short of the planted match by "
            f"{max(short, 0)} faces at most. Why it can, however wide the corridors are: "
            "[design note 014](../design/014-guarantee.md).\n"]
