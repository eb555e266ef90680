"""Meshes in Blender for the tests, and all that is known of an object as one value to compare."""
import json
import os
import pathlib
import subprocess

import bpy
import numpy as np
from quadmatch_addon import memory

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = pathlib.Path(os.environ.get("QUADMATCH_BUILD", ROOT / "build" / "release"))
SHARED = ROOT.parent / "shared" / "meshes"
FOLDER = pathlib.Path(os.environ.get("QUADMATCH_TEST_FOLDER", ROOT / "build" / "blender" / "tests"))


def clear():
    """An empty scene with the settings as they are at first."""
    active = bpy.context.view_layer.objects.active
    if active and active.mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    for collection in (bpy.data.objects, bpy.data.meshes, bpy.data.materials, bpy.data.collections, bpy.data.libraries):
        for item in list(collection):
            collection.remove(item)
    memory.forget_all()
    settings = bpy.context.scene.quadmatch
    for name in list(settings.keys()):
        settings.property_unset(name)


def add(name, positions, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([tuple(p) for p in positions], [], [tuple(f) for f in faces])
    mesh.update()
    return add_object(name, mesh)


def add_object(name, mesh):
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def load(path, name):
    """An OBJ file as it is: its own axes, its own order."""
    positions, faces = [], []
    with open(path, encoding="utf-8") as file:
        for line in file:
            words = line.split()
            if words[:1] == ["v"]:
                positions.append([float(word) for word in words[1:4]])
            elif words[:1] == ["f"]:
                faces.append([int(word.partition("/")[0]) - 1 for word in words[1:]])
    return add(name, positions, faces)


def grid(name, columns, rows):
    """columns by rows quads in the plane."""
    positions = [(x, y, 0) for y in range(rows + 1) for x in range(columns + 1)]
    faces = [(i, i + 1, i + columns + 2, i + columns + 1) for y in range(rows) for i in range(y * (columns + 1), y * (columns + 1) + columns)]
    return add(name, positions, faces)


def mixed_pair():
    """A triangle, a square and a pentagon around a vertex, and the same in another order."""
    points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (-1, 0, 0), (-1, -1, 0), (0, -1, 0), (1, -1, 0)]
    one = add("Mixed", points + [(2, 2, 0)], [(0, 1, 2), (0, 2, 3, 4), (0, 4, 5, 6, 1)])
    other = add("Turned", [points[6 - i] for i in range(7)] + [(2, 2, 0)], [(0, 5, 6, 2, 1), (6, 5, 4), (3, 2, 6, 4)])
    return one, other


class Truth:
    """What an edit left: pairs of faces, corners, vertices and edges of two objects, each (K, 2).

    Where an edit made one of two, say by a collapse, either would be right: such a target is in no pair."""

    def __init__(self, path, source, target):
        said = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
        turn = -1 if said["orientation"] == "reversing" else 1
        self.faces = np.array([row[:2] for row in said["exact"]])
        corners, edges = [], []
        for face, image, rotation in said["exact"]:
            mine, theirs = list(source.data.polygons[face].loop_indices), list(target.data.polygons[image].loop_indices)
            count = len(mine)
            for corner in range(count):
                corners.append((mine[corner], theirs[(rotation + turn * corner) % count]))
                edges.append((mine[corner], theirs[(rotation + turn * corner - (turn < 0)) % count]))
        self.corners = np.array(corners)
        self.vertices = _told_apart(np.stack([_of_corners(source, "vertex_index")[self.corners[:, 0]],
                                            _of_corners(target, "vertex_index")[self.corners[:, 1]]], axis=1))
        edges = np.array(edges)
        self.edges = _told_apart(np.stack([_of_corners(source, "edge_index")[edges[:, 0]], _of_corners(target, "edge_index")[edges[:, 1]]], axis=1))


def _told_apart(pairs):
    pairs = np.unique(pairs, axis=0)
    _, inverse, times = np.unique(pairs[:, 1], return_inverse=True, return_counts=True)
    return pairs[times[inverse] == 1]


def _of_corners(obj, name):
    values = np.empty(len(obj.data.loops), np.int32)
    obj.data.loops.foreach_get(name, values)
    return values


def edited(path, edits, seed):
    """The object of a file, an edited copy of it, and the truth about them. The copy is made by the program edit_mesh."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    copy, truth = FOLDER / "copy.obj", FOLDER / "truth.json"
    subprocess.run([BUILD / "edit_mesh", path, copy, *edits, "--seed", str(seed), "--truth", truth], check=True, stdout=subprocess.DEVNULL)
    source, target = load(path, "Source"), load(copy, "Target")
    return source, target, Truth(truth, source, target)


def numbers(elements, name, width=1, dtype=np.float32):
    values = np.empty(len(elements) * width, dtype)
    elements.foreach_get(name, values)
    return values.reshape(-1, width) if width > 1 else values


def weights(obj, group):
    """Of each vertex, NaN where it is not in the group."""
    index = obj.vertex_groups[group].index
    return np.array([next((e.weight for e in vertex.groups if e.group == index), np.nan) for vertex in obj.data.vertices], np.float32)


def all_of(obj):
    """Everything about an object that the add-on could change, as one value."""
    mesh = obj.data
    known = {"positions": numbers(mesh.vertices, "co", 3), "corners": _of_corners(obj, "vertex_index"), "edges": numbers(mesh.edges, "vertices", 2, np.int32),
             "starts": numbers(mesh.polygons, "loop_start", 1, np.int32), "materials": numbers(mesh.polygons, "material_index", 1, np.int32),
             "slots": [slot.material.name if slot.material else "" for slot in obj.material_slots],
             "groups": [group.name for group in obj.vertex_groups],
             "weights": [sorted((e.group, e.weight) for e in vertex.groups) for vertex in mesh.vertices],
             "uv": {layer.name: numbers(layer.data, "uv", 2) for layer in mesh.uv_layers},
             "colours": {layer.name: numbers(layer.data, "color", 4) for layer in mesh.color_attributes},
             "attributes": sorted((a.name, a.domain, a.data_type) for a in mesh.attributes),
             "shapes": {key.name: numbers(key.data, "co", 3) for key in (mesh.shape_keys.key_blocks if mesh.shape_keys else ())},
             "crease": numbers(mesh.edges, "crease"), "bevel": numbers(mesh.edges, "bevel_weight"),
             "matrix": [tuple(row) for row in obj.matrix_world], "hidden": obj.hide_viewport, "mode": obj.mode, "name": obj.name, "mesh": mesh.name}
    for name in ("use_seam", "use_edge_sharp", "select", "hide"):
        known[name] = numbers(mesh.edges, name, 1, bool)
    for name in ("vertices", "polygons"):
        known["select " + name] = numbers(getattr(mesh, name), "select", 1, bool)
    return known


def differences(one, other, path=""):
    """Where two such values differ."""
    if isinstance(one, dict):
        if one.keys() != other.keys():
            return [f"{path}: {sorted(one)} and {sorted(other)}"]
        return [line for key in one for line in differences(one[key], other[key], f"{path}/{key}")]
    if isinstance(one, np.ndarray):
        same = one.shape == other.shape and bool(((one == other) | ((one != one) & (other != other))).all())
    else:
        same = one == other
    return [] if same else [path]
