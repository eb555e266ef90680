"""The whole command on a million quads: peak of its memory, and its time against that of reading the two files."""
import json
import pathlib
import statistics
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, conditions, keep, kept, measured_run, run, table

MOST_BYTES = 400
MOST_TIMES_READING = 2.5
REPETITIONS = 3


def subjects(options):
    """A mesh and how often to refine it, for about a million quads."""
    found = {"bear": (ROOT / "examples" / "bear.obj", 4)}
    if options.meshes.is_dir():
        found["male_generic body"] = (options.meshes / "pairs/mh_male_generic_muscle/a.obj", 3)
    return {name: (mesh, 1 if options.quick else steps) for name, (mesh, steps) in found.items()}


def measure_subject(options, mesh, steps):
    with tempfile.TemporaryDirectory() as folder:
        source, target, output = (pathlib.Path(folder, name) for name in ("a.obj", "b.obj", "m.json"))
        edit = options.build / "edit_mesh"
        run([edit, mesh, source, f"subdivide:{steps}"])
        run([edit, source, target, "renumber"])
        runs = []
        for _ in range(REPETITIONS):
            took = measured_run([options.program, "match", source, target, "-o", output, "--json", "--quiet", "--threads", 1])
            told = json.loads(took.output)
            runs.append({"wall": took.milliseconds, "peak": took.peak, **told["milliseconds"]})
        return {"faces": told["source"]["faces"], "matched": told["matched_faces"],
                "megabytes read": (source.stat().st_size + target.stat().st_size) / 1e6, "runs": runs}


def measure(options):
    figures = {"conditions": conditions(options), "subjects": {}}
    for name, (mesh, steps) in subjects(options).items():
        figures["subjects"][name] = measure_subject(options, mesh, steps)
    keep(options, "memory.json", figures)


def median(subject, key):
    return statistics.median(row[key] for row in subject["runs"])


def bars(options):
    found = []
    for name, subject in (kept(options, "memory.json") or {"subjects": {}})["subjects"].items():
        found.append(Bar(f"whole command, {name}: peak memory, bytes a face of one mesh",
                         median(subject, "peak") / subject["faces"], MOST_BYTES, at_most=True))
        found.append(Bar(f"whole command, {name}: time / reading both files",
                         median(subject, "wall") / median(subject, "reading"), MOST_TIMES_READING, at_most=True))
    return found


def page(options):
    figures = kept(options, "memory.json")
    if not figures:
        return []
    stages = ["reading", "matching", "verifying", "writing", "wall"]
    rows = [[name, f"{subject['faces']:,}", f"{subject['matched']:,}", *(f"{median(subject, key):,.0f}" for key in stages),
             f"{median(subject, 'peak') / 1e6:,.0f}", f"{median(subject, 'peak') / subject['faces']:.0f}"]
            for name, subject in figures["subjects"].items()]
    return ["\n## The whole command\n",
            f"{command_line('memory')}. `quadmatch match A B -o M --threads 1`, from two OBJ files to a match file; B is A in "
            f"random order. Medians of {REPETITIONS} runs, in milliseconds on the clock; *peak* is the most resident memory, "
            f"in megabytes and in bytes a face of one mesh. {figures['conditions']['cpu']}, "
            f"{figures['conditions']['version']} at {figures['conditions']['commit']}.\n",
            table(["mesh", "faces", "matched", *stages[:-1], "all", "peak", "bytes a face"], rows),
            "\n" + bar_table(bars(options))]
