"""Mirror maps against the planes that symmetric models were made in: at rest, bent, in random order, edited on one side."""
import itertools
import json
import math
import pathlib
import statistics
import subprocess
import tempfile

from parts.common import Bar, bar_table, command_line, keep, kept, table
from parts.subjects import edited_copy, in_parallel, name_of, tool

MESHES = ["pairs/mh_male_generic_muscle/a", "mh_proxy741", "tbm_duck_sculpture", "osd_rook", "cube"]
QUICK_MESHES = ["mh_proxy741", "cube"]
POSE = "bend:60"
# Local, so all but one place is as symmetric as it was.
EDITS = ["delete", "extrude", "collapse", "rip", "refine", "handle"]
SEEDS = 3
LATHE = 64  # planes about the axis of a turned piece
SIDE = 8  # quads along an edge of the cube: 386 vertices
# Of the longest way through the model: how far a vertex may be from where its partner's image is.
TOLERANCE = 2e-4
LEAST_EDITED = 1
LEAST_EDITED_MEAN = 1


def cube(path):
    """A cube of SIDE by SIDE quads a side, as OBJ."""
    points, faces = {}, []

    def vertex(point):
        return points.setdefault(tuple(point), len(points))

    for axis, end in itertools.product(range(3), (0, SIDE)):
        for i, j in itertools.product(range(SIDE), repeat=2):
            corners = []
            for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1)):
                point = [0, 0, 0]
                point[axis], point[(axis + 1) % 3], point[(axis + 2) % 3] = end, i + di, j + dj
                corners.append(vertex(point))
            faces.append(corners if end else corners[::-1])
    tool("objmesh").write_obj(path, [tuple(2 * c / SIDE - 1 for c in point) for point in points], faces)


def planes(positions):
    """Normals and offsets of the planes models are made in: across an axis, or about the longest way through the model
    like the planes of a lathe, or halfway between two axes."""
    low, high = ([pick(axis) for axis in zip(*positions)] for pick in (min, max))
    extent = [b - a for a, b in zip(low, high)]
    normals = []
    for along in sorted(range(3), key=lambda axis: -extent[axis]):
        steps = LATHE if extent[along] > 1.01 * max(extent[:along] + extent[along + 1:]) else 8
        for step in range(steps):
            normal = [0.0, 0.0, 0.0]
            normal[(along + 1) % 3], normal[(along + 2) % 3] = (f(math.pi * step / steps) for f in (math.cos, math.sin))
            normals.append(normal)
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    return [(normal, sum(n * m for n, m in zip(normal, middle))) for normal in normals]


def grid(positions):
    """The reach of a vertex, and the vertices in each cell of four reaches."""
    reach = TOLERANCE * max(max(axis) - min(axis) for axis in zip(*positions))
    cell = {}
    for number, point in enumerate(positions):
        cell.setdefault(tuple(math.floor(c / (4 * reach)) for c in point), []).append(number)
    return reach, cell


def partners(positions, numbers, reach, cell, normal, offset):
    """The vertex opposite each of these vertices, where there is one."""
    found = {}
    for number in numbers:
        point = positions[number]
        height = sum(n * c for n, c in zip(normal, point)) - offset
        image = [c - 2 * height * n for n, c in zip(normal, point)]
        key = [math.floor(c / (4 * reach)) for c in image]
        near = [(math.dist(image, positions[other]), other) for step in itertools.product((-1, 0, 1), repeat=3)
                for other in cell.get(tuple(k + s for k, s in zip(key, step)), [])]
        if near and min(near)[0] <= reach:
            found[number] = min(near)[1]
    return found


