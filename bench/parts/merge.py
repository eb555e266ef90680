"""Merges of two edits of one mesh, held against both edits made one after the other; and what a merge costs."""
import itertools
import json
import pathlib
import random
import statistics
import subprocess
import tempfile

from parts.common import ROOT, Bar, bar_table, command_line, keep, kept, measured_run, run, table
from parts.subjects import in_parallel, name_of, quality_meshes, tool

# Each makes its place out of the last random face, and what it draws after it.
EDITS = ["delete:20", "extrude:12", "collapse:1", "rip:6", "loop", "unloop", "twist", "handle", "refine:9"]
DISJOINT = 220
OVERLAPPING = 120
QUICK = 12
ATTEMPTS = 300
MOST_TIMES_MATCH = 3.0


class Draws:
    """Random numbers for one edit, kept; or those of another edit again, with its faces as they are numbered now."""

    def __init__(self, rng=None, drawn=(), faces_before=0, face_now=None):
        self.rng, self.drawn, self.again = rng, list(drawn), rng is None
        self.faces_before, self.face_now = faces_before, face_now

    def randrange(self, count):
        if not self.again:
            value = self.rng.randrange(count)
            if count == self.faces_before:
                self.drawn = []
            self.drawn.append((count, value))
            return value
        if not self.drawn:
            raise LookupError("the edit does not fit any more")
        before, value = self.drawn.pop(0)
        return self.now(value) if before == self.faces_before else value

    def sample(self, population, count):
        if not self.again:
            values = self.rng.sample(population, count)
            self.drawn = [(self.faces_before, value) for value in values]
            return values
        values = [self.now(value) for _, value in self.drawn]
        self.drawn = []
        return values

    def now(self, face):
        if face not in self.face_now:
            raise LookupError("the place of the edit is gone")
        return self.face_now[face]


def apply(mesh, edit):
    editor = tool("edit_mesh")
    name, _, size = edit.partition(":")
    editor.EDITS[name](mesh, int(size) if size else editor.DEFAULT_SIZE[name])


def first_edit(positions, faces, edit, seed):
    """An edited copy, and what was drawn for it."""
    mesh = tool("edit_mesh").EditableMesh(positions, faces, None)
    mesh.rng = Draws(random.Random(seed), faces_before=len(faces))
    apply(mesh, edit)
    return mesh, list(mesh.rng.drawn)


def edited(positions, faces, edits):
    """A copy with all of these edits: pairs of a name and what was drawn for it on the mesh as it was."""
    mesh = tool("edit_mesh").EditableMesh(positions, faces, None)
    for edit, drawn in edits:
        face_now = {origin[0]: index for index, origin in enumerate(mesh.origins) if isinstance(origin, tuple)}
        mesh.rng = Draws(drawn=drawn, faces_before=len(faces), face_now=face_now)
        apply(mesh, edit)
    return mesh


def touched(faces, mesh):
    """Vertices of the base whose faces are other ones now, or joined in another way."""
    before, after, image, found = {}, {}, {}, set()
    for index, face in enumerate(faces):
        for vertex in face:
            before[vertex] = before.get(vertex, 0) + 1
    for face, origin in zip(mesh.faces, mesh.origins):
        for vertex in face:
            after[vertex] = after.get(vertex, 0) + 1
        if isinstance(origin, tuple):
            for corner, vertex in enumerate(faces[origin[0]]):
                image.setdefault(vertex, []).append(face[(corner - origin[1]) % len(face)])
    for vertex, count in before.items():
        now = image.get(vertex, [])
        if len(now) != count or len(set(now)) != 1 or after[now[0]] != count:
            found.add(vertex)
    return found


def widened(faces, vertices, rings=1):
    for _ in range(rings):
        vertices = vertices | {vertex for face in faces if not vertices.isdisjoint(face) for vertex in face}
    return vertices


def write(path, mesh, seed=None):
    """The mesh as it is, or with everything renumbered; without the vertices that no face uses."""
    obj = tool("objmesh")
    if seed is not None:
        mesh.rng = random.Random(seed)
        positions, faces, _ = tool("edit_mesh").shuffled(mesh)
    else:
        used = sorted({vertex for face in mesh.faces for vertex in face})
        number = {vertex: place for place, vertex in enumerate(used)}
        positions = [mesh.positions[vertex] for vertex in used]
        faces = [tuple(number[vertex] for vertex in face) for face in mesh.faces]
    obj.write_obj(path, positions, faces)


