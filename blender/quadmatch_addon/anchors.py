"""Anchors: an edge of the source and one of the target that are the same, from the edit-mode selection."""
import bmesh
import bpy
import numpy as np

from . import objects
from .refusal import Refusal


def rows(settings, source, target, arrays, orientation):
    """Rows (source face, corner, target face, corner) for the engine, of the anchors of these two objects."""
    found = []
    for anchor in settings.anchors:
        if (anchor.source, anchor.target) != (source.name, target.name):
            continue
        here = corner_left_of(arrays[0], *anchor.source_edge, source.name)
        # Turned over, what is to the left of the source's edge is to the right of the target's.
        side = corner_right_of if orientation == "reversing" else corner_left_of
        found.append((*here, *side(arrays[1], *anchor.target_edge, target.name)))
    return tuple(found)


def corner_left_of(mesh, a, b, name):
    """(face, corner) at `a` of the face that goes from vertex a to b."""
    at_a = np.flatnonzero(mesh.corners == a)
    face = mesh.face_of_corner[at_a]
    following = mesh.starts[face] + (at_a - mesh.starts[face] + 1) % mesh.sizes[face]
    return _one(mesh, at_a[mesh.corners[following] == b], a, b, name)


def corner_right_of(mesh, a, b, name):
    """(face, corner) at `a` of the face that goes from vertex b to a."""
    at_a = np.flatnonzero(mesh.corners == a)
    face = mesh.face_of_corner[at_a]
    before = mesh.starts[face] + (at_a - mesh.starts[face] - 1) % mesh.sizes[face]
    return _one(mesh, at_a[mesh.corners[before] == b], a, b, name)


def _one(mesh, corners, a, b, name):
    if not len(corners):
        raise Refusal(f"anchor: {name} has no face on that side of the edge from vertex {a} to {b}; "
                      "select the two vertices in the other order on both objects, or remove the anchor")
    face = int(mesh.face_of_corner[corners[0]])
    return face, int(corners[0] - mesh.starts[face])


def selected_edge(obj):
    """The two vertices selected one after the other, which an edge joins."""
    if obj.mode != "EDIT":
        raise Refusal(f"{obj.name} is not in edit mode; edit both objects at once (select both, Tab)")
    mesh = bmesh.from_edit_mesh(obj.data)
    picked = [element for element in mesh.select_history if isinstance(element, bmesh.types.BMVert)]
    if len(picked) != 2 or sum(vertex.select for vertex in mesh.verts) != 2:
        raise Refusal(f"{obj.name}: select two vertices of an edge one after the other, in the same order on both "
                      f"objects; {sum(vertex.select for vertex in mesh.verts)} are selected")
    if not any(edge.other_vert(picked[0]) == picked[1] for edge in picked[0].link_edges):
        raise Refusal(f"{obj.name}: no edge joins the two selected vertices")
    return tuple(vertex.index for vertex in picked)


class QUADMATCH_OT_add_anchor(bpy.types.Operator):
    """Say that the selected edges of source and target are the same: on each, two vertices one after the other"""
    bl_idname = "quadmatch.add_anchor"
    bl_label = "Add Anchor"
    bl_options = {"REGISTER", "UNDO"}

    def execute(self, context):
        settings = context.scene.quadmatch
        try:
            source, target = objects.source_and_target(context)
            edges = selected_edge(source), selected_edge(target)
        except Refusal as refusal:
            self.report({"ERROR"}, f"{refusal}.")
            return {"CANCELLED"}
        anchor = settings.anchors.add()
        anchor.source, anchor.target = source.name, target.name
        anchor.source_edge, anchor.target_edge = edges
        self.report({"INFO"}, "Anchor: the edge {} to {} of {} is {} to {} of {}".format(
            *edges[0], source.name, *edges[1], target.name))
        return {"FINISHED"}


class QUADMATCH_OT_remove_anchor(bpy.types.Operator):
    """Forget this anchor"""
    bl_idname = "quadmatch.remove_anchor"
    bl_label = "Remove Anchor"
    bl_options = {"REGISTER", "UNDO"}

    index: bpy.props.IntProperty(default=-1, options={"SKIP_SAVE"}, description="Which one; -1: all")

    def execute(self, context):
        anchors = context.scene.quadmatch.anchors
        if self.index < 0:
            anchors.clear()
        else:
            anchors.remove(self.index)
        return {"FINISHED"}


CLASSES = (QUADMATCH_OT_add_anchor, QUADMATCH_OT_remove_anchor)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)


def unregister():
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
