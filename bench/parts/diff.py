"""Differences by parts: single edits of real meshes named for what they are, no difference in a renumbered copy, posing told
as moved vertices only; and what naming costs beside matching."""
import json
import pathlib
import statistics
import subprocess
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, keep, kept, measured_run, run, table
from parts.subjects import edited_copy, in_parallel, name_of, quality_meshes

# One edit each, and the names that are right for it. A case is right if it has changes and each of them has such a name.
#   collapse:  the faces around a quad are joined where it was.
#   handle:    two quads give way to a tube between them.
#   twist:     both sides of a ring are joined otherwise.
# An edit that leaves the same mesh as before, as a twist between two symmetric parts does, is no case.
EDITS = {"delete:20": {"deletion"}, "extrude:12": {"extrusion"}, "collapse:1": {"collapse"}, "rip:6": {"rip"},
         "refine:9": {"refinement"}, "loop:1": {"inserted loop"}, "unloop:1": {"removed loop"}, "twist:1": {"re-attachment"},
         "handle:1": {"bridge"}}
SEEDS = (1, 2, 3, 4, 5)
POSES = ("bend", "turn", "noise", "sculpt")
LEAST_RIGHT = 0.95
MOST_OF_MATCH = 3
REPETITIONS = 5


def compared(options, source, target, *more):
    """The differences as the program tells them."""
    command = [options.program, "diff", source, target, "--json", "--quiet", *more]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(map(str, command))}: {ended.stderr.strip()[-200:]}")
    figures = json.loads(ended.stdout)
    if (ended.returncode == 0) != figures["same"]:
        raise RuntimeError(f"{' '.join(map(str, command))}: the exit status is not what the figures say")
    return figures


def measure_case(job):
    options, mesh, edit, seed, poses = job
    row = {"mesh": name_of(mesh), "edit": edit, "seed": seed, "pose": " ".join(poses)}
    try:
        with edited_copy(mesh, [edit] if edit else [], seed, poses) as (source, target, _):
            if edit and subprocess.run([options.program, "diff", source, target, "--isomorphic", "--quiet"], check=False).returncode == 0:
                return row | {"skipped": "the edit left the same mesh"}
            figures = compared(options, source, target)
            names = [change["kind"] for change in figures["changes"]]
            return row | {"names": {name: names.count(name) for name in sorted(set(names))}, "same": figures["same"],
                          "moved": figures["totals"]["vertices"]["moved"], "vertices": figures["source"]["vertices"]}
    except LookupError as error:
        return row | {"skipped": str(error)}


def is_right(row):
    names = set(row["names"])
    if row["edit"]:
        return bool(names) and names <= EDITS[row["edit"]]
    return not names and (row["moved"] > 0 if row["pose"] else row["same"])


def measure_speed(options):
    """quadmatch diff and quadmatch match on a bear refined to about 100,000 quads, and on an edited copy of that."""
    with tempfile.TemporaryDirectory() as folder:
        source, target = pathlib.Path(folder, "a.obj"), pathlib.Path(folder, "b.obj")
        run([options.build / "edit_mesh", ROOT / "examples" / "bear.obj", source, f"subdivide:{1 if options.quick else 3}"])
        run([options.build / "edit_mesh", source, target, "delete:200", "loop:1", "extrude:50", "renumber", "--seed", 7])
        times = {"match": [], "diff": []}
        for _ in range(REPETITIONS):
            for verb, more in (("match", ["-o", pathlib.Path(folder, "m.json"), "--quiet"]), ("diff", ["--json"])):
                times[verb].append(measured_run([options.program, verb, source, target, *more]).processor_seconds)
        figures = compared(options, source, target)
    return {"faces": figures["source"]["faces"], "match": statistics.median(times["match"]),
            "diff": statistics.median(times["diff"])}


def measure(options):
    meshes = quality_meshes(options)
    seeds = SEEDS[:1] if options.quick else SEEDS
    jobs = [(options, mesh, edit, seed, ()) for edit in ("", *EDITS) for mesh in meshes for seed in seeds]
    jobs += [(options, mesh, "", seeds[0], (pose,)) for pose in POSES for mesh in meshes]
    keep(options, "diff.json", {"cases": in_parallel(options, measure_case, jobs), "speed": measure_speed(options)})


def measured(figures, edit=None, pose=""):
    """The cases of one edit, or of all; renumbered copies are those without an edit and a pose."""
    return [row for row in figures["cases"] if "names" in row and row["pose"] == pose
            and (row["edit"] == edit if edit is not None else row["edit"])]


def share_right(rows):
    return sum(map(is_right, rows)) / max(1, len(rows))


def bars(options):
    figures = kept(options, "diff.json")
    if not figures:
        return []
    single, same = measured(figures), measured(figures, "")
    posed = [row for pose in POSES for row in measured(figures, "", pose)]
    speed = figures["speed"]
    return [Bar(f"diff: single edits named rightly, of {len(single)}", share_right(single), LEAST_RIGHT),
            Bar(f"diff: renumbered copies without a difference, of {len(same)}", share_right(same), 1),
            Bar(f"diff: posed copies with moved vertices only, of {len(posed)}", share_right(posed), 1),
            Bar(f"diff: its time over that of match, {speed['faces']:,} faces", speed["diff"] / speed["match"], MOST_OF_MATCH,
                at_most=True)]


def described(rows):
    """What wrong cases were called."""
    wrong = [f"{row['mesh']} {row['seed']}: " + (", ".join(f"{count} {name}" for name, count in row["names"].items()) or "nothing")
             for row in rows if not is_right(row)]
    return "; ".join(wrong[:4]) + (f"; {len(wrong) - 4} more" if len(wrong) > 4 else "")


def page(options):
    figures = kept(options, "diff.json")
    if not figures:
        return []
    lines = []
    for edit, names in EDITS.items():
        rows = measured(figures, edit)
        lines.append([edit, ", ".join(sorted(names)), len(rows), sum(map(is_right, rows)), described(rows)])
    lines.append(["renumber", "no differences", len(measured(figures, "")), sum(map(is_right, measured(figures, ""))),
                  described(measured(figures, ""))])
    for pose in POSES:
        rows = measured(figures, "", pose)
        lines.append([pose, "moved vertices only", len(rows), sum(map(is_right, rows)), described(rows)])
    speed = figures["speed"]
    return ["\n## Differences by parts\n",
            f"{command_line('diff')}. One edit each in renumbered copies of the meshes, compared by `quadmatch diff`. A case is "
            "right if all its changes bear the right name.\n",
            table(["edit", "right name", "cases", "right", "wrong ones"], lines),
            f"\nOf an edited and renumbered bear of {speed['faces']:,} faces `quadmatch diff --json` takes {speed['diff']:.2f} s of the "
            f"processor, `quadmatch match` {speed['match']:.2f} s.\n",
            "\n" + bar_table(bars(options))]
