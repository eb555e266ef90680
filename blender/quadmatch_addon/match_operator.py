"""Match: which faces of two objects are the same, shown as colours and as a selection."""
import dataclasses

import bpy
import numpy as np

from . import anchors, colours, engine, memory, objects, selection, sentences
from .mesh_arrays import arrays_of
from .refusal import Refusal
from .work import Working


@dataclasses.dataclass
class Pair:
    """What Match, Transfer and Diff start from."""
    source: object
    target: object
    arrays: tuple
    options: engine.Options
    known: object  #: the last match of these two where it still holds, or None

    names: tuple = ()

    def __post_init__(self):
        self.names = self.source.name, self.target.name  # read here: compute() is in another thread


def gather_pair(context, edges=False):
    settings = context.scene.quadmatch
    source, target = objects.source_and_target(context)
    arrays = arrays_of(source.data, edges), arrays_of(target.data, edges)
    orientation = objects.stored_orientation(settings.orientation, source, target)
    rows = anchors.rows(settings, source, target, arrays, orientation)
    options = engine.Options(orientation, settings.positions, rows)
    return Pair(source, target, arrays, options, memory.recall(source, target, arrays, options))


def compute_match(pair, progress):
    return pair.known or engine.match(*pair.arrays, pair.names, pair.options, progress)


def unmatched(found, arrays):
    """Which faces of source and target have no partner."""
    both = [np.ones(mesh.face_count, bool) for mesh in arrays]
    for region in found.regions:
        for side, faces in enumerate(both):
            faces[region.faces[:, side]] = False
    return both


class QUADMATCH_OT_match(Working, bpy.types.Operator):
    """Find which faces of source and target are the same, from connectivity alone"""
    bl_idname = "quadmatch.match"
    bl_label = "Match"
    bl_options = {"REGISTER", "UNDO"}

    def gather(self, context):
        settings = context.scene.quadmatch
        pair = gather_pair(context)
        if settings.colour != "none" or settings.select:
            for obj in (pair.source, pair.target):
                objects.refuse_unless_writable(obj)
        if settings.colour != "none":
            for obj in (pair.source, pair.target):
                if not colours.room_for(obj.data):
                    raise Refusal(f"{obj.name} has another attribute called {colours.NAME}; rename it, "
                                  "or set Colour to Nothing")
        return pair

    def compute(self, pair, progress):
        return engine.match(*pair.arrays, pair.names, pair.options, progress)

    def apply(self, context, pair, found):
        settings = context.scene.quadmatch
        memory.keep(pair.source, pair.target, pair.arrays, pair.options, found)
        lines = sentences.match_lines(found, pair.source, pair.target, pair.arrays)
        lines += objects.notes_on(pair.source, pair.target)
        both = list(zip((pair.source, pair.target), pair.arrays))
        with objects.object_mode(context, (pair.source, pair.target)):
            if settings.colour != "none":
                for (obj, arrays), painted in zip(both, colours.WAYS[settings.colour](found, pair.arrays)):
                    colours.paint(obj.data, arrays, painted)
            if settings.select:
                for (obj, arrays), faces in zip(both, unmatched(found, pair.arrays)):
                    hidden = selection.select_faces(obj.data, arrays, faces)
                    if hidden:
                        lines.append(f"{obj.name}: {sentences.counted(hidden, 'unmatched face')} hidden, so not selected")
        if settings.select:
            lines += [f"{name} is hidden; it is not opened in edit mode"
                      for name in selection.edit(context, (pair.source, pair.target), pair.target, "FACE", self.bl_label)]
        return lines


def register():
    bpy.utils.register_class(QUADMATCH_OT_match)


def unregister():
    bpy.utils.unregister_class(QUADMATCH_OT_match)
