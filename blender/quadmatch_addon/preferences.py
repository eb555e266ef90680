"""The add-on's preferences: where the program is, should the extension module not fit."""
import bpy

from . import engine


class QuadmatchPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    program: bpy.props.StringProperty(
        name="Program", subtype="FILE_PATH",
        description="The command line program quadmatch, used where the extension module does not fit this Blender. "
                    "Empty: the one on PATH")

    def draw(self, context):
        who, why = engine.state()
        if why:
            self.layout.label(text=f"Note: {why}.", icon="ERROR")
        self.layout.label(text=f"{who}.")
        self.layout.prop(self, "program")


def preferred_program():
    addon = bpy.context.preferences.addons.get(__package__)
    return bpy.path.abspath(addon.preferences.program) if addon and addon.preferences else ""


def register():
    bpy.utils.register_class(QuadmatchPreferences)


def unregister():
    bpy.utils.unregister_class(QuadmatchPreferences)
