"""Vertex order: the target's vertices, edges and faces are numbered as the source's, all its data going with them."""
import bmesh
import numpy as np

from .sentences import counted


def carry(source, target, along):
    """What has a partner comes first, in the source's order; the rest after it, in its own.

    Corners keep where they start.
    """
    mesh = target.data
    edited = bmesh.new()
    try:
        edited.from_mesh(mesh)
        kinds = (edited.verts, along.own_vertices), (edited.edges, along.edges), (edited.faces, along.faces)
        for elements, pairs in kinds:
            for element, place in zip(list(elements), _places(pairs, len(elements)).tolist()):
                element.index = place
            elements.sort()
        edited.to_mesh(mesh)
    finally:
        edited.free()
    mesh.update()
    whole = len(along.own_vertices) == len(mesh.vertices) == len(source.data.vertices)
    rest = "all of it" if whole else "the rest after them"
    return [f"Vertex order: {counted(len(along.own_vertices), 'vertex')} as in the source, {rest}"]


def _places(pairs, count):
    """The new number of each element of the target."""
    order = pairs[np.argsort(pairs[:, 0], kind="stable"), 1]
    with_partner = np.zeros(count, bool)
    with_partner[order] = True
    places = np.empty(count, np.int64)
    places[np.concatenate([order, np.flatnonzero(~with_partner)])] = np.arange(count)
    return places
