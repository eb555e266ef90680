"""What the uses of a match cost beside the match alone: whole commands on files of a hundred thousand quads, in one run."""
import pathlib
import random
import statistics
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, conditions, keep, kept, measured_run, run, table

REPETITIONS = 5
STEPS = 3  # 1,944 quads become 124,416
MOST = 3

# Verbs and what they do to BASE, OURS and THEIRS; a program that lacks one does not run it.
COMMANDS = {
    "match": ["match", "base.obj", "ours.obj", "-o", "m.json"],
    "transfer": ["transfer", "base.obj", "ours.obj", "-o", "t.obj", "--only", "positions"],
    "diff": ["diff", "base.obj", "ours.obj"],
    "merge": ["merge", "base.obj", "ours.obj", "theirs.obj", "-o", "merged.obj"],
    "match, mirrored": ["match", "base.obj", "base.obj", "--orientation", "reversing", "-o", "m.json"],
    "symmetry": ["symmetry", "base.obj", "-o", "map.json"],
}
# What each is measured by: a mirror is sought in the match of a mesh with itself turned over.
MATCH = {"transfer": "match", "diff": "match", "merge": "match", "symmetry": "match, mirrored"}


def write_meshes(options, folder):
    edit_mesh = options.build / "edit_mesh"
    source = ROOT / "examples" / "shirt_long.obj"
    run([edit_mesh, source, folder / "base.obj", f"subdivide:{1 if options.quick else STEPS}"])
    run([edit_mesh, folder / "base.obj", folder / "ours.obj", "delete:200", "--seed", 1])
    run([edit_mesh, folder / "base.obj", folder / "theirs.obj", "extrude:200", "--seed", 2])


def seconds(options, verb, folder):
    """Processor time of the command and of nothing else."""
    return measured_run([options.program, *COMMANDS[verb], "--quiet"], folder=folder).processor_seconds


def measure(options):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_meshes(options, folder)
        quads = sum(line.startswith("f ") for line in open(folder / "base.obj", encoding="utf-8"))
        times = {verb: [] for verb in COMMANDS}
        order = [verb for verb in COMMANDS for _ in range(1 if options.quick else REPETITIONS)]
        random.Random(1).shuffle(order)
        for verb in order:
            print("  $", *COMMANDS[verb], flush=True)
            times[verb].append(seconds(options, verb, folder))
    keep(options, "uses_speed.json", {"conditions": conditions(options), "quads": quads, "seconds": times})


def measured(figures):
    """The median of each verb that ran."""
    return {verb: statistics.median(times) for verb, times in figures["seconds"].items()}


def bars(options):
    figures = kept(options, "uses_speed.json")
    if not figures:
        return []
    found = measured(figures)
    return [Bar(f"{verb}, processor time of the whole command, by that of match on the same files",
                found[verb] / found[MATCH[verb]], MOST, at_most=True) for verb in found if verb in MATCH]


def page(options):
    figures = kept(options, "uses_speed.json")
    if not figures:
        return []
    where, found = figures["conditions"], measured(figures)
    rows = [[f"`quadmatch {' '.join(COMMANDS[verb])}`", f"{1000 * time:,.0f}", f"{time / found[MATCH[verb]]:.2f}" if verb in MATCH else ""]
            for verb, time in found.items()]
    missing = [verb for verb in COMMANDS if verb not in found]
    return ["\n## What the uses cost\n",
            f"{command_line('uses_speed')}. A shirt of {figures['quads']:,} quads; *ours* lacks a patch of 200, in *theirs* one is "
            f"lifted. Processor time of whole commands, reading and writing included: medians of {REPETITIONS}, in random order; "
            f"{where['cpu']}, {where['compiler']}, {where['version']} at {where['commit']}."
            + (f" Not there yet, or in trouble: {', '.join(missing)}." if missing else "") + "\n",
            table(["command", "ms", "by match"], rows), "\n" + bar_table(bars(options))]
