#!/usr/bin/env python3
"""Regenerate every table and figure of the paper, and what is proved or bounded beyond it, into docs/paper/.

usage: bench/paper/run.py [--only PART,...] [--meshes FOLDER] [--tools FOLDER] [--build FOLDER] [--docs FOLDER] [--jobs N] [--quick]

Needs a release build (cmake --preset release -DQUADMATCH_DEVELOPER=ON && cmake --build --preset release) and Debian's
python3-matplotlib. Where the collection of real meshes stands beside the project, its meshes are in the tables too. Raw
figures are kept in docs/paper/results/; `--only ''` writes the pages anew from them and measures nothing. `--quick --docs
build/quick` tries parts on little.
"""
import argparse
import os
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from paper import PARTS
from parts.common import ROOT, Options, bar_table, conditions, keep, kept, table


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", default=",".join(PARTS))
    parser.add_argument("--meshes", type=pathlib.Path, default=ROOT.parent / "shared" / "meshes")
    parser.add_argument("--tools", type=pathlib.Path, default=ROOT.parent / "shared" / "tools")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build" / "release")
    parser.add_argument("--docs", type=pathlib.Path, default=ROOT / "docs" / "paper")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="pairs at a time")
    parser.add_argument("--quick", action="store_true", help="few meshes, few seeds")
    parsed = vars(parser.parse_args(arguments))
    chosen = [name for name in parsed.pop("only").split(",") if name]
    for name in chosen:
        if name not in PARTS:
            parser.error(f"no such part: {name}; there are {', '.join(PARTS)}")
    return chosen, Options(**parsed)


def measure(options, name):
    begin = time.monotonic()
    print(f"== {name}", flush=True)
    raw = PARTS[name].measure(options)
    keep(options, f"{name}.json", {"conditions": conditions(options), "minutes": round((time.monotonic() - begin) / 60, 2),
                                   "figures": raw})


def write_page(options, name):
    kept_raw = kept(options, f"{name}.json")
    if kept_raw is None:
        return
    part, told = PARTS[name], kept_raw["conditions"]
    lines = [f"# {part.TITLE}\n", part.INTRODUCTION + "\n",
             f"Made by `bench/paper/run.py --only {name}`: {told['version']} at {told['commit']}, {told['cpu']}, "
             f"{told['compiler']}.\n"] + part.page(kept_raw["figures"])
    (options.docs / f"{name}.md").write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")


def write_index(options):
    """What there is, which bars it meets, and how long it took."""
    raw = {name: kept(options, f"{name}.json") for name in PARTS}
    raw = {name: value for name, value in raw.items() if value is not None}
    bars = [bar for name, value in raw.items() if hasattr(PARTS[name], "bars") for bar in PARTS[name].bars(value["figures"])]
    lines = ["# The paper, reproduced\n",
             "Every table and figure of the paper from our own models and real ones, its hardness proof as meshes, its "
             "guarantee put to the test, and how far from the optimum each algorithm stays. `bench/paper/run.py` makes all "
             "of these pages and keeps the raw figures in `docs/paper/results/`. How we read the paper, and the test for "
             "each sentence, stands in [Reading the paper](../reading-the-paper.md).\n",
             table(["page", "what", "minutes"], [[f"[{PARTS[name].TITLE}]({name}.md)", PARTS[name].INTRODUCTION,
                                                  f"{value['minutes']:.1f}"] for name, value in raw.items()]),
             "\n" + bar_table(bars)]
    (options.docs / "index.md").write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")


def main(arguments):
    chosen, options = parse(arguments)
    if not options.program.exists():
        raise SystemExit(f"{options.program} is missing: cmake --preset release && cmake --build --preset release")
    sys.path.insert(0, str(options.tools))
    for name in chosen:
        measure(options, name)
    for name in PARTS:
        write_page(options, name)
    write_index(options)


if __name__ == "__main__":
    main(sys.argv[1:])
