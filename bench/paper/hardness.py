"""Theorems 3.1 and 3.2: graphs as meshes, and what becomes of the question whether 7n quads match."""
import json
import os
import subprocess

from parts.common import Bar, bar_table, run, table
from parts.subjects import in_parallel

TITLE = "Is the graph Hamiltonian?"
INTRODUCTION = ("Theorem 3.1: a ring of 8n quads, M₁, and a cubic planar graph of n vertices as a mesh, M₂. 7n quads match in one "
                "region exactly when the graph is Hamiltonian. Theorem 3.2 asks whether they do.")

# Graphs, and how long the exact search may take; tutte is there for the heuristics.
SECONDS = {"k4": 30, "prism": 30, "cube": 30, "bridged": 60, "truncated-tetrahedron": 60, "three-branches": 120,
           "dodecahedron": 60, "tutte": 20}
QUICK = ("k4", "prism")
HEURISTICS = ("greedy", "lazy-greedy", "regions")
ANSWERS = {0: "yes", 1: "no", 3: "unknown"}


def run_cpu(command):
    """Exit status, standard output and processor seconds of a command."""
    with subprocess.Popen([str(word) for word in command], stdout=subprocess.PIPE) as child:
        out = child.stdout.read()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, out, usage.ru_utime + usage.ru_stime


def report(options, row, more, statuses):
    folder = options.build / "gadgets"
    status, out, seconds = run_cpu([options.program, "match", folder / f"{row['name']}-source.obj",
                                    folder / f"{row['name']}-target.obj", "-o", os.devnull, "--json", "--quiet", *more])
    if status not in statuses:
        raise SystemExit(f"quadmatch match of {row['name']} ended with status {status}")
    return status, json.loads(out), seconds


def solve(job):
    options, row = job
    status, told, seconds = report(options, row, ["--algorithm", "exact", "--at-least", row["asked"], "--time-limit",
                                                  SECONDS[row["name"]]], (0, 1, 3))
    solved = {**row, "answer": ANSWERS[status], "largest": told["matched_faces"], "bound": told["optimality"]["bound"],
              "nodes": told["optimality"]["nodes"], "cpu_seconds": round(seconds, 2)}
    for name in HEURISTICS:
        solved[name] = max((region["faces"] for region in report(options, row, ["--algorithm", name], (0, 1))[1]["regions"]),
                           default=0)
    return solved


def measure(options):
    made = run([options.build / "make_instances", "gadgets", options.build / "gadgets", "--graph",
                *(QUICK if options.quick else SECONDS)])
    rows = [json.loads(line) for line in made.splitlines()]
    return {"rows": in_parallel(options, solve, [(options, row) for row in rows])}


def bars(raw):
    settled = [row for row in raw["rows"] if row["answer"] != "unknown"]
    right = sum((row["answer"] == "yes") == row["hamiltonian"] for row in settled)
    return [Bar("answers that are as the theorem says, of those given", right / max(1, len(settled)), 1.0)]


def page(raw):
    rows = raw["rows"]
    lines = [[row["name"], row["n"], "yes" if row["hamiltonian"] else "no", row["source"], row["target"], row["asked"],
              row["answer"], f"{row['nodes']:,}", f"{row['cpu_seconds']:.1f}", row["largest"]] + [row[name] for name in HEURISTICS]
             for row in rows]
    settled = sum(row["answer"] != "unknown" for row in rows)
    return [bar_table(bars(raw)),
            "\nGraphs by name, written as meshes by `make_instances gadgets`; asked by `quadmatch match --algorithm exact "
            "--at-least 7n` with a time limit; one thread, processor seconds. *Seen*: the largest region that the search saw "
            "before it had its answer. Behind it the largest region of each of the other algorithms, from anchors of their own: "
            "in these meshes hardly a place is told from others, and regions finds none to begin from.\n",
            table(["graph", "n", "Hamiltonian", "M₁", "M₂", "7n", "7n match", "nodes", "s", "seen", *HEURISTICS], lines),
            f"\n{settled} of {len(rows)} are settled in time.\n"]
