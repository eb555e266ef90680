#!/usr/bin/python3
"""Regenerate every table and figure of the paper, and what is proved or bounded beyond it, into docs/paper/.

usage: bench/paper/run.py [--only PART,...] [--meshes FOLDER] [--tools FOLDER] [--build FOLDER] [--docs FOLDER] [--jobs N] [--quick]

Needs a release build (cmake --preset release -DQUADMATCH_DEVELOPER=ON && cmake --build --preset release) and Debian's
python3-matplotlib. Where the collection of real meshes stands beside the project, its meshes are in the tables too. Raw
figures are kept in docs/paper/results/; `--only ''` writes the pages anew from them and measures nothing. `--quick --docs
build/quick` tries parts on little.
"""
import pathlib
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from paper import PARTS
from parts.common import ROOT, bar_table, conditions, keep, kept, parse, table


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
    chosen, options = parse(arguments, __doc__, PARTS, ROOT / "docs" / "paper")
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
