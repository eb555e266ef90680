"""Diff: what was changed from source to target, as a list to select from."""
import json

import bpy
import numpy as np

from . import engine, match_operator, objects, selection, sentences
from .mesh_arrays import arrays_of
from .refusal import Refusal
from .work import Working


class QUADMATCH_OT_diff(Working, bpy.types.Operator):
    """Name what was changed from source to target, part by part, and select it on both"""
    bl_idname = "quadmatch.diff"
    bl_label = "Diff"
    bl_options = {"REGISTER", "UNDO"}

    def gather(self, context):
        pair = match_operator.gather_pair(context)
        for obj in (pair.source, pair.target):
            objects.refuse_unless_writable(obj)
        self._tolerance = context.scene.quadmatch.tolerance
        return pair

    def compute(self, pair, progress):
        return engine.diff(*pair.arrays, pair.names, pair.options, self._tolerance, progress)

    def apply(self, context, pair, found):
        settings = context.scene.quadmatch
        settings.changes.clear()
        for change in found.changes:
            _add(settings, label_of(change), pair, faces=faces_of(change, found.match))
        if len(found.moved):
            _add(settings, f"moved: {sentences.counted(len(found.moved), 'vertex')}", pair, vertices=found.moved.T)
        settings.change = 0
        hidden = _select_all(context, pair, found)
        doubts = sentences.doubts(region for region in found.match.regions if region.ambiguous)
        return [summary(found), *(item.name for item in settings.changes), *hidden, *doubts,
                *objects.notes_on(pair.source, pair.target)]


def summary(found):
    if not found.changes and not len(found.moved):
        return "no differences"
    return f"{sentences.counted(len(found.changes), 'change')}, {sentences.counted(len(found.moved), 'vertex')} moved"


def _select_all(context, pair, found):
    faces = [faces_of(change, found.match) for change in found.changes]
    if not faces:
        return []
    return select(context, pair, [np.concatenate([both[side] for both in faces]) for side in (0, 1)])


def label_of(change):
    sides = (change.target_faces, "added"), (change.source_faces, "removed")
    parts = [f"{len(faces):,} {word}" for faces, word in sides if len(faces)]
    if not parts:
        return f"{change.kind}: {len(change.rejoined):,} faces joined otherwise"
    return f"{change.kind}: faces {', '.join(parts)}"


def faces_of(change, match):
    """Faces of source and target to select: what came and went, or else what has other neighbours."""
    if len(change.source_faces) or len(change.target_faces):
        return change.source_faces, change.target_faces
    partner = {int(face): int(there) for region in match.regions for face, there, _ in region.faces}
    return change.rejoined, np.array([partner[face] for face in change.rejoined.tolist() if face in partner], int)


def _add(settings, label, pair, **elements):
    item = settings.changes.add()
    item.name = label
    item.elements = json.dumps({"objects": pair.names, "fingerprints": [mesh.fingerprint for mesh in pair.arrays],
                                **{kind: [rows.tolist() for rows in both] for kind, both in elements.items()}})


def select(context, pair, elements, kind="faces"):
    """Select faces or vertices of both objects and nothing else, in edit mode. Returns lines on what is hidden."""
    with objects.object_mode(context, (pair.source, pair.target)):
        for obj, mesh, rows in zip((pair.source, pair.target), pair.arrays, elements):
            chosen = np.zeros(mesh.face_count if kind == "faces" else mesh.vertex_count, bool)
            chosen[rows] = True
            write = selection.select_faces if kind == "faces" else selection.select_vertices
            write(obj.data, mesh, chosen)
    mode = "FACE" if kind == "faces" else "VERT"
    hidden = selection.edit(context, (pair.source, pair.target), pair.target, mode, "Select Differences")
    return [f"{name} is hidden; it is not opened in edit mode" for name in hidden]


class QUADMATCH_OT_select_change(bpy.types.Operator):
    """Select what this change added, removed or moved, on both objects"""
    bl_idname = "quadmatch.select_change"
    bl_label = "Select Change"
    bl_options = {"REGISTER", "UNDO"}

    index: bpy.props.IntProperty(default=-1, options={"SKIP_SAVE"},
                                 description="Which change of the list; -1: the active one")

    def execute(self, context):
        settings = context.scene.quadmatch
        index = settings.change if self.index < 0 else self.index
        try:
            if not 0 <= index < len(settings.changes):
                raise Refusal("there is no such change; run Diff first")
            said = json.loads(settings.changes[index].elements)
            kind = "faces" if "faces" in said else "vertices"
            select(context, _pair_of(context, said), said[kind], kind)
        except Refusal as refusal:
            self.report({"ERROR"}, f"{refusal}.")
            return {"CANCELLED"}
        return {"FINISHED"}


def _pair_of(context, said):
    """The two objects of a list, if they are still what they were."""
    both = [context.scene.objects.get(name) for name in said["objects"]]
    for obj, name in zip(both, said["objects"]):
        if obj is None:
            raise Refusal(f"{name} is not there any more; run Diff again")
        objects.refuse_unless_readable(obj, context)
    arrays = tuple(arrays_of(obj.data) for obj in both)
    for obj, mesh, fingerprint in zip(both, arrays, said["fingerprints"]):
        if mesh.fingerprint != fingerprint:
            raise Refusal(f"{obj.name} was changed since; run Diff again")
    return match_operator.Pair(*both, arrays, None, None)


CLASSES = (QUADMATCH_OT_diff, QUADMATCH_OT_select_change)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)


def unregister():
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
