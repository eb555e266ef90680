"""Draws the panel in a real window, after a Match that was run as by its button: blender --enable-event-simulate --python draw_panel.py -- ZIP PNG

Steps follow each other by a timer, since Blender draws and handles events only in between. On the way Esc is pressed
during a match of a larger model, which must leave it as it was.
"""
import pathlib
import sys
import traceback

import bpy

zip_file, picture = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
bpy.ops.preferences.addon_install(filepath=zip_file, overwrite=True)
bpy.ops.preferences.addon_enable(module="quadmatch_addon")
bpy.context.preferences.view.show_splash = False

import scene

TAB = (12, 132)  # where the tab quadmatch is, below Tool and View: from the right and from the top of the sidebar


def view():
    window = bpy.context.window_manager.windows[0]
    area = next(area for area in window.screen.areas if area.type == "VIEW_3D")
    return window, area


def region(area, kind):
    return next(region for region in area.regions if region.type == kind)


def run(operator):
    """As a button runs it."""
    window, area = view()
    with bpy.context.temp_override(window=window, area=area, region=region(area, "WINDOW")):
        return operator("INVOKE_DEFAULT")


def press(key, x=0, y=0):
    window, _ = view()
    for value in ("PRESS", "RELEASE"):
        window.event_simulate(key, value, x=x, y=y)


def open_scene():
    scene.clear()
    bears = [scene.load(scene.ROOT / "examples" / name, title) for name, title in (("bear.obj", "Bear"), ("bear_no_ears_posed.obj", "Edited"))]
    bears[1].location.x = 2.6
    settings = bpy.context.scene.quadmatch
    settings.source, settings.target = bears
    settings.select = False
    _, area = view()
    space = area.spaces.active
    space.show_region_ui, space.show_region_toolbar = True, False
    space.overlay.show_wireframes, space.overlay.wireframe_opacity = True, 0.25
    space.shading.color_type = "VERTEX"
    space.overlay.show_floor = space.overlay.show_axis_x = space.overlay.show_axis_y = space.overlay.show_cursor = False
    space.overlay.show_axis_y = space.overlay.show_ortho_grid = space.overlay.show_text = False
    space.show_gizmo = False
    for obj in bears:
        obj.select_set(False)


def frame():
    window, area = view()
    with bpy.context.temp_override(window=window, area=area, region=region(area, "WINDOW")):
        bpy.ops.screen.screen_full_area(use_hide_panels=False)


def look():
    window, area = view()
    with bpy.context.temp_override(window=window, area=area, region=region(area, "WINDOW")):
        bpy.ops.view3d.view_axis(type="TOP")  # these files have y up
        bpy.ops.view3d.view_all()


def open_tab():
    _, area = view()
    sidebar = region(area, "UI")
    press("LEFTMOUSE", sidebar.x + sidebar.width - TAB[0], sidebar.y + sidebar.height - TAB[1])


def match():
    if run(bpy.ops.quadmatch.match) != {"RUNNING_MODAL"}:
        raise RuntimeError("the match does not run beside Blender")


def grow():
    """A model that takes a while, twice."""
    scene.clear()
    obj = scene.load(scene.ROOT / "examples" / "bear.obj", "Large")
    obj.modifiers.new("Finer", "SUBSURF").levels = 3
    mesh = bpy.data.meshes.new_from_object(obj.evaluated_get(bpy.context.evaluated_depsgraph_get()))
    settings = bpy.context.scene.quadmatch
    settings.source, settings.target = scene.add_object("One", mesh), scene.add_object("Other", mesh.copy())


def begin_and_stop():
    match()
    press("ESC")


def see_nothing():
    if bpy.context.scene.quadmatch.report or "quadmatch" in bpy.data.objects["One"].data.color_attributes:
        raise RuntimeError("Esc did not stop the match")


def see():
    if not bpy.context.scene.quadmatch.report.startswith("2,644 faces are the same"):
        raise RuntimeError("the match has not ended: " + bpy.context.scene.quadmatch.report)


def draw():
    window, area = view()
    with bpy.context.temp_override(window=window, area=area):
        bpy.ops.screen.screenshot(filepath=str(pathlib.Path(picture).resolve()))
    print("drawn", picture, flush=True)


steps = [grow, begin_and_stop, None, see_nothing, open_scene, frame, look, open_tab, match, None, None, see, None, draw]


def next_step():
    try:
        step = steps.pop(0)
        if step:
            step()
    except Exception:
        traceback.print_exc()
        steps.clear()
    if not steps:
        bpy.ops.wm.quit_blender()
        return None
    return 1.0


bpy.app.timers.register(next_step, first_interval=2.0)
