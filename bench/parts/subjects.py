"""What is measured: which meshes, their edited copies, and what a match of them is worth."""
import concurrent.futures
import contextlib
import importlib
import json
import pathlib
import random
import subprocess
import sys
import tempfile

from parts.common import run

# The meshes on which a prototype of the paper's algorithm was measured too.
QUALITY_MESHES = ["mh_male_casualsuit01", "mh_proxy741", "pairs/mh_male_generic_muscle/a", "tbm_duck_sculpture", "osd_rook",
                  "tbm_skull", "fe_plate_holes", "qt_trex"]
# Posed, nothing tells the turns of a rotation-symmetric mesh apart.
SYMMETRIC = "osd_rook"


def tool(name):
    """A module of the tools beside the collection; run.py puts their folder on the path."""
    return importlib.import_module(name)


def quality_meshes(options):
    return [options.meshes / f"{name}.obj" for name in (["mh_proxy741", "qt_trex"] if options.quick else QUALITY_MESHES)]


def name_of(mesh):
    return mesh.parent.name if mesh.stem in "ab" else mesh.stem


def in_parallel(options, work, jobs):
    """The result of each job, in order."""
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        return list(pool.map(work, jobs))


def match(options, source, target, *more):
    """The match file of two meshes, as the program writes it."""
    with tempfile.TemporaryDirectory() as folder:
        output = pathlib.Path(folder, "m.json")
        command = [options.program, "match", source, target, "-o", output, "--quiet", *more]
        ended = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        if ended.returncode not in (0, 1):
            raise RuntimeError(f"{' '.join(map(str, command))}: {ended.stderr.strip()[-200:]}")
        return json.loads(output.read_text(encoding="utf-8"))


@contextlib.contextmanager
def edited_copy(mesh, edits, seed, poses=()):
    """Files of a mesh and of an edited copy of it, and the true correspondence. Raises LookupError if nothing fits."""
    editor, obj, quality = tool("edit_mesh"), tool("objmesh"), tool("quality")
    positions, faces = obj.read_obj(mesh)
    try:
        changed = editor.edited(positions, faces, quality.sized(edits, len(faces)) + list(poses), seed)
    except editor.CannotEdit as error:
        raise LookupError(str(error)) from error
    with tempfile.TemporaryDirectory() as folder:
        source, target = pathlib.Path(folder, "a.obj"), pathlib.Path(folder, "b.obj")
        obj.write_obj(source, positions, faces)
        obj.write_obj(target, changed[0], changed[1])
        yield source, target, changed[2]


def posed(positions, faces, pose):
    """Where a pose such as bend:60 moves the vertices; their order stays."""
    editor = tool("edit_mesh")
    mesh = editor.EditableMesh(positions, faces, random.Random(0))
    name, _, size = pose.partition(":")
    editor.EDITS[name](mesh, int(size) if size else editor.DEFAULT_SIZE[name])
    return mesh.positions


def edits_named(name):
    return tool("quality").EDITS[name]


def pair_folders(options, known_only=False):
    folders = sorted(path for path in (options.meshes / "pairs").iterdir() if path.is_dir())
    if known_only:
        folders = [folder for folder in folders if (folder / "truth.json").exists()]
    return folders[:2] if options.quick else folders


def renumbered(positions, faces, seed):
    """The same mesh in another order; the old face and the turn of each new one."""
    rng = random.Random(seed)
    order = list(range(len(positions)))
    rng.shuffle(order)
    number_of = {vertex: number for number, vertex in enumerate(order)}
    places = []
    for face in rng.sample(range(len(faces)), len(faces)):
        places.append((face, rng.randrange(len(faces[face]))))
    new_faces = [tuple(number_of[faces[old][(corner + turn) % len(faces[old])]] for corner in range(len(faces[old])))
                 for old, turn in places]
    return [positions[vertex] for vertex in order], new_faces, places


def measure_quality(options, seeds, more=(), pose=""):
    """The rows of the quality tool over all edits: recall, near, precision, far, faults by the independent verifier."""
    matcher = f"{options.program} match {{a}} {{b}} -o {{m}} --quiet {' '.join(more)}"
    with tempfile.TemporaryDirectory() as folder:
        rows = pathlib.Path(folder, "rows.json")
        run([sys.executable, options.tools / "quality.py", "--matcher", matcher, "--seeds", seeds[:1] if options.quick else seeds,
             "--jobs", options.jobs, "--json", rows, *(["--pose", pose] if pose else []), *quality_meshes(options)], statuses=(0, 1))
        return json.loads(rows.read_text(encoding="utf-8"))
