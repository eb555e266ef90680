"""Transfer: what the source has goes to the target where both are the same."""
import bpy

from . import carry_colours, carry_corners, carry_edges, carry_groups, carry_materials, carry_order, carry_shapes
from . import match_operator, memory, objects, sentences
from .correspondence import Correspondence, Trust
from .refusal import Refusal
from .work import Working

#: By the name of the setting; order is last, since the others go by numbers.
KINDS = {"uv": carry_corners, "groups": carry_groups, "shapes": carry_shapes, "colours": carry_colours,
         "materials": carry_materials, "edges": carry_edges, "order": carry_order}


class QUADMATCH_OT_transfer(Working, bpy.types.Operator):
    """Carry what the source has over to the target, wherever both are the same; shape, pose and faces stay the target's"""
    bl_idname = "quadmatch.transfer"
    bl_label = "Transfer"
    bl_options = {"REGISTER", "UNDO"}

    def gather(self, context):
        settings = context.scene.quadmatch
        if not any(getattr(settings, name) for name in KINDS):
            raise Refusal("nothing is to be transferred; tick what is")
        pair = match_operator.gather_pair(context, edges=True)
        objects.refuse_unless_writable(pair.target)
        return pair

    def compute(self, pair, progress):
        return match_operator.compute_match(pair, progress)

    def apply(self, context, pair, found):
        settings = context.scene.quadmatch
        memory.keep(pair.source, pair.target, pair.arrays, pair.options, found)
        along = Correspondence(*pair.arrays, found, Trust(settings.allow_ambiguous, settings.min_confidence))
        if not len(along.faces):
            why = "no part is the same beyond doubt" if found.matched else "no faces are the same"
            raise Refusal(f"nothing is carried: {why}")
        lines = [f"{len(along.faces):,} of {pair.target.name}'s {pair.arrays[1].face_count:,} faces take the source's data"]
        with objects.object_mode(context, (pair.source, pair.target)):
            for name, kind in KINDS.items():
                if getattr(settings, name):
                    lines += kind.carry(pair.source, pair.target, along)
        return lines + sentences.left_out(along.left_out) + objects.notes_on(pair.source, pair.target)


def register():
    bpy.utils.register_class(QUADMATCH_OT_transfer)


def unregister():
    bpy.utils.unregister_class(QUADMATCH_OT_transfer)
