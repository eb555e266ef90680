"""What the panel shows and the operators take: the settings of a scene."""
import bpy
from bpy.props import (
    BoolProperty, CollectionProperty, EnumProperty, FloatProperty, IntProperty, IntVectorProperty, PointerProperty,
    StringProperty)

SIDES = [(f"{sign}{axis}", f"{sign}{axis.upper()}",
          f"Copy the {sign}{axis.upper()} side to the other, in the object's own axes") for axis in "xyz" for sign in "+-"]


def is_mesh(_, obj):
    return obj.type == "MESH"


class QuadmatchAnchor(bpy.types.PropertyGroup):
    """An edge of the source and one of the target that are the same, each from its first vertex to its second."""
    source: StringProperty(name="Source object")
    target: StringProperty(name="Target object")
    source_edge: IntVectorProperty(size=2)
    target_edge: IntVectorProperty(size=2)


class QuadmatchChange(bpy.types.PropertyGroup):
    """One of the changes that Diff found: its name, and in `elements`, as JSON, what it is made of."""
    elements: StringProperty()


class QuadmatchSettings(bpy.types.PropertyGroup):
    source: PointerProperty(
        name="Source", type=bpy.types.Object, poll=is_mesh,
        description="What data are taken from. Empty: of two selected objects the one that is not active")
    target: PointerProperty(
        name="Target", type=bpy.types.Object, poll=is_mesh,
        description="What takes the data. Empty: the active object")

    orientation: EnumProperty(name="Orientation", items=[
        ("auto", "Auto", "As it fits, part by part; turned over only where much stays unmatched otherwise"),
        ("preserving", "Same way round", "The target is a copy, as seen in the viewport"),
        ("reversing", "Mirrored", "The target is a mirror image, as seen in the viewport")])
    positions: BoolProperty(
        name="Look at Positions", default=True,
        description="Where connectivity leaves a choice, let edge lengths and positions choose")
    colour: EnumProperty(name="Colour", items=[
        ("state", "By State", "Blue is matched, yellow ambiguous, red unmatched"),
        ("place", "By Place", "Faces that are the same have the same colour, that of their place in the source"),
        ("none", "Nothing", "No colour attribute")])
    select: BoolProperty(
        name="Select Unmatched", default=True,
        description="Enter edit mode with the unmatched faces selected")
    anchors: CollectionProperty(type=QuadmatchAnchor)

    uv: BoolProperty(name="UV Maps", default=True)
    groups: BoolProperty(name="Vertex Groups", default=True)
    shapes: BoolProperty(name="Shape Keys", default=True)
    colours: BoolProperty(name="Colour Attributes", default=True)
    materials: BoolProperty(name="Materials", default=True)
    edges: BoolProperty(name="Seams, Sharp, Creases", default=True)
    order: BoolProperty(
        name="Vertex Order", default=False,
        description="Number the target's vertices, edges and faces as the source's")
    allow_ambiguous: BoolProperty(
        name="Ambiguous Parts Too", default=False,
        description="Also write where parts fit in several ways, of which one was taken")
    min_confidence: FloatProperty(
        name="Least Confidence", min=0, max=1, default=0,
        description="Leave out regions of which a smaller share of the extraordinary vertices agrees")

    side: EnumProperty(name="From", items=SIDES)
    symmetrize_positions: BoolProperty(
        name="Positions", default=True,
        description="Mirror positions in the plane of a model at rest")
    symmetrize_groups: BoolProperty(
        name="Vertex Groups", default=True,
        description="Copy weights in any pose; .L and .R change places")
    symmetrize_selection: BoolProperty(name="Selection", default=False, description="Copy the selection in any pose")

    tolerance: FloatProperty(
        name="Tolerance", min=0, default=1e-5, precision=6,
        description="How far a vertex may be from where it was and not count as moved, in shares of the source's size")
    changes: CollectionProperty(type=QuadmatchChange)
    change: IntProperty(name="Change")
    report: StringProperty(description="What the last operation said, line by line")


CLASSES = (QuadmatchAnchor, QuadmatchChange, QuadmatchSettings)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Scene.quadmatch = PointerProperty(type=QuadmatchSettings)


def unregister():
    del bpy.types.Scene.quadmatch
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)
