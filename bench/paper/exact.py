"""The exact search: which edited patches and whole meshes it proves, in what time, and what bound is left otherwise."""
import collections
import json
import os
import pathlib
import random
import statistics
import subprocess

from parts.common import Bar, bar_table, table
from parts.subjects import in_parallel, tool

TITLE = "The largest region, proved"
INTRODUCTION = ("The problem is NP-hard, and still: for patches of hundreds of quads and whole meshes after one edit, exact "
                "search finds the largest region there is and proves it. [How it works](../design/011-exact.md).")

# Patches are discs of N faces around a random face of these.
MESHES = {"suit": "mh_male_casualsuit01", "duck": "tbm_duck_sculpture", "muscle": "pairs/mh_male_generic_muscle/a",
          "plate": "fe_plate_holes"}
WHOLE = {"rook": "osd_rook", "proxy": "mh_proxy741", "suzanne": "pmp_suzanne", "trex": "qt_trex"}
# Shares are of the faces, one face at least.
EDITS = {"delete": ["delete:3%"], "collapse": ["collapse:2"], "extrude": ["extrude:2%"], "rip": ["rip:4"], "loop": ["loop:1"],
         "refine": ["refine:2%"], "mix": ["collapse:1", "delete:2%", "extrude:1%"]}
WHOLE_EDITS = {"none": [], "collapse": ["collapse:2"], "rip": ["rip:4"], "delete": ["delete:3%"], "extrude": ["extrude:3%"],
               "loop": ["loop:1"]}
# Faces of a patch: seconds, seeds. Other seeds than those the search was tuned with; so many that a share is not
# decided by one run.
SIZES = {20: (10, (5, 6)), 40: (10, (5, 6)), 80: (10, (5, 6)), 120: (10, (5, 6)), 200: (10, tuple(range(5, 15))),
         400: (30, (5, 6))}
WHOLE_SECONDS, WHOLE_SEED = 30, 5
# What must be proved, and within how many seconds: shares of the runs.
BARS = {"patches of up to 120 faces": (lambda row: row["faces"] <= 120 and row["patch"], 0.99),
        "patches of 200 faces": (lambda row: row["faces"] == 200 and row["patch"], 0.97),
        "patches of 400 faces": (lambda row: row["faces"] == 400 and row["patch"], 0.85),
        "whole meshes after a deletion, rip or collapse": (
            lambda row: not row["patch"] and row["edit"] in ("none", "delete", "rip", "collapse"), 1.0)}


def sized(edits, faces):
    """Shares as numbers of faces."""
    def one(edit):
        name, _, size = edit.partition(":")
        return f"{name}:{max(1, round(faces * float(size[:-1]) / 100))}" if size.endswith("%") else edit
    return [one(edit) for edit in edits]


def patch(positions, faces, count, seed):
    """The `count` faces nearest to a random one, across edges, with the vertices they use."""
    across = tool("objmesh").manifold_adjacency(faces)
    start = random.Random(seed).randrange(len(faces))
    chosen, seen = [start], {start}
    for face in chosen:
        for corner in range(len(faces[face])):
            beside = across.get((face, corner))
            if beside and beside[0] not in seen and len(chosen) < count:
                seen.add(beside[0])
                chosen.append(beside[0])
    number = {}
    cut = [tuple(number.setdefault(vertex, len(number)) for vertex in faces[face]) for face in chosen]
    return [positions[vertex] for vertex in number], cut


def instance(folder, job):
    """Files of a mesh or patch and of its edited copy; None where no place was found for the edit."""
    name = f"{job['mesh']}_{job['faces'] if job['patch'] else 'whole'}_{job['edit']}_{job['seed']}"
    source, target, truth = (folder / f"{name}_{part}" for part in ("a.obj", "b.obj", "truth.json"))
    if not truth.exists():
        editor, obj = tool("edit_mesh"), tool("objmesh")
        positions, faces = obj.read_obj(job["path"])
        if job["patch"]:
            positions, faces = patch(positions, faces, job["faces"], f"{job['mesh']} {job['faces']} {job['seed']}")
        try:
            edits = (EDITS if job["patch"] else WHOLE_EDITS)[job["edit"]]
            changed = editor.edited(positions, faces, sized(edits, len(faces)), job["seed"])
        except editor.CannotEdit:
            return None
        obj.write_obj(source, positions, faces)
        obj.write_obj(target, changed[0], changed[1])
        truth.write_text(json.dumps(changed[2]), encoding="utf-8")
    return source, target, json.loads(truth.read_text(encoding="utf-8"))


def run_cpu(command, output):
    """Exit status and processor seconds of a command whose standard output goes to a file."""
    with open(output, "wb") as out:
        with subprocess.Popen([str(word) for word in command], stdout=out) as child:
            _, status, usage = os.wait4(child.pid, 0)
            child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, usage.ru_utime + usage.ru_stime