def choose(positions, faces, rng, away_from, meeting=None, edits=EDITS):
    """A random edit away from these vertices, and touching some of those, if any are given."""
    for _ in range(ATTEMPTS):
        edit = rng.choice(edits)
        try:
            mesh, drawn = first_edit(positions, faces, edit, rng.randrange(1 << 30))
        except tool("edit_mesh").CannotEdit:
            continue
        there = touched(faces, mesh)
        if widened(faces, there, 2).isdisjoint(away_from) and (meeting is None or not there.isdisjoint(meeting)):
            return (edit, drawn), there
    raise LookupError("no place for an edit")


def merged(options, folder, prefer="ours"):
    """The figures of the merge of the files in the folder, and its status."""
    command = [options.program, "merge", folder / "base.obj", folder / "ours.obj", folder / "theirs.obj", "-o",
               folder / "out.obj", "--prefer", prefer, "--json", "--quiet"]
    ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if ended.returncode not in (0, 1):
        raise RuntimeError(f"{' '.join(map(str, command))}: {ended.stderr.strip()[-200:]}")
    return json.loads(ended.stdout), ended.returncode


def is_same(options, one, other):
    return subprocess.run([str(options.program), "diff", str(one), str(other), "--isomorphic", "--orientation", "preserving",
                           "--quiet"], capture_output=True, check=False).returncode == 0


def leave_it_as_it_is(options, folder, positions, faces, edits):
    """Is the mesh after one of these edits isomorphic to what it was, as a twist between symmetric parts leaves it? A merge
    then gives the other side back, as it does for any copy of the base."""
    for edit in edits:
        if edit[0] != "twist":  # all others change how many faces or vertices there are
            continue
        write(folder / "one.obj", edited(positions, faces, [edit]))
        if is_same(options, folder / "base.obj", folder / "one.obj"):
            return True
    return False


def faces_of(mesh):
    """The faces, whatever order they are in and whichever corner they start at."""
    return sorted(min(face[k:] + face[:k] for k in range(len(face))) for face in mesh.faces)


def disjoint_pair(job):
    options, mesh, seed = job
    positions, faces = tool("objmesh").read_obj(mesh)
    rng = random.Random(seed)
    for _ in range(ATTEMPTS):
        try:
            one, near = choose(positions, faces, rng, frozenset())
            another, _ = choose(positions, faces, rng, widened(faces, near, 2))
            truth = edited(positions, faces, [one, another])
            break
        except LookupError:
            continue
    row = {"mesh": name_of(mesh), "seed": seed, "edits": [one[0], another[0]]}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write(folder / "base.obj", tool("edit_mesh").EditableMesh(positions, faces, None))
        row["no edit"] = leave_it_as_it_is(options, folder, positions, faces, [one, another])
        write(folder / "truth.obj", truth)
        for kind, seeds in (("as they are", (None, None)), ("renumbered", (2 * seed, 2 * seed + 1))):
            write(folder / "ours.obj", edited(positions, faces, [one]), seeds[0])
            write(folder / "theirs.obj", edited(positions, faces, [another]), seeds[1])
            figures, status = merged(options, folder)
            row[kind] = {"clean": status == 0, "same": is_same(options, folder / "out.obj", folder / "truth.obj")}
    return row


def overlapping_pair(job):
    """Two edits that meet, and an edit of either side elsewhere: what becomes of the four?"""
    options, mesh, seed = job
    positions, faces = tool("objmesh").read_obj(mesh)
    rng = random.Random(seed)
    for _ in range(ATTEMPTS):
        try:
            a, near_a = choose(positions, faces, rng, frozenset())
            b, near_b = choose(positions, faces, rng, frozenset(), near_a)
            around = widened(faces, near_a | near_b, 2)
            c, near_c = choose(positions, faces, rng, around)
            d, _ = choose(positions, faces, rng, around | widened(faces, near_c, 2))
            truths = {"ours": edited(positions, faces, [a, c, d]), "theirs": edited(positions, faces, [b, c, d])}
            sides = [edited(positions, faces, [a, c]), edited(positions, faces, [b, d])]
            break
        except LookupError:
            continue
    row = {"mesh": name_of(mesh), "seed": seed, "edits": [a[0], b[0]], "elsewhere": [c[0], d[0]]}
    row["same edit"] = faces_of(edited(positions, faces, [a])) == faces_of(edited(positions, faces, [b]))
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write(folder / "base.obj", tool("edit_mesh").EditableMesh(positions, faces, None))
        row["no edit"] = leave_it_as_it_is(options, folder, positions, faces, [a, b, c, d])
        write(folder / "ours.obj", sides[0])
        write(folder / "theirs.obj", sides[1], seed)
        for prefer, truth in truths.items():
            write(folder / "truth.obj", truth)
            figures, status = merged(options, folder, prefer)
            row[prefer] = {"conflict": status == 1, "same": is_same(options, folder / "out.obj", folder / "truth.obj")}
    return row


