"""The sidebar: N in the 3D viewport, tab quadmatch."""
import textwrap

import bpy

from . import engine

LETTER = 6.2  # width in pixels at a scale of 1, on the whole
MARGIN = 64  # of icon, indent and tabs


class Sidebar:
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "quadmatch"


class Child(Sidebar):
    bl_parent_id = "QUADMATCH_PT_main"


def text(context, layout, line, icon="NONE"):
    """A sentence, broken into as many lines as it needs in a sidebar of this width."""
    scale = context.preferences.system.ui_scale
    letters = max(16, int((context.region.width / scale - MARGIN) / LETTER))
    for number, part in enumerate(textwrap.wrap(line, letters) or [""]):
        layout.label(text=part, icon=icon if number == 0 else "BLANK1" if icon != "NONE" else "NONE")


class QUADMATCH_PT_main(Sidebar, bpy.types.Panel):
    bl_label = "quadmatch"

    def draw(self, context):
        layout, settings = self.layout, context.scene.quadmatch
        who, why = engine.state()
        if why:
            box = layout.box().column(align=True)
            text(context, box, why[0].upper() + why[1:] + ".", "ERROR")
            text(context, box, who[0].upper() + who[1:] + ".")
        column = layout.column(align=True)
        column.prop(settings, "source")
        column.prop(settings, "target")
        if settings.source is None and settings.target is None:
            text(context, layout, "Or select two objects, the target last.")
        column = layout.column(align=True)
        column.prop(settings, "orientation", text="")
        column.prop(settings, "positions")


class QUADMATCH_PT_match(Child, bpy.types.Panel):
    bl_label = "Match"

    def draw(self, context):
        layout, settings = self.layout, context.scene.quadmatch
        layout.prop(settings, "colour")
        layout.prop(settings, "select")
        layout.operator("quadmatch.match", icon="UV_SYNC_SELECT")
        shading = getattr(context.space_data, "shading", None)
        if settings.colour != "none" and shading and shading.type == "SOLID" and shading.color_type != "VERTEX":
            layout.prop_enum(shading, "color_type", "VERTEX", text="Show the Colours")


class QUADMATCH_PT_anchors(Child, bpy.types.Panel):
    bl_label = "Anchors"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, settings = self.layout, context.scene.quadmatch
        for index, anchor in enumerate(settings.anchors):
            row = layout.row()
            row.label(text="{} {}-{} = {} {}-{}".format(anchor.source, *anchor.source_edge,
                                                        anchor.target, *anchor.target_edge))
            row.operator("quadmatch.remove_anchor", text="", icon="X", emboss=False).index = index
        if not settings.anchors:
            text(context, layout, "In edit mode of both objects select two vertices of an edge one after the other, "
                                  "the same on both.")
        layout.operator("quadmatch.add_anchor", icon="ADD")


class QUADMATCH_PT_transfer(Child, bpy.types.Panel):
    bl_label = "Transfer"

    def draw(self, context):
        layout, settings = self.layout, context.scene.quadmatch
        kinds = layout.column(align=True)
        for name in ("uv", "groups", "shapes", "colours", "materials", "edges", "order"):
            kinds.prop(settings, name)
        column = layout.column(align=True)
        column.prop(settings, "allow_ambiguous")
        column.prop(settings, "min_confidence", slider=True)
        layout.operator("quadmatch.transfer", icon="MOD_DATA_TRANSFER")


class QUADMATCH_PT_mirror(Child, bpy.types.Panel):
    bl_label = "Mirror"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, settings = self.layout, context.scene.quadmatch
        text(context, layout, "Of the active object, in any pose.")
        layout.operator("quadmatch.mirror_map", icon="MOD_MIRROR")
        row = layout.row(align=True)
        row.prop(settings, "side", expand=True)
        column = layout.column(align=True)
        for name in ("symmetrize_positions", "symmetrize_groups", "symmetrize_selection"):
            column.prop(settings, name)
        layout.operator("quadmatch.symmetrize")


class QUADMATCH_PT_diff(Child, bpy.types.Panel):
    bl_label = "Diff"
    bl_options = {"DEFAULT_CLOSED"}

    def draw(self, context):
        layout, settings = self.layout, context.scene.quadmatch
        layout.prop(settings, "tolerance")
        layout.operator("quadmatch.diff", icon="SELECT_DIFFERENCE")
        if settings.changes:
            layout.template_list("UI_UL_list", "quadmatch_changes", settings, "changes", settings, "change", rows=3)
            layout.operator("quadmatch.select_change", icon="RESTRICT_SELECT_OFF")


class QUADMATCH_PT_report(Child, bpy.types.Panel):
    bl_label = "Report"

    @classmethod
    def poll(cls, context):
        return bool(context.scene.quadmatch.report)

    def draw(self, context):
        column = self.layout.column(align=True)
        for line in context.scene.quadmatch.report.split("\n"):
            text(context, column, line, "DOT")


CLASSES = (QUADMATCH_PT_main, QUADMATCH_PT_match, QUADMATCH_PT_report, QUADMATCH_PT_anchors, QUADMATCH_PT_transfer,
           QUADMATCH_PT_mirror, QUADMATCH_PT_diff)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)


def unregister():
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
