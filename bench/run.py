#!/usr/bin/python3
"""Measure quadmatch and write docs/results.md, with the raw figures and the plots beside it in docs/results/.

usage: bench/run.py [--only PART,...] [--meshes FOLDER] [--tools FOLDER] [--build FOLDER] [--docs FOLDER] [--jobs N] [--quick]

Needs a release build (cmake --preset release -DQUADMATCH_DEVELOPER=ON && cmake --build --preset release). Speed and memory
are measured on our own bear and, where the collection of real meshes stands beside the project, on a body of it; the other
parts need that collection and its tools. Parts that are not run keep their last raw figures: `--only ''` writes the page
and the plots anew and measures nothing. `--quick --docs build/quick` tries parts on little.
"""
import sys

from parts import (ablation, batch, blender, ceilings, diff, edited, find, invariance, memory, merge, multi, pairs,
                   pictures, plots, posed, python, quality, regions, report, skeleton, speed, symmetry, transfer, unrelated,
                   uses_speed, web)
from parts.common import ROOT, bar_table, parse
from parts.tried import tried

# In the order of the page.
PARTS = {"speed": speed, "edited": edited, "memory": memory, "skeleton": skeleton, "quality": quality, "regions": regions,
         "ceilings": ceilings, "ablation": ablation, "pairs": pairs, "posed": posed, "multi": multi, "unrelated": unrelated,
         "transfer": transfer, "diff": diff, "merge": merge, "symmetry": symmetry, "uses_speed": uses_speed,
         "report": report, "pictures": pictures, "web": web, "python": python, "blender": blender, "batch": batch,
         "find": find, "invariance": invariance}
WITHOUT_COLLECTION = ("speed", "memory", "skeleton", "uses_speed", "report", "web", "batch", "pictures", "find")


def write_page(options):
    page = ["# Results\n", "Every figure on this page was made by `bench/run.py`, which also keeps the raw ones in "
            "`docs/results/`. Run it again after `cmake --preset release && cmake --build --preset release`.\n"]
    bars = [bar for part in PARTS.values() for bar in part.bars(options)]
    missed = [bar for bar in bars if bar.missed_by]
    if bars:
        page.append(f"{len(bars) - len(missed)} of {len(bars)} bars are met." + (" Missed are:\n" if missed else "\n"))
        page.append(bar_table(missed))
        page += tried(missed)
    for part in PARTS.values():
        page += part.page(options)
    options.docs.mkdir(parents=True, exist_ok=True)
    (options.docs / "results.md").write_text("\n".join(page).rstrip() + "\n", encoding="utf-8")


def main(arguments):
    chosen, options = parse(arguments, __doc__, PARTS, ROOT / "docs")
    sys.path.insert(0, str(options.tools))
    for name in chosen:
        if name not in WITHOUT_COLLECTION and not options.collection:
            print(f"{name}: skipped, no collection of meshes at {options.meshes}")
            continue
        print(name, flush=True)
        PARTS[name].measure(options)
    plots.draw_all(options)
    write_page(options)


if __name__ == "__main__":
    main(sys.argv[1:])
