"""Mirror Map: which vertex lies opposite which. Symmetrize: one side copied to the other."""
import dataclasses

import bpy
import numpy as np

from . import colours, engine, mirror_copy, objects, selection, sentences
from .mesh_arrays import arrays_of
from .refusal import Refusal
from .sides import sides_of_faces
from .work import Working

MAP = "quadmatch_mirror"


@dataclasses.dataclass
class Model:
    obj: object
    arrays: object
    positions: bool
    name: str


def gather_model(context):
    obj = objects.active_mesh(context)
    objects.refuse_unless_writable(obj)
    return Model(obj, arrays_of(obj.data, edges=True), context.scene.quadmatch.positions, obj.name)


def compute_mirror(model, progress):
    mirror = engine.symmetry(model.arrays, model.name, model.positions, progress)
    if not mirror.found.matched:
        raise Refusal(f"{model.name} has no mirror: no part of it is the mirror image of another by connectivity")
    return mirror


def mirror_lines(model, mirror):
    paired = model.arrays.face_count - len(mirror.unpaired_faces)
    faces = model.arrays.face_count
    lines = [f"{sentences.percent(paired, faces)} of {faces:,} faces have a mirror image, {faces - paired:,} have none",
             f"Centre line: {sentences.counted(len(mirror.line_vertices), 'vertex')}"]
    if mirror.mirrors > 1:
        lines.append(f"Ambiguous: {mirror.mirrors} mirrors fit as well, one was taken")
    if mirror.plane and not mirror.plane[3]:
        lines.append(f"Posed: no plane; the best one misses by {100 * mirror.plane[2]:.1f} % of the size")
    return lines


class QUADMATCH_OT_mirror_map(Working, bpy.types.Operator):
    """Find which vertex lies opposite which, in any pose, and select what has no partner"""
    bl_idname = "quadmatch.mirror_map"
    bl_label = "Mirror Map"
    bl_options = {"REGISTER", "UNDO"}

    def gather(self, context):
        model = gather_model(context)
        there = model.obj.data.attributes.get(MAP)
        if there is not None and (there.domain, there.data_type) != ("POINT", "INT"):
            raise Refusal(f"{model.name} has another attribute called {MAP}; rename it")
        if context.scene.quadmatch.colour != "none" and not colours.room_for(model.obj.data):
            raise Refusal(f"{model.name} has another attribute called {colours.NAME}; rename it, or set Colour to Nothing")
        return model

    def compute(self, model, progress):
        return compute_mirror(model, progress)

    def apply(self, context, model, mirror):
        settings, mesh = context.scene.quadmatch, model.obj.data
        lines = mirror_lines(model, mirror)
        unpaired = np.zeros(model.arrays.face_count, bool)
        unpaired[mirror.unpaired_faces] = True
        with objects.object_mode(context, (model.obj,)):
            if mesh.attributes.get(MAP) is None:
                mesh.attributes.new(MAP, "INT", "POINT")
            mesh.attributes[MAP].data.foreach_set("value", mirror.vertex_map(model.arrays.vertex_count))
            if settings.colour != "none":
                colours.paint(mesh, model.arrays, _side_colours(model, mirror, settings.side, unpaired))
            if settings.select:
                hidden = selection.select_faces(mesh, model.arrays, unpaired)
                if hidden:
                    lines.append(f"{sentences.counted(hidden, 'face')} without partner hidden, so not selected")
        if settings.select:
            lines += [f"{name} is hidden; it is not opened in edit mode"
                      for name in selection.edit(context, (model.obj,), model.obj, "FACE", self.bl_label)]
        return lines


def _side_colours(model, mirror, side, unpaired):
    sides = sides_of_faces(model.arrays, mirror, side)
    painted = np.tile(np.float32(colours.CENTRE), (model.arrays.face_count, 1))
    painted[sides > 0] = colours.MATCHED
    painted[sides < 0] = colours.AMBIGUOUS
    painted[unpaired] = colours.UNMATCHED
    return painted


class QUADMATCH_OT_symmetrize(Working, bpy.types.Operator):
    """Copy one side of the active object to the other by connectivity; what has no partner stays as it is"""
    bl_idname = "quadmatch.symmetrize"
    bl_label = "Symmetrize"
    bl_options = {"REGISTER", "UNDO"}

    def gather(self, context):
        settings = context.scene.quadmatch
        if not (settings.symmetrize_positions or settings.symmetrize_groups or settings.symmetrize_selection):
            raise Refusal("nothing is to be copied; tick what is")
        return gather_model(context)

    def compute(self, model, progress):
        return compute_mirror(model, progress)

    def apply(self, context, model, mirror):
        settings = context.scene.quadmatch
        sides = sides_of_faces(model.arrays, mirror, settings.side)
        if not (sides > 0).any():
            raise Refusal(f"no part of {model.name} lies farther to {settings.side} than its mirror image; "
                          "choose another side")
        if settings.symmetrize_positions and (mirror.plane is None or not mirror.plane[3]):
            missed = f", the best plane misses by {100 * mirror.plane[2]:.1f} % of its size" if mirror.plane else ""
            raise Refusal(f"{model.name} is posed{missed}: positions cannot be mirrored; pose it back, or untick Positions")
        pairs = mirror_copy.vertex_pairs(model.arrays, mirror, sides)
        lines = [f"{len(pairs):,} vertices of the {settings.side} side copied to the other"]
        with objects.object_mode(context, (model.obj,)):
            if settings.symmetrize_positions:
                lines += mirror_copy.copy_positions(model.obj, model.arrays, pairs, mirror)
            if settings.symmetrize_groups:
                lines += mirror_copy.copy_groups(model.obj, pairs)
            if settings.symmetrize_selection:
                mirror_copy.copy_selection(model.obj.data, model.arrays, pairs)
        return lines + mirror_lines(model, mirror)


CLASSES = (QUADMATCH_OT_mirror_map, QUADMATCH_OT_symmetrize)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)


def unregister():
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
