"""Which objects may be read and written, and in what mode. Every refusal comes before anything is changed."""
import contextlib

import bpy
import numpy as np

from .refusal import Refusal


def source_and_target(context):
    """The two objects picked in the panel, or else the two selected: the active one is the target."""
    settings = context.scene.quadmatch
    source, target = settings.source, settings.target
    if source is None or target is None:
        picked = [obj for obj in context.selected_objects if obj is not None]
        active = context.view_layer.objects.active
        others = [obj for obj in picked if obj != active]
        if source is None and target is None:
            if len(picked) != 2 or active not in picked:
                raise Refusal("pick a source and a target in the panel, or select two objects, the target last; "
                              f"{len(picked)} {'is' if len(picked) == 1 else 'are'} selected")
            source, target = others[0], active
        else:
            missing = "target" if target is None else "source"
            raise Refusal(f"pick a {missing} in the panel as well, or clear the other one and select two objects")
    refuse_unless_readable(source, context)
    refuse_unless_readable(target, context)
    if source == target:
        raise Refusal(f"{source.name} is source and target; pick two objects (to mirror one there is Mirror Map)")
    if source.data == target.data:
        raise Refusal(f"{source.name} and {target.name} are two objects of one mesh, {source.data.name}, "
                      "so all of it is the same")
    return source, target


def active_mesh(context):
    obj = context.view_layer.objects.active
    if obj is None:
        raise Refusal("no object is active; select one")
    refuse_unless_readable(obj, context)
    return obj


def refuse_unless_readable(obj, context):
    if obj.type != "MESH":
        raise Refusal(f"{obj.name} is no mesh but of type {obj.type.lower()}; convert it to a mesh first")
    if obj.name not in context.view_layer.objects:
        raise Refusal(f"{obj.name} is not in this view layer; pick another object, or enable its collection")
    if obj.mode == "EDIT":
        obj.update_from_editmode()  # what was edited and not yet left edit mode with
    if obj.mode == "SCULPT" and obj.use_dynamic_topology_sculpting:
        raise Refusal(f"{obj.name} is sculpted with dynamic topology; leave sculpt mode first")
    if not obj.data.polygons:
        raise Refusal(f"{obj.name} has no faces")
    if not np.isfinite(_coordinates(obj.data)).all():
        raise Refusal(f"{obj.name} has a vertex whose position is not a finite number; correct it (Mesh > Clean Up)")


def refuse_unless_writable(obj):
    linked = obj if obj.library else obj.data if obj.data.library else None
    if linked is not None:
        raise Refusal(f"{obj.name} is linked from {bpy.path.basename(linked.library.filepath)} and cannot be changed here; "
                      "make it local (Object > Relations > Make Local > Selected Objects and Data)")
    users = obj.data.users - obj.data.use_fake_user
    if users > 1:
        raise Refusal(f"the mesh {obj.data.name} of {obj.name} has {users} users, and all would change; "
                      "make it single-user (Object > Relations > Make Single User > Object & Data)")


def _coordinates(mesh):
    values = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", values)
    return values


@contextlib.contextmanager
def object_mode(context, objects):
    """Out of edit mode (or any other), and back into it afterwards. What was edited is kept."""
    if all(obj.mode == "OBJECT" for obj in objects):
        yield
        return
    active = context.view_layer.objects.active
    mode = active.mode if active else "OBJECT"
    edited = [obj for obj in context.view_layer.objects if obj.mode == mode]
    if mode != "OBJECT":
        bpy.ops.object.mode_set(mode="OBJECT")
    try:
        busy = next((obj for obj in objects if obj.mode != "OBJECT"), None)
        if busy is not None:
            raise Refusal(f"{busy.name} is in {busy.mode.lower()} mode elsewhere; leave it there first")
        yield
    finally:
        if mode != "OBJECT":
            _enter(context, mode, edited)


def _enter(context, mode, objects):
    """Enter a mode on these objects and no others: Blender takes all that are selected."""
    selected = [obj for obj in context.view_layer.objects if obj.select_get()]
    for obj in selected:
        obj.select_set(obj in objects)
    for obj in objects:
        obj.select_set(True)
    bpy.ops.object.mode_set(mode=mode)
    for obj in context.view_layer.objects:
        obj.select_set(obj in selected)


def mirrored(obj):
    """Is the object seen as the mirror image of its mesh: has it a negative scale?"""
    return obj.matrix_world.determinant() < 0


def stored_orientation(seen, source, target):
    """What is seen in the viewport ("auto", "preserving" or "reversing"), as it is between the meshes as stored."""
    if seen == "auto" or mirrored(source) == mirrored(target):
        return seen
    return "reversing" if seen == "preserving" else "preserving"


def notes_on(source, target):
    """What of these objects a user should know: one sentence each."""
    notes = []
    if mirrored(source) != mirrored(target):
        odd = source if mirrored(source) else target
        notes.append(f"{odd.name} has a negative scale, so it is seen mirrored; data go by the meshes as they are stored")
    sizes = [max(abs(x) for x in obj.matrix_world.to_scale()) for obj in (source, target)]
    if not np.isclose(*sizes, rtol=1e-3):
        notes.append(f"scales are different ({sizes[0]:.3g} and {sizes[1]:.3g}); "
                     "meshes are compared without the objects' scales")
    for obj in (source, target):
        shown = [modifier.name for modifier in obj.modifiers if modifier.show_viewport]
        if shown:
            notes.append(f"{obj.name}: what lies beneath the modifiers is matched and changed ({', '.join(shown)})")
    return notes
