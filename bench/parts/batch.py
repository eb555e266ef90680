"""Many pairs: throughput by threads, memory held against what was asked for, and the estimate against what is used."""
import json
import pathlib
import random
import statistics
import sys
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, conditions, keep, kept, measured_run, run, table

PAIRS = 10_000
REPETITIONS = 5
LEAST_SCALING = 1.8
EDITS = ["loop:4", "unloop:2", "twist:2", "rip:40", "delete:200", "refine:100", "extrude:200", "renumber"]
LARGE_PAIRS = 24


def batch(options, folder, jobs, results, *more):
    """Figures of a run and the peak of its memory in bytes."""
    command = [options.program, "batch", folder / jobs, "-o", folder / results, "--json", "--quiet", *more]
    took = measured_run(command)
    return json.loads(took.output) | {"milliseconds": took.milliseconds, "peak": took.peak}


def throughput(options):
    """Pairs in a second of many small pairs, by threads."""
    pairs = 1000 if options.quick else PAIRS
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        run([sys.executable, ROOT / "scripts" / "test_batch.py", "--build", options.build, "--only-make", folder, "--pairs",
             pairs])
        seconds = {1: [], 2: []}  # in turns, so that a busy minute of the machine falls on both
        for repetition in range(REPETITIONS):
            for threads, times in seconds.items():
                figures = batch(options, folder, "jobs.csv", f"r{threads}-{repetition}", "--threads", threads)
                times.append(figures["milliseconds"] / 1000)
        return [{"threads": threads, "pairs": pairs, "seconds": times, "pairs/s": pairs / statistics.median(times)}
                for threads, times in seconds.items()]


def kinds_of_pair(options, folder):
    """Large pairs of every kind: the same, edited, unrelated; and the same pair in every format."""
    edit, steps = options.build / "edit_mesh", 2 if options.quick else 3
    run([edit, ROOT / "examples" / "bear.obj", folder / "bear.obj", f"subdivide:{steps}"])
    run([edit, ROOT / "examples" / "shirt_long.obj", folder / "shirt.obj", f"subdivide:{steps}"])
    run([edit, folder / "bear.obj", folder / "edited.obj", *EDITS])
    run([edit, folder / "bear.obj", folder / "same.obj", "renumber"])
    for ending in ("ply", "off", "usda"):
        run([edit, folder / "bear.obj", folder / f"bear.{ending}", "renumber"])
        run([edit, folder / "edited.obj", folder / f"edited.{ending}", "renumber"])
    pairs = {"the same": ("bear.obj", "same.obj", ""), "edited": ("bear.obj", "edited.obj", ""),
             "edited, without positions": ("bear.obj", "edited.obj", "yes"), "unrelated": ("bear.obj", "shirt.obj", "")}
    return pairs | {f"edited, {ending}": (f"bear.{ending}", f"edited.{ending}", "") for ending in ("ply", "off", "usda")}


def estimates(options):
    """The peak of a run of one pair, above that of a run of a tiny one, against its estimate."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        pairs = kinds_of_pair(options, folder)
        run([options.build / "make_shape", "prism:4", folder / "tiny.obj"])
        (folder / "tiny.csv").write_text("source,target\ntiny.obj,tiny.obj\n", encoding="utf-8")
        base = batch(options, folder, "tiny.csv", "tiny", "--threads", 1)["peak"]
        rows = []
        for number, (kind, (source, target, without)) in enumerate(pairs.items()):
            (folder / "one.csv").write_text(f"source,target,output,no-positions\n{source},{target},m.json,{without}\n",
                                            encoding="utf-8")
            figures = batch(options, folder, "one.csv", f"one {number}", "--threads", 1)
            (line,) = [json.loads(text) for text in (folder / f"one {number}" / "results.jsonl").read_text().splitlines()]
            rows.append({"kind": kind, "faces": line["source_faces"] + line["target_faces"], "peak": figures["peak"] - base,
                         "estimate": line["estimated_bytes"]})
        return {"base": base, "rows": rows, "bounded": bounded(options, folder, pairs, rows, base)}


def bounded(options, folder, pairs, rows, base):
    """Many large pairs with eight threads, and memory for three of the largest: the peak against that."""
    allowed = 3 * max(row["estimate"] for row in rows)
    chance = random.Random(1)
    with open(folder / "many.csv", "w", encoding="utf-8") as file:
        file.write("source,target,name,output\n")
        for number in range(LARGE_PAIRS):
            source, target, _ = chance.choice(list(pairs.values()))
            file.write(f"{source},{target},{number},m{number}.json\n")
    figures = batch(options, folder, "many.csv", "many", "--threads", 8, "--memory", allowed)
    return {"allowed": allowed, "peak": figures["peak"] - base, "pairs": LARGE_PAIRS, "matched": figures["matched"]}


def measure(options):
    keep(options, "batch.json", {"conditions": conditions(options), "throughput": throughput(options),
                                 "memory": estimates(options)})


def scaling(figures):
    one, two = (row["pairs/s"] for row in figures["throughput"])
    return two / one


def bars(options):
    figures = kept(options, "batch.json")
    if not figures:
        return []
    worst = max(figures["memory"]["rows"], key=lambda row: row["peak"] / row["estimate"])
    bounds = figures["memory"]["bounded"]
    return [Bar("batch: pairs/s, two threads / one", scaling(figures), LEAST_SCALING),
            Bar(f"batch: memory used / estimated, the worst ({worst['kind']})", worst["peak"] / worst["estimate"], 1,
                at_most=True),
            Bar("batch: memory used / allowed, eight threads", bounds["peak"] / bounds["allowed"], 1, at_most=True)]


def page(options):
    figures = kept(options, "batch.json")
    if not figures:
        return []
    speeds = [[row["threads"], f"{row['pairs']:,}", f"{row['pairs/s']:,.0f}"] for row in figures["throughput"]]
    memory = [[row["kind"], f"{row['faces']:,}", f"{row['peak'] / 1e6:,.0f}", f"{row['estimate'] / 1e6:,.0f}",
               f"{row['peak'] / row['estimate']:.2f}"] for row in figures["memory"]["rows"]]
    bounds = figures["memory"]["bounded"]
    return ["\n## Many pairs\n",
            f"{command_line('batch')}. `quadmatch batch` on small pairs (medians of {REPETITIONS} runs in turns, every tenth pair with a "
            f"match file), on {figures['conditions']['processors']} processors:\n",
            table(["threads", "pairs", "pairs/s"], speeds),
            "\nLarge pairs one by one: most resident memory, above that of the bare program, in megabytes, and what `batch` "
            "estimated before it read them:\n",
            table(["pair", "faces of both", "peak", "estimate", "share"], memory),
            f"\n{bounds['pairs']} of them with eight threads and `--memory` {bounds['allowed'] / 1e6:,.0f} MB: peak "
            f"{bounds['peak'] / 1e6:,.0f} MB.\n",
            "\n" + bar_table(bars(options))]
