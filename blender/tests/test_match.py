"""Match: colours, selection, what is said; and that it can be cancelled."""
import bpy
import numpy as np

import scene
from case import Case

from quadmatch_addon import colours, engine, work
from quadmatch_addon.mesh_arrays import arrays_of
from quadmatch_addon.refusal import Cancelled


class Match(Case):
    def setUp(self):
        super().setUp()
        self.source = scene.load(scene.ROOT / "examples" / "bear.obj", "Source")
        self.target = scene.load(scene.ROOT / "examples" / "bear_no_ears_posed.obj", "Target")
        self.pick(self.source, self.target)

    def selected(self, obj):
        bpy.ops.object.mode_set(mode="OBJECT")
        return scene.numbers(obj.data.polygons, "select", 1, bool)

    def face_colours(self, obj):
        if obj.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        corners = scene.numbers(obj.data.color_attributes["quadmatch"].data, "color", 4).reshape(-1, 4, 4)
        self.assertTrue((corners == corners[:, :1]).all())
        return corners[:, 0]

    def test_it_counts_what_is_the_same(self):
        lines = self.call(bpy.ops.quadmatch.match)
        self.assertEqual(lines[:3], ["2,644 faces are the same", "Source: 89.8 % of 2,944, 300 unmatched", "Target: 98.3 % of 2,688, 44 unmatched"])
        self.assertTrue(lines[3].startswith("1 region, the largest 2,644, confidence "), lines[3])

    def test_two_selected_objects_do_as_well_the_active_one_is_the_target(self):
        self.pick(None, None)
        for obj in (self.source, self.target):
            obj.select_set(True)
        bpy.context.view_layer.objects.active = self.target
        self.assertEqual(self.call(bpy.ops.quadmatch.match)[2], "Target: 98.3 % of 2,688, 44 unmatched")

    def test_unmatched_faces_are_red_and_selected_in_edit_mode(self):
        self.call(bpy.ops.quadmatch.match)
        self.assertEqual((self.source.mode, self.target.mode), ("EDIT", "EDIT"))
        self.assertEqual(tuple(bpy.context.tool_settings.mesh_select_mode), (False, False, True))
        for obj, unmatched in ((self.source, 300), (self.target, 44)):
            selected = self.selected(obj)
            self.assertEqual(selected.sum(), unmatched)
            red = np.abs(self.face_colours(obj) - colours.UNMATCHED).max(axis=1) < 0.01
            np.testing.assert_array_equal(red, selected)
            self.assertEqual(obj.data.color_attributes.active_color.name, "quadmatch")

    def test_faces_that_are_the_same_have_the_same_colour_by_place(self):
        self.settings.colour = "place"
        self.call(bpy.ops.quadmatch.match)
        grey = [0.2, 0.2, 0.2, 1]
        kinds = [set(map(tuple, self.face_colours(obj).round(2).tolist())) - {tuple(grey)} for obj in (self.source, self.target)]
        self.assertGreater(len(kinds[1]), 500)
        self.assertGreater(len(kinds[0] & kinds[1]) / len(kinds[1]), 0.99)

    def test_hidden_faces_stay_hidden_and_unselected(self):
        self.source.data.polygons.foreach_set("hide", np.ones(2944, bool))
        lines = self.call(bpy.ops.quadmatch.match)
        self.assertIn("Source: 300 unmatched faces hidden, so not selected", lines)
        self.assertEqual(self.selected(self.source).sum(), 0)

    def test_hidden_faces_of_a_hidden_object_stay_unselected_too(self):
        self.source.data.polygons.foreach_set("hide", np.ones(2944, bool))
        self.source.hide_set(True)
        self.call(bpy.ops.quadmatch.match)
        self.assertEqual(scene.numbers(self.source.data.polygons, "select", 1, bool).sum(), 0)

    def test_a_hidden_object_is_matched_and_not_opened(self):
        self.source.hide_set(True)
        lines = self.call(bpy.ops.quadmatch.match)
        self.assertIn("Source is hidden; it is not opened in edit mode", lines)
        self.assertEqual((self.source.mode, self.target.mode), ("OBJECT", "EDIT"))
        self.assertTrue(self.source.hide_get())

    def test_without_colours_and_selection_nothing_is_changed(self):
        self.settings.colour, self.settings.select = "none", False
        before = [scene.all_of(obj) for obj in (self.source, self.target)]
        self.call(bpy.ops.quadmatch.match)
        for obj, was in zip((self.source, self.target), before):
            self.assertSame(scene.all_of(obj), was)

    def test_undo_leaves_edit_mode_and_then_takes_the_colours_away(self):
        before = [scene.all_of(obj) for obj in (self.source, self.target)]
        bpy.ops.ed.undo_push(message="before")
        self.call(bpy.ops.quadmatch.match)
        bpy.ops.ed.undo()
        self.assertEqual(bpy.data.objects["Source"].mode, "OBJECT")
        self.assertIn("quadmatch", bpy.data.objects["Source"].data.color_attributes)
        bpy.ops.ed.undo()
        for name, was in zip(("Source", "Target"), before):
            self.assertSame(scene.all_of(bpy.data.objects[name]), was)

    def test_what_is_ambiguous_is_yellow_and_said(self):
        one, other = scene.grid("One", 4, 4), scene.grid("Other", 4, 4)
        self.pick(one, other)
        self.settings.positions = False
        lines = self.call(bpy.ops.quadmatch.match)
        self.assertTrue(any(line.startswith("Ambiguous: 16 faces fit in ") for line in lines), lines)
        self.assertLess(np.abs(self.face_colours(one) - colours.AMBIGUOUS).max(), 0.01)


class Work(Case):
    """The thread that the modal operator looks after."""

    def test_it_can_be_cancelled_through_the_progress_function(self):
        bear = arrays_of(scene.load(scene.ROOT / "examples" / "bear.obj", "Source").data)
        body = arrays_of(scene.load(scene.ROOT / "examples" / "bear_no_ears_posed.obj", "Target").data)
        task = None

        def compute(progress):
            while task is None:
                pass
            task.cancel()
            return engine.match(bear, body, ("one", "other"), engine.Options(), progress)
        task = work.Task(compute)
        task._thread.join()
        with self.assertRaises(Cancelled):
            task.outcome()

    def test_esc_counts_even_after_the_work_has_ended(self):
        task = work.Task(lambda progress: "done")
        task._thread.join()
        task.cancel()
        with self.assertRaises(Cancelled):
            task.outcome()

    def test_what_it_computes_and_how_far_it_is_can_be_seen_from_outside(self):
        task = work.Task(lambda progress: progress(3, 4) and "done")
        task._thread.join()
        self.assertEqual((task.outcome(), task.share, task.running), ("done", 0.75, False))