def solve(arguments):
    """One instance: solved, verified by the independent verifier, compared with the truth."""
    program, folder, job = arguments
    files = instance(folder, job)
    if files is None:
        return {**job, "path": "", "failed": "no place for the edit"}
    source, target, truth = files
    told, match = source.with_suffix(".figures.json"), source.with_suffix(".match.json")
    command = [program, "match", source, target, "-o", match, "--algorithm", "exact", "--orientation", "preserving",
               "--time-limit", job["seconds"], "--json", "--quiet"]
    status, seconds = run_cpu(command, told)
    if status not in (0, 1):
        return {**job, "path": "", "failed": f"exit status {status}"}
    report = json.loads(told.read_text(encoding="utf-8"))
    file, obj = json.loads(match.read_text(encoding="utf-8")), tool("objmesh")
    faults, figures = tool("verify_match").verify(obj.read_obj(source)[1], obj.read_obj(target)[1], file)
    pairs = {tuple(pair) for region in file["regions"] for pair in region["faces"]}
    exact = {tuple(pair) for pair in truth["exact"]}
    return {**job, "path": "", "source_faces": report["source"]["faces"], "target_faces": report["target"]["faces"],
            "size": report["matched_faces"], "bound": report["optimality"]["bound"],
            "proved": report["optimality"]["proved"], "nodes": report["optimality"]["nodes"], "cpu_seconds": round(seconds, 3),
            "surviving": len(exact), "true": len(pairs & exact),
            "faults": len(faults) + (figures["largest_region"] != report["matched_faces"])}


def jobs_for(options):
    sizes = {20: (5, (5,)), 80: (5, (5,))} if options.quick else SIZES
    jobs = [{"mesh": mesh, "patch": True, "faces": faces, "edit": edit, "seed": seed, "seconds": seconds,
             "path": str(options.meshes / f"{name}.obj")}
            for faces, (seconds, seeds) in sizes.items() for mesh, name in MESHES.items() for edit in EDITS for seed in seeds]
    whole = {} if options.quick else WHOLE
    jobs += [{"mesh": mesh, "patch": False, "faces": 0, "edit": edit, "seed": WHOLE_SEED, "seconds": WHOLE_SECONDS,
              "path": str(options.meshes / f"{name}.obj")} for mesh, name in whole.items() for edit in WHOLE_EDITS]
    return jobs


def solve_all(options, jobs):
    folder = pathlib.Path(options.build) / "exact"
    folder.mkdir(parents=True, exist_ok=True)
    return in_parallel(options, solve, [(options.program, folder, job) for job in jobs])


def measure(options):
    return {"rows": solve_all(options, jobs_for(options))}


def groups(rows):
    """Rows by size and edit, in the order in which they come."""
    by_key = collections.OrderedDict()
    for row in rows:
        if "failed" not in row:
            by_key.setdefault((row["faces"], row["edit"]), []).append(row)
    return by_key


def bars(raw):
    """Shares of the runs that are proved in time, against what was asked."""
    result = []
    for what, (applies, share) in BARS.items():
        rows = [row for row in raw["rows"] if "failed" not in row and applies(row)]
        if rows:
            result.append(Bar(f"exact: share proved in time of {len(rows)} {what}",
                              statistics.mean(row["proved"] for row in rows), share))
    return result


def patch_lines(rows):
    lines = []
    for (faces, edit), group in groups([row for row in rows if row["patch"]]).items():
        proved = [row for row in group if row["proved"]]
        seconds = [row["cpu_seconds"] for row in proved] or [float("nan")]
        nodes = [row["nodes"] for row in proved] or [0]
        gap = max((row["bound"] - row["size"] for row in group), default=0)
        lines.append([faces, edit, len(group), len(proved), f"{statistics.median(seconds):.2f}", f"{max(seconds):.2f}",
                      int(statistics.median(nodes)), max(nodes), f"{statistics.mean(row['size'] for row in group):.1f}",
                      f"{statistics.mean(row['surviving'] for row in group):.1f}",
                      f"{statistics.mean(row['true'] for row in group):.1f}", gap])
    return lines


def page(raw):
    rows = [row for row in raw["rows"] if "failed" not in row]
    lines = ["`quadmatch match --algorithm exact --orientation preserving`, one thread, processor seconds. Patches are discs "
             "of N faces of four meshes; 10 seconds each, 30 for 400 faces and for whole meshes. *Surviving*: faces the edit "
             "kept; *true*: pairs of the region found that are the truth; *gap*: bound less size, the largest of the group.\n",
             bar_table(bars(raw)), "\n" +
             table(["N", "edit", "runs", "proved", "median s", "max s", "median nodes", "max nodes", "size", "surviving",
                    "true", "gap"], patch_lines(rows))]
    whole = [[row["mesh"], row["edit"], row["source_faces"], row["target_faces"], row["size"],
              "proved" if row["proved"] else f"at most {row['bound']}", f"{row['cpu_seconds']:.1f}", row["nodes"],
              row["surviving"], row["true"]] for row in rows if not row["patch"]]
    if whole:
        lines.append("\nWhole meshes:\n\n" + table(["mesh", "edit", "A", "B", "size", "proved", "s", "nodes", "surviving", "true"], whole))
    faults = sum(1 for row in rows if row["faults"])
    lines.append(f"\n{len(rows)} matches, {faults} of them unsound by the independent verifier.\n")
    return lines