def same_edit(job):
    """One edit made on both sides, and an edit of either side elsewhere: is it there once, and no conflict?"""
    options, mesh, edit, seed = job
    positions, faces = tool("objmesh").read_obj(mesh)
    rng = random.Random(seed)
    row = {"mesh": name_of(mesh), "seed": seed, "edit": edit}
    for _ in range(ATTEMPTS):
        try:
            a, near_a = choose(positions, faces, rng, frozenset(), edits=[edit])
            c, near_c = choose(positions, faces, rng, widened(faces, near_a, 2))
            d, _ = choose(positions, faces, rng, widened(faces, near_a | near_c, 2))
            truth = edited(positions, faces, [a, c, d])
            sides = [edited(positions, faces, [a, c]), edited(positions, faces, [a, d])]
            break
        except LookupError:
            continue
    else:
        return row | {"skipped": "no place for an edit"}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write(folder / "base.obj", tool("edit_mesh").EditableMesh(positions, faces, None))
        row["no edit"] = leave_it_as_it_is(options, folder, positions, faces, [a, c, d])
        write(folder / "ours.obj", sides[0])
        write(folder / "theirs.obj", sides[1], seed)
        write(folder / "truth.obj", truth)
        _, status = merged(options, folder)
        return row | {"clean": status == 0, "same": is_same(options, folder / "out.obj", folder / "truth.obj")}


def unchanged_side(job):
    """merge(B, A, B) and merge(B, B, A), renumbered too: is it A?"""
    options, base, other = job
    row = {"base": name_of(base), "other": name_of(other), "same": []}
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        obj = tool("objmesh")
        write(folder / "again.obj", tool("edit_mesh").EditableMesh(*obj.read_obj(base), None), 7)
        for side, unchanged in (("ours", base), ("theirs", base), ("ours", folder / "again.obj"), ("theirs", folder / "again.obj")):
            (folder / "base.obj").write_bytes(base.read_bytes())
            (folder / f"{side}.obj").write_bytes(other.read_bytes())
            (folder / f"{'theirs' if side == 'ours' else 'ours'}.obj").write_bytes(unchanged.read_bytes())
            merged(options, folder)
            row["same"].append(is_same(options, folder / "out.obj", other))
    return row


def cost(options):
    """What a merge of two edited copies of 100,000 quads takes, in the time of a match of one of them."""
    runs = 3 if options.quick else 7
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shirt = ROOT / "examples" / "shirt_long.obj"
        run([options.build / "edit_mesh", shirt, folder / "base.obj", "subdivide:1" if options.quick else "subdivide:3"])
        for side, edits in (("ours", ["extrude:12", "delete:20", "renumber"]), ("theirs", ["rip", "refine", "renumber"])):
            run([options.build / "edit_mesh", folder / "base.obj", folder / f"{side}.obj", "--seed", "5", *edits])
        times = {"match": [], "merge": []}
        for _ in range(runs):
            for verb, command in (("match", ["match", folder / "base.obj", folder / "ours.obj", "-o", folder / "m.json"]),
                                  ("merge", ["merge", folder / "base.obj", folder / "ours.obj", folder / "theirs.obj", "-o",
                                             folder / "out.obj"])):
                took = measured_run([options.program, *command, "--json", "--quiet"])
                times[verb].append(took.milliseconds / 1000)
        faces = json.loads(took.output)["base"]["faces"]
    return {"faces": faces, **{verb: statistics.median(seconds) for verb, seconds in times.items()}}


