"""Marks of edges: seams, sharp edges, creases and bevel weights."""
import numpy as np

from .mesh_arrays import read
from .sentences import counted

#: Of Blender's edges; since Blender 4.0 the last two are attributes.
FLAGS = {"use_seam": "seam", "use_edge_sharp": "sharp edge"}
NUMBERS = {"crease": ("crease_edge", "crease"), "bevel_weight": ("bevel_weight_edge", "bevel weight")}


def carry(source, target, along):
    """At edges with a partner the target has the source's marks, set or not."""
    lines = []
    for name, word in FLAGS.items():
        marks = read(source.data.edges, name, len(source.data.edges), bool)
        written = read(target.data.edges, name, len(target.data.edges), bool)
        _along(along, marks, written)
        target.data.edges.foreach_set(name, written)
        if marks.any():
            lines.append(f"{counted(int(marks[along.edges[:, 0]].sum()), word)}")
    for name, (attribute, word) in NUMBERS.items():
        numbers = _numbers(source.data, name, attribute)
        if numbers is None or not numbers.any():
            continue
        written = _numbers(target.data, name, attribute)
        written = np.zeros(len(target.data.edges), np.float32) if written is None else written
        _along(along, numbers, written)
        _set_numbers(target.data, name, attribute, written)
        lines.append(f"{counted(int((numbers[along.edges[:, 0]] > 0).sum()), word)}")
    target.data.update()
    return [", ".join(lines)] if lines else []


def _along(along, values, written):
    written[along.edges[:, 1]] = values[along.edges[:, 0]]


def _numbers(mesh, name, attribute):
    """float32 for each edge, or None where there are none."""
    if name in mesh.edges[0].bl_rna.properties:
        return read(mesh.edges, name, len(mesh.edges), np.float32)
    layer = mesh.attributes.get(attribute)
    return read(layer.data, "value", len(mesh.edges), np.float32) if layer else None


def _set_numbers(mesh, name, attribute, values):
    if name in mesh.edges[0].bl_rna.properties:
        mesh.edges.foreach_set(name, values)
        return
    layer = mesh.attributes.get(attribute) or mesh.attributes.new(attribute, "FLOAT", "EDGE")
    layer.data.foreach_set("value", values)