def true_mirrors(positions, faces):
    """Maps of vertices, one for each plane that lays most of the model on itself."""
    maps = []
    cells = grid(positions)
    everywhere, some = range(len(positions)), range(0, len(positions), len(positions) // 100 + 1)
    for plane in planes(positions):
        if len(partners(positions, some, *cells, *plane)) < 0.8 * len(some):
            continue
        found = partners(positions, everywhere, *cells, *plane)
        if len(found) >= 0.9 * len(positions):
            by_corners = {frozenset(face): number for number, face in enumerate(faces)}
            opposite = {number: by_corners.get(frozenset(found.get(v) for v in face)) for number, face in enumerate(faces)}
            maps.append((found, opposite))
    return maps


def symmetry(options, mesh, *more):
    """The map file and the figures of one run."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder, "map.json")
        command = [options.program, "symmetry", mesh, "-o", output, "--json", *more]
        ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        if ended.returncode not in (0, 1):
            raise RuntimeError(f"{' '.join(map(str, command))}: {ended.stderr.strip()[-200:]}")
        verified = subprocess.run([str(word) for word in (options.program, "verify", mesh, mesh, output, "--quiet")], check=False)
        return json.loads(output.read_text(encoding="utf-8")), json.loads(ended.stdout), verified.returncode == 0


class Truth:
    """Where the vertices of a mesh came to lie in an edited copy of it."""

    def __init__(self, faces, target_faces, pairs):
        self.face_at = {source: target for source, target, _ in pairs}
        self.vertex_at = {}
        for source, target, rotation in pairs:
            for corner, v in enumerate(faces[source]):
                self.vertex_at.setdefault(v, set()).add(target_faces[target][(rotation + corner) % len(faces[source])])
        self.around, self.around_target = ({}, {})
        for around, listed in ((self.around, faces), (self.around_target, target_faces)):
            for number, face in enumerate(listed):
                for v in face:
                    around.setdefault(v, set()).add(number)

    def survives(self, face):
        return face in self.face_at

    def is_untouched(self, v):
        """Are there the same faces around it as before, and no others?"""
        copies = self.vertex_at.get(v, ())
        return len(copies) == 1 and all(map(self.survives, self.around[v])) and all(
            self.around_target[copy] == {self.face_at[face] for face in self.around[v]} for copy in copies)


def compared(mirrors, faces, truth, found):
    """For the plane by which most is right: how many vertices there are of faces that survive with the face opposite, and
    how many of them are paired; and the same of those that the edit did not touch on either side."""
    partner = dict(found["vertices"])
    best = None
    for mirror, opposite in mirrors:
        due = {v for face, other in opposite.items() if truth.survives(face) and truth.survives(other) for v in faces[face]}
        # A slit or a lifted patch makes several of one vertex.
        right = {v for v in due if any(partner.get(copy) in truth.vertex_at[mirror[v]] for copy in truth.vertex_at[v])}
        rest = {v for v in due if truth.is_untouched(v) and truth.is_untouched(mirror[v])}
        if best is None or len(right) / len(due) > best[1] / best[0]:
            best = (len(due), len(right), len(rest), len(rest & right))
    return best


def measure_job(job):
    options, name, edit, pose, seed = job
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder, "cube.obj") if name == "cube" else options.meshes / f"{name}.obj"
        if name == "cube":
            cube(path)
        obj = tool("objmesh")
        positions, faces = obj.read_obj(path)
        row = {"mesh": "cube, subdivided" if name == "cube" else name_of(path), "edit": edit, "pose": pose, "seed": seed}
        try:
            with edited_copy(path, [edit] if edit else [], seed, [pose] if pose else []) as (_, target, truth):
                found, figures, sound = symmetry(options, target)
                survived = Truth(faces, obj.read_obj(target)[1], truth["exact"])
                due, right, rest, rest_right = compared(true_mirrors(positions, faces), faces, survived, found)
        except LookupError as error:
            return row | {"skipped": str(error)}
        partner = dict(found["vertices"])
        return row | {"vertices": due, "recall": right / due, "untouched": rest, "recall of untouched": rest_right / rest, "sound": sound,
                      "involution": all(partner.get(w) == v for v, w in partner.items()), "mirrors": figures["mirrors"],
                      "maybe more": figures["maybe_more"], "unpaired faces": figures["unpaired_faces"]}


def measure(options):
    names = QUICK_MESHES if options.quick else MESHES
    jobs = [(options, name, edit, pose, seed) for name in names for pose in ("", POSE)
            for edit, seed in [("", 1), *itertools.product(EDITS, range(1, 1 + (1 if options.quick else SEEDS)))]]
    keep(options, "symmetry.json", in_parallel(options, measure_job, jobs))


def measured(options):
    return [row for row in kept(options, "symmetry.json") or [] if "recall" in row]


def bars(options):
    rows = measured(options)
    if not rows:
        return []
    found = []
    for edited, least in ((False, 1), (True, LEAST_EDITED)):
        worst = min((row for row in rows if bool(row["edit"]) == edited), key=lambda row: row["recall of untouched"])
        what = ", ".join(filter(None, (worst["mesh"], worst["edit"], worst["pose"])))
        found.append(Bar(f"vertices paired with the one opposite, {'edited on one side' if edited else 'not edited'}, the worst "
                         f"({what})", worst["recall of untouched"], least))
    edited = [row["recall of untouched"] for row in rows if row["edit"]]
    found.append(Bar("vertices paired with the one opposite, edited on one side, mean", statistics.mean(edited), LEAST_EDITED_MEAN))
    found.append(Bar("maps that are sound and their own inverse, share",
                     statistics.mean(row["sound"] and row["involution"] for row in rows), 1))
    return found


def page(options):
    rows = measured(options)
    if not rows:
        return []
    lines = []
    for mesh in dict.fromkeys(row["mesh"] for row in rows):
        for pose in dict.fromkeys(row["pose"] for row in rows):
            plain = next(row for row in rows if row["mesh"] == mesh and row["pose"] == pose and not row["edit"])
            edited = [row for row in rows if row["mesh"] == mesh and row["pose"] == pose and row["edit"]]
            worst = min(edited, key=lambda row: row["recall of untouched"])
            lines.append([mesh, pose or "rest", f"{'at least ' if plain['maybe more'] else ''}{plain['mirrors']}",
                          f"{plain['vertices']:,}", f"{plain['recall']:.4f}",
                          *(f"{statistics.mean(row[what] for row in edited):.4f}" for what in ("recall", "recall of untouched")),
                          f"{worst['recall of untouched']:.4f} ({worst['edit']})"])
    return ["\n## Symmetry\n",
            f"{command_line('symmetry')}. `quadmatch symmetry` on copies in random order of models that were made symmetric, at "
            f"rest and bent by `{POSE}`. A vertex is right if its partner is the vertex that was opposite it at rest, in the one "
            "plane of the model that the map agrees with best; counted are vertices of faces that have a face opposite. "
            f"*Edited*: one local edit ({', '.join(EDITS)}; {SEEDS} places each), which spoils the symmetry there; counted is what "
            "the edit left on both sides, first with the rim of the edit, then only vertices that have the faces around them "
            "that they had, on both sides: these are what the bars ask for.\n",
            table(["mesh", "pose", "mirrors", "vertices", "right", "edited: with rim, mean", "without, mean", "without, worst"], lines),
            "\n" + bar_table(bars(options))]
