"""Versions of real models, of which some faces are known to be the same."""
import re
import sys

from parts.common import Bar, bar_table, keep, kept, run
from parts.subjects import pair_folders

LEAST_RECALL = 0.998


def measure(options):
    lines = {}
    for algorithm in ("regions", "lazy-greedy", "greedy"):
        output = run([sys.executable, options.tools / "real_pairs.py", "--matcher",
                      f"{options.program} match {{a}} {{b}} -o {{m}} --quiet --algorithm {algorithm}", *pair_folders(options)], statuses=(0, 1))
        lines[algorithm] = output.splitlines()
    keep(options, "pairs.json", lines)


def bars(options):
    recalls = {line.split()[0]: re.search(r"recall ([\d.]+)", line) for line in (kept(options, "pairs.json") or {}).get("regions", [])}
    known = {name: float(found[1]) for name, found in recalls.items() if found}
    worst = min(known, key=known.get, default=None)
    return [Bar(f"real pairs: recall, the worst ({worst})", known[worst], LEAST_RECALL)] if known else []


def page(options):
    lines = kept(options, "pairs.json")
    if not lines:
        return []
    page = ["\n## Real pairs\n", "Versions of real models; *known* are the faces whose partner positions tell.\n"]
    for algorithm, output in lines.items():
        page += [f"\n`--algorithm {algorithm}`\n", "```text", *output, "```"]
    return page + ["\n" + bar_table(bars(options))]
