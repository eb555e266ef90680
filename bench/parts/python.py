"""The Python package: a match of four arrays beside the library's own, in the same run."""
import json
import statistics
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, keep, kept, run, table

MESH = "pairs/mh_male_generic_muscle/a.obj"
ENVIRONMENT = ROOT / "build" / "python" / "env" / "bin" / "python"  # of scripts/build_python.sh
TURNS = 9  # both programs in turn, so that both meet the same machine
RUNS = 20  # matches in a turn
KINDS = {"from-arrays-in-file-order": "in the same order", "from-arrays": "in random order"}
MOST = 1.2


def library_times(options, mesh):
    """Milliseconds from arrays to the match, by kind."""
    with tempfile.TemporaryDirectory() as folder:
        output = run([options.build / "bench" / "quadmatch_bench", mesh, 0, folder, "--benchmark_format=json",
                      "--benchmark_filter=^from-arrays", "--benchmark_min_time=0.2"])
    return {row["name"].split("/")[0]: row["cpu_time"] for row in json.loads(output)["benchmarks"]}


def measure(options):
    if not ENVIRONMENT.exists():
        print("python: skipped, the package is not built (scripts/build_python.sh)")
        return
    mesh = options.meshes / MESH
    rows = {kind: {"library": [], "python": []} for kind in KINDS}
    for _ in range(2 if options.quick else TURNS):
        library = library_times(options, mesh)
        python = json.loads(run([ENVIRONMENT, ROOT / "bench" / "python_match.py", mesh, RUNS]))
        for kind, row in rows.items():
            row["library"].append(library[kind])
            row["python"].append(statistics.median(python[kind]["ms"]))
            row |= {"faces": python["faces"], "matched": python[kind]["matched"]}
    keep(options, "python.json", rows)


def medians(row):
    """Milliseconds of the library, and from Python."""
    return statistics.median(row["library"]), statistics.median(row["python"])


def ratio(row):
    library, python = medians(row)
    return python / library


def bars(options):
    figures = kept(options, "python.json") or {}
    return [Bar(f"match from Python: of the library's time, a copy {KINDS[kind]}", ratio(row), MOST, at_most=True)
            for kind, row in figures.items()]


def page(options):
    figures = kept(options, "python.json")
    if not figures:
        return []
    faces = next(iter(figures.values()))["faces"]
    lines = []
    for kind, row in figures.items():
        lines.append([f"a copy {KINDS[kind]}", f"{row['matched']:,}", *(f"{ms:.2f}" for ms in medians(row)), f"{ratio(row):.2f}"])
    return ["\n## Python\n",
            f"{command_line('python')}, after `scripts/build_python.sh`. A body of {faces:,} quads is matched by "
            "`quadmatch.match(V1, F1, V2, F2)`, from NumPy's arrays of 64-bit numbers to a match that has been verified, beside the "
            "library, which makes two meshes from arrays of its own and matches them. Milliseconds of processor time, medians.\n",
            table(["", "matched", "library", "Python", "ratio"], lines),
            "\n" + bar_table(bars(options))]
