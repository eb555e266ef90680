#!/usr/bin/env python3
"""Many pairs in a Python pipeline: match the pairs of a CSV file on the workers of a dask cluster.

usage: cluster/dask_pairs.py PAIRS.csv OUT.jsonl [--scheduler ADDRESS] [--workers N] [--chunk N]

PAIRS.csv has the columns source and target, relative to its own folder. OUT.jsonl gets one line for each, in the same
order. Without --scheduler the workers are processes on this machine; with it, workers elsewhere need the package
quadmatch and the same files. Take this as a beginning: put what you do with a match into `look_at`.

For pairs of files and nothing else, `quadmatch batch` needs less and can be killed and resumed.
"""
import argparse
import csv
import json
import os
import pathlib

import distributed
import quadmatch


def look_at(source, target):
    """What is wanted of a pair. Runs on a worker."""
    match = quadmatch.match(quadmatch.read(source), quadmatch.read(target))
    return {"matched_faces": match.matched_faces,
            "regions": len(match.regions),
            "ambiguous_faces": sum(len(region) for region in match.regions if region.ambiguous),
            "unmatched_source_faces": int((match.face_map < 0).sum())}


def look_at_chunk(pairs):
    """A few pairs after each other, so that they outweigh a task. A pair that fails is an answer as well."""
    rows = []
    for source, target in pairs:
        try:
            rows.append({"source": source, "target": target, "error": None, **look_at(source, target)})
        except (OSError, ValueError) as error:
            rows.append({"source": source, "target": target, "error": str(error)})
    return rows


def read_pairs(path):
    with open(path, newline="", encoding="utf-8-sig") as file:
        return [(str(path.parent / row["source"]), str(path.parent / row["target"])) for row in csv.DictReader(file)]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pairs", type=pathlib.Path)
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--scheduler", help="address of a dask scheduler, such as tcp://head:8786")
    parser.add_argument("--workers", type=int, default=os.cpu_count())
    parser.add_argument("--chunk", type=int, default=100, help="pairs of a task")
    options = parser.parse_args()

    pairs = read_pairs(options.pairs)
    chunks = [pairs[first:first + options.chunk] for first in range(0, len(pairs), options.chunk)]
    own = {} if options.scheduler else {"n_workers": options.workers, "threads_per_worker": 1, "dashboard_address": None}
    with distributed.Client(options.scheduler, **own) as client:
        rows = [row for chunk in client.gather(client.map(look_at_chunk, chunks, pure=False)) for row in chunk]
    options.output.write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")
    print(f"{len(rows)} pairs, {sum(row['error'] is not None for row in rows)} failed: {options.output}")


if __name__ == "__main__":
    main()
