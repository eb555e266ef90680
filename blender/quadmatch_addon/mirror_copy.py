"""One side of a mirrored mesh copied to the other: positions, weights, the selection."""
import bpy
import numpy as np

from . import carry_groups, selection, sentences
from .mesh_arrays import read


def vertex_pairs(arrays, mirror, sides):
    """(K, 2): a vertex on the side, and the one opposite. Nothing on the line."""
    partner = mirror.vertex_map(arrays.vertex_count)
    here = np.unique(arrays.corners[sides[arrays.face_of_corner] > 0])
    here = here[(partner[here] >= 0) & (partner[here] != here)]
    return np.stack([here, partner[here]], axis=1)


def snapped(normal, offset, size):
    """The plane, or that of an axis if it is the same but for rounding: then both sides are equal to the last bit."""
    axis = int(np.argmax(np.abs(normal)))
    straight = np.eye(3)[axis] * np.sign(normal[axis])
    if np.abs(normal - straight).max() < 1e-5:
        return straight, 0.0 if abs(offset) < 1e-5 * size else offset
    return normal, offset


def copy_positions(obj, arrays, pairs, mirror):
    """The side's mirror image, in the mesh and its reference key; other shape keys keep their displacements."""
    old = arrays.positions.astype(np.float64)
    normal, offset = snapped(mirror.plane[0], mirror.plane[1], np.ptp(old, axis=0).max())
    new = old.copy()
    new[pairs[:, 1]] = old[pairs[:, 0]] - 2 * ((old[pairs[:, 0]] @ normal - offset))[:, None] * normal
    line = mirror.line_vertices
    new[line] = old[line] - (old[line] @ normal - offset)[:, None] * normal
    new = new.astype(np.float32)
    keys = obj.data.shape_keys
    for key in keys.key_blocks if keys else ():
        points = read(key.data, "co", 3 * len(key.data), np.float32).reshape(-1, 3)
        key.data.foreach_set("co", (new if key == keys.reference_key else points + (new - arrays.positions)).ravel())
    obj.data.vertices.foreach_set("co", new.ravel())
    obj.data.update()
    moved = np.linalg.norm(new - arrays.positions, axis=1)
    return [f"{int((moved > 1e-6 * np.ptp(old, axis=0).max()).sum()):,} vertices moved, the farthest by {moved.max():.4g}"]


def copy_groups(obj, pairs):
    """Weights: what is in Hand.L here is in Hand.R there."""
    if not obj.vertex_groups:
        return []
    opposite = {}
    for name in [group.name for group in obj.vertex_groups]:
        flipped = bpy.utils.flip_name(name)
        group = obj.vertex_groups.get(flipped) or obj.vertex_groups.new(name=flipped)
        opposite[obj.vertex_groups[name].index] = group
    vertices = obj.data.vertices
    here, there = pairs.T.tolist()
    weights = [{opposite[element.group].index: element.weight for element in vertices[vertex].groups
                if element.group in opposite} for vertex in here]
    carry_groups.write(obj, obj.vertex_groups, there, weights)
    return [sentences.counted(len(obj.vertex_groups), "vertex group")]


def copy_selection(mesh, arrays, pairs):
    selected = read(mesh.vertices, "select", arrays.vertex_count, bool)
    selected[pairs[:, 1]] = selected[pairs[:, 0]]
    selection.select_vertices(mesh, arrays, selected)
