"""Theorems 3.1 and 3.2: graphs as meshes, and what becomes of the question whether 7n quads match."""
import concurrent.futures
import json
import os
import pathlib
import subprocess

# Graphs, and how long the exact search may take; tutte is there for the heuristics.
SECONDS = {"k4": 30, "prism": 30, "cube": 30, "bridged": 60, "truncated-tetrahedron": 60, "three-branches": 200,
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
    folder = pathlib.Path(options.build) / "gadgets"
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
    made = subprocess.run([str(pathlib.Path(options.build) / "make_instances"), "gadgets",
                           str(pathlib.Path(options.build) / "gadgets"), "--graph", *(QUICK if options.quick else SECONDS)],
                          check=True, capture_output=True, text=True).stdout
    rows = [json.loads(line) for line in made.splitlines()]
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        return {"rows": list(pool.map(solve, [(options, row) for row in rows]))}


def table(header, rows):
    cells = [header, ["---"] + ["---:"] * (len(header) - 1)] + rows
    return "\n".join("| " + " | ".join(str(cell) for cell in row) + " |" for row in cells) + "\n"


def page(raw):
    rows = raw["rows"]
    lines = [[row["name"], row["n"], "yes" if row["hamiltonian"] else "no", row["source"], row["target"], row["asked"],
              row["answer"], f"{row['nodes']:,}", f"{row['cpu_seconds']:.1f}", row["largest"]] + [row[name] for name in HEURISTICS]
             for row in rows]
    settled = [row for row in rows if row["answer"] != "unknown"]
    right = sum((row["answer"] == "yes") == row["hamiltonian"] for row in settled)
    return ["\n## Is the graph Hamiltonian?\n",
            "Theorem 3.1's meshes of named cubic planar graphs, written by `make_instances gadgets`: 7n quads of M₁ match "
            "in one region exactly when the graph is Hamiltonian. Asked by `quadmatch match --algorithm exact --at-least "
            "7n`, with a time limit; one thread, processor seconds. *Largest*: the largest region seen on the way, which "
            "ends at the answer. Behind it the largest region of each of the other algorithms, from anchors of their own.\n",
            table(["graph", "n", "Hamiltonian", "M₁", "M₂", "7n", "7n match", "nodes", "s", "largest", *HEURISTICS], lines),
            f"\n{len(settled)} of {len(rows)} settled, {right} of these as the theorem says.\n"]
