"""Mirror Map: which vertex lies opposite which. Symmetrize: one side copied to the other."""
import dataclasses

import bpy
import numpy as np

from . import carry_groups, colours, engine, objects, selection, sentences
from .mesh_arrays import arrays_of, read
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
    lines = [f"{sentences.percent(paired, model.arrays.face_count)} of {model.arrays.face_count:,} faces have a mirror image, {len(mirror.unpaired_faces):,} have none"]
    lines.append(f"Centre line: {len(mirror.line_vertices):,} vertices")
    if mirror.mirrors > 1:
        lines.append(f"Ambiguous: {mirror.mirrors} mirrors fit as well, one was taken")
    if mirror.plane and not mirror.plane[3]:
        lines.append(f"Posed: no plane; the best one misses by {100 * mirror.plane[2]:.1f} % of the size")
    return lines


class QUADMATCH_OT_mirror_map(Working, bpy.types.Operator):
    """Find which vertex lies opposite which, in any pose: as the attribute quadmatch_mirror, as colours and as a selection of what has no partner"""
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
            lines += [f"{name} is hidden; it is not opened in edit mode" for name in selection.edit(context, (model.obj,), model.obj, "FACE", self.bl_label)]
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
            raise Refusal(f"no part of {model.name} lies farther to {settings.side} than its mirror image; choose another side")
        if settings.symmetrize_positions and (mirror.plane is None or not mirror.plane[3]):
            missed = f", the best plane misses by {100 * mirror.plane[2]:.1f} % of its size" if mirror.plane else ""
            raise Refusal(f"{model.name} is posed{missed}: positions cannot be mirrored; pose it back, or untick Positions")
        pairs = vertex_pairs(model.arrays, mirror, sides)
        lines = [f"{len(pairs):,} vertices of the {settings.side} side copied to the other"]
        with objects.object_mode(context, (model.obj,)):
            if settings.symmetrize_positions:
                lines += copy_positions(model.obj, model.arrays, pairs, mirror)
            if settings.symmetrize_groups:
                lines += copy_groups(model.obj, pairs)
            if settings.symmetrize_selection:
                copy_selection(model.obj.data, model.arrays, pairs)
        return lines + mirror_lines(model, mirror)


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
    weights = [{opposite[element.group].index: element.weight for element in vertices[vertex].groups if element.group in opposite}
               for vertex in pairs[:, 0].tolist()]
    carry_groups.write(obj, obj.vertex_groups, pairs[:, 1].tolist(), weights)
    return [sentences.counted(len(obj.vertex_groups), "vertex group")]


def copy_selection(mesh, arrays, pairs):
    selected = read(mesh.vertices, "select", arrays.vertex_count, bool)
    selected[pairs[:, 1]] = selected[pairs[:, 0]]
    selection.select_vertices(mesh, arrays, selected)


CLASSES = (QUADMATCH_OT_mirror_map, QUADMATCH_OT_symmetrize)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)


def unregister():
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
