#!/usr/bin/python3
"""Kill quadmatch batch again and again, and see that nothing of it is lost, repeated or changed.

usage: scripts/test_batch.py [--build FOLDER] [--pairs N] [--kills K] [--seed S] [--only-make FOLDER]

Makes N small pairs, does them in one go, then again with SIGKILL at K random moments and a resumption after each. The
results of both must be the same, byte by byte but for times; what a killed run had recorded must stay as it was, times
and all; and shards, merged, must be the same as well.
"""
import argparse
import contextlib
import csv
import pathlib
import random
import shutil
import signal
import sqlite3
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[1]
SHAPES = ["sphere:3", "cylinder:9,6", "torus:7,5", "star:5,4", "grating:2,2", "dog_toy:2,2", "prism:12", "cubes:4"]
EDITS = ["renumber", "delete:3", "extrude:2", "refine:2", "loop:1", "twist:1", "rip:2"]
OUTPUT_EVERY = 10  # jobs that also write a match file


def run(*command, statuses=(0,)):
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode not in statuses:
        raise SystemExit(f"{command} ended with status {ended.returncode}: {ended.stderr}")
    return ended.stdout


def make_meshes(build, folder, count):
    """So many small meshes that all their pairs are enough: shapes, and edits of them."""
    names, seed = [], 0
    while len(names) < count:
        for shape in SHAPES:
            base = f"{shape.replace(':', '_').replace(',', '_')}.obj"
            if not (folder / base).exists():
                run(build / "make_shape", shape, folder / base)
                names.append(base)
            for edit in EDITS:
                name = f"{base[:-4]} {edit.replace(':', '_')} {seed}.obj"
                made = subprocess.run([build / "edit_mesh", folder / base, folder / name, edit, "renumber", "--seed",
                                       str(seed)], capture_output=True, check=False)
                if made.returncode == 0:  # not every edit has room on every shape
                    names.append(name)
        seed += 1
    return names[:count]


def write_list(path, names, pairs, outputs):
    """Distinct pairs, every so often one that must fail."""
    (path.parent / outputs).mkdir()
    with open(path, "w", newline="", encoding="utf-8") as file:
        rows = csv.writer(file)
        rows.writerow(["source", "target", "output", "no-positions", "algorithm"])
        for number in range(pairs):
            source, target = names[number % len(names)], names[(number // len(names) * 7 + number * 3) % len(names)]
            output = f"{outputs}/{number}.json" if number % OUTPUT_EVERY == 0 else ""
            if number % 500 == 499:
                source = f"missing {number}.obj"
            rows.writerow([source, target, output, "yes" if number % 3 == 0 else "",
                           "lazy-greedy" if number // len(names) % 2 else ""])


def rows_of(database, columns="*"):
    with contextlib.closing(sqlite3.connect(database)) as connection:
        try:
            return connection.execute(f"SELECT {columns} FROM pairs ORDER BY job").fetchall()
        except sqlite3.OperationalError as error:
            if "no such table" in str(error):  # killed before the first moment
                return []
            raise


def batch(build, jobs, results, *more):
    return [build / "quadmatch", "batch", jobs, "-o", results, "--quiet", *more]


def kill_at_random(build, jobs, results, kills, longest, chance):
    """Start and kill so often. @return rows recorded after each kill, or None where the run ended before the last."""
    recorded, counts = [], []
    for _ in range(kills):
        with subprocess.Popen([str(word) for word in batch(build, jobs, results)]) as process:
            time.sleep(chance.uniform(0, longest))
            if process.poll() is not None:
                return None
            process.send_signal(signal.SIGKILL)
        rows = rows_of(results / "results.sqlite") if (results / "results.sqlite").exists() else []
        now = {row[0]: row for row in rows}
        for row in recorded:
            assert now.get(row[0]) == row, f"job {row[0]} was recorded and is lost, or was done again: {row}"
        recorded = rows
        counts.append(len(rows))
    return counts


def outputs_of(folder):
    # What replaces a file is written beside it first, and a killed process leaves that behind.
    return {path.name: path.read_bytes() for path in folder.glob("*.json")}


def same_results(one, other, what):
    assert (one / "results.jsonl").read_bytes() == (other / "results.jsonl").read_bytes(), f"{what}: other lines"
    columns = [column for column in columns_of(one) if not column.endswith("_ms")]
    assert rows_of(one / "results.sqlite", ",".join(columns)) == rows_of(other / "results.sqlite", ",".join(columns)), what


def columns_of(results):
    with contextlib.closing(sqlite3.connect(results / "results.sqlite")) as connection:
        return [row[1] for row in connection.execute("PRAGMA table_info(pairs)")]


def make_jobs(options, folder):
    jobs = folder / "jobs.csv"
    write_list(jobs, make_meshes(options.build, folder, 160), options.pairs, "matches")
    return jobs


def test(options, folder):
    jobs = make_jobs(options, folder)
    started = time.perf_counter()
    run(*batch(options.build, jobs, folder / "whole"), statuses=(1,))
    took = time.perf_counter() - started
    print(f"{options.pairs} pairs in one go: {took:.1f} s", flush=True)
    whole = outputs_of(folder / "matches")
    assert len(whole) == -(-options.pairs // OUTPUT_EVERY)

    chance, counts, longest = random.Random(options.seed), None, 1.6 * took / options.kills
    while counts is None:  # ended before the last kill: shorter runs
        shutil.rmtree(folder / "killed", ignore_errors=True)
        shutil.rmtree(folder / "matches")
        (folder / "matches").mkdir()
        counts = kill_at_random(options.build, jobs, folder / "killed", options.kills, longest, chance)
        longest *= 0.75
    print(f"killed {options.kills} times; pairs recorded by then: {', '.join(map(str, counts))}", flush=True)
    assert not (folder / "killed" / "results.jsonl").exists()
    run(*batch(options.build, jobs, folder / "killed"), statuses=(1,))
    same_results(folder / "whole", folder / "killed", "killed and resumed")
    assert outputs_of(folder / "matches") == whole, "other match files"

    for shard in (1, 2, 3):
        run(*batch(options.build, jobs, folder / f"shard {shard}", "--shard", f"{shard}/3", "--threads", "1"), statuses=(0, 1))
    run(options.build / "quadmatch", "batch-merge", *(folder / f"shard {shard}" for shard in (3, 1, 2)), "-o",
        folder / "merged", statuses=(1,))
    same_results(folder / "whole", folder / "merged", "shards merged")
    print("resumed and merged results are those of the unbroken run, byte by byte")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--pairs", type=int, default=10_000)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only-make", type=pathlib.Path, help="write the pairs and jobs.csv here, and end")
    options = parser.parse_args()
    options.build = options.build.resolve()
    if options.only_make:
        make_jobs(options, options.only_make)
        return
    with tempfile.TemporaryDirectory() as folder:
        test(options, pathlib.Path(folder))


if __name__ == "__main__":
    main()
