"""quadmatch in Blender: which parts of two meshes are the same, and what that is good for.

A front end: operators gather arrays, call the library (library.py) or else the program (program.py), write what comes
back into Blender's data and say what they did. See docs/blender.md and docs/design/023-blender.md.
"""

bl_info = {
    "name": "quadmatch",
    "description": "Finds which parts of two meshes are the same, from connectivity alone, and carries data over",
    "author": "The quadmatch project",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > quadmatch",
    "category": "Mesh",
}

from . import (
    anchors, diff_operators, match_operator, memory, panel, preferences, properties, symmetry_operators, transfer_operator)

MODULES = (
    preferences, properties, anchors, match_operator, transfer_operator, symmetry_operators, diff_operators, panel)


def register():
    for module in MODULES:
        module.register()


def unregister():
    for module in reversed(MODULES):
        module.unregister()
    memory.forget_all()