def measure(options):
    meshes = quality_meshes(options)
    disjoint, overlapping = (QUICK, QUICK) if options.quick else (DISJOINT, OVERLAPPING)
    keep(options, "merge.json", {
        "disjoint": in_parallel(options, disjoint_pair, [(options, meshes[k % len(meshes)], k) for k in range(disjoint)]),
        "overlapping": in_parallel(options, overlapping_pair,
                                   [(options, meshes[k % len(meshes)], 1000 + k) for k in range(overlapping)]),
        "same": in_parallel(options, same_edit, [(options, mesh, edit, 2000 + k)
                                                 for k, (mesh, edit) in enumerate(itertools.product(meshes, EDITS))]),
        "unchanged": in_parallel(options, unchanged_side, [(options, a, b) for a in meshes for b in meshes if a != b]),
        "cost": cost(options)})


def share(values):
    values = list(values)
    return sum(values) / len(values) if values else 1.0


def counted(rows):
    """Those in which each side changed something, and not both the same."""
    return [row for row in rows if not row.get("no edit") and not row.get("same edit") and "skipped" not in row]


def bars(options):
    figures = kept(options, "merge.json")
    if not figures:
        return []
    kinds = ("as they are", "renumbered")
    disjoint, overlapping, same = (counted(figures.get(name, [])) for name in ("disjoint", "overlapping", "same"))
    return [Bar(f"disjoint edits: merged clean and isomorphic to both edits, share of {len(disjoint)} pairs",
                share(row[kind]["clean"] and row[kind]["same"] for row in disjoint for kind in kinds), 1),
            Bar(f"overlapping edits: a conflict is reported, share of {len(overlapping)} pairs",
                share(row[side]["conflict"] for row in overlapping for side in ("ours", "theirs")), 1),
            Bar("overlapping edits: the preferred side there and all other edits, share",
                share(row[side]["same"] for row in overlapping for side in ("ours", "theirs")), 1),
            Bar(f"the same edit on both sides: merged clean, and there once, share of {len(same)}",
                share(row["clean"] and row["same"] for row in same), 1),
            Bar("an unchanged side gives the other side back, share",
                share(same for row in figures["unchanged"] for same in row["same"]), 1),
            Bar(f"merge of {figures['cost']['faces']:,} faces, in times of match",
                figures["cost"]["merge"] / figures["cost"]["match"], MOST_TIMES_MATCH, at_most=True)]


def left_out(figures):
    rows = itertools.chain.from_iterable(figures.get(name, []) for name in ("disjoint", "overlapping", "same"))
    return sum(row.get("no edit", False) for row in rows)


def page(options):
    figures = kept(options, "merge.json")
    if not figures:
        return []
    lines = []
    for edit in EDITS:
        rows = [row for row in counted(figures["disjoint"]) if edit in row["edits"]]
        counts = [sum(row[kind]["clean"] and row[kind]["same"] for row in rows) for kind in ("as they are", "renumbered")]
        met = [row for row in counted(figures["overlapping"]) if edit in row["edits"]]
        lines.append([edit, len(rows), *counts, len(met), sum(row["ours"]["conflict"] and row["theirs"]["conflict"] for row in met),
                      sum(row["ours"]["same"] and row["theirs"]["same"] for row in met)])
    return ["\n## Merge\n",
            f"{command_line('merge')}. *Disjoint*: a mesh was edited at two random places, in one copy each; the truth has both "
            "edits, one made after the other. At least four faces lie between what the edits changed. How many merges are clean and "
            "isomorphic to the truth, with the copies numbered as they were and renumbered at random. *Overlapping*: two "
            "edits that change what is around the same vertex, and an edit of either side elsewhere; how many are reported as "
            "conflicts, and how many results are, with either side preferred, isomorphic to that side's edit and both edits elsewhere. "
            f"The same edit was drawn for both sides in {sum(row.get('same edit', False) for row in figures['overlapping'])} of these "
            "pairs, which is no conflict and counted apart: *the same edit* of each kind was made on both sides of each mesh, with an "
            f"edit of either side elsewhere. Left out are {left_out(figures)} pairs in which a twist between symmetric parts left a mesh "
            "isomorphic to what it was: by connectivity that side changed nothing, and the merge gives the other side back.\n",
            table(["edit", "disjoint pairs", "as they are", "renumbered", "overlapping pairs", "conflicts", "the rest is right"], lines),
            "\n" + bar_table(bars(options))]
