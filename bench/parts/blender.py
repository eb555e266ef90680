"""The Blender add-on: a match of two of Blender's meshes beside the library's own, in the same run."""
import json
import os
import shutil
import statistics
import subprocess
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, keep, kept, table
from parts.python import KINDS, MESH, RUNS, TURNS, library_times

MOST = 1.5


def blender_times(archive, mesh):
    """What bench/blender_match.py measures, in a Blender with settings of its own."""
    with tempfile.TemporaryDirectory() as folder:
        # Debian's Blender looks for Python's modules beside the first python3 on PATH.
        environment = os.environ | {"BLENDER_USER_SCRIPTS": folder, "BLENDER_USER_CONFIG": folder, "PATH": "/usr/bin:/bin"}
        command = ["blender", "-b", "--factory-startup", "--python-exit-code", "3", "--python", ROOT / "bench" / "blender_match.py", "--",
                   archive, mesh, str(RUNS)]
        ended = subprocess.run([str(word) for word in command], env=environment, check=False, capture_output=True, text=True)
    if ended.returncode:
        raise SystemExit(f"blender ended with status {ended.returncode}: {(ended.stdout + ended.stderr)[-1000:]}")
    output = ended.stdout
    return json.loads(next(line for line in output.splitlines() if line.startswith("result ")).removeprefix("result "))


def measure(options):
    archives = sorted((ROOT / "build" / "blender").glob("quadmatch-*.zip"))
    if not archives or not shutil.which("blender"):
        print("blender: skipped, there is no Blender or the add-on is not built (scripts/build_blender.sh)")
        return
    mesh = options.meshes / MESH
    rows = {kind: {"library": [], "blender": [], "operator": []} for kind in KINDS}
    for _ in range(2 if options.quick else TURNS):
        library = library_times(options, mesh)
        blender = blender_times(archives[0], mesh)
        for kind, row in rows.items():
            row["library"].append(library[kind])
            row["blender"].append(statistics.median(blender[kind]["ms"]))
            row["operator"].append(statistics.median(blender[kind]["operator"]))
            row |= {"faces": blender["faces"], "matched": blender[kind]["matched"]}
    keep(options, "blender.json", rows)


def medians(row):
    """Milliseconds: the library making meshes and matching them, the match in Blender, the whole operator."""
    return [statistics.median(row["library"]), statistics.median(row["blender"]),
            statistics.median(row["operator"])]


def ratio(row):
    library, blender, _ = medians(row)
    return blender / library


def bars(options):
    figures = kept(options, "blender.json") or {}
    return [Bar(f"match in Blender: of the library's time, a copy {KINDS[kind]}", ratio(row), MOST, at_most=True)
            for kind, row in figures.items()]


def page(options):
    figures = kept(options, "blender.json")
    if not figures:
        return []
    faces = next(iter(figures.values()))["faces"]
    lines = [[f"a copy {KINDS[kind]}", f"{row['matched']:,}", *(f"{ms:.2f}" for ms in medians(row)), f"{ratio(row):.2f}"]
             for kind, row in figures.items()]
    return ["\n## Blender\n",
            f"{command_line('blender')}, after `scripts/build_blender.sh`. A body of {faces:,} quads is matched by the add-on, from two meshes of "
            "Blender to a match that has been verified, beside the library, which makes two meshes from arrays of its own and matches them. "
            "*Operator* is the button: it looks at what may be changed, colours both objects and keeps the match besides. "
            "Milliseconds of processor time, medians.\n",
            table(["", "matched", "library", "Blender: match", "operator", "ratio"], lines),
            "\n" + bar_table(bars(options))]
