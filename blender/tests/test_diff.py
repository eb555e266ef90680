"""Diff: changes by name, as selections."""
import json

import bpy
import numpy as np

import scene
from case import Case


class Diff(Case):
    def open(self, *edits, seed=14):
        self.source, self.target, self.truth = scene.edited(scene.ROOT / "examples" / "bear.obj", [*edits, "renumber"], seed)
        self.pick(self.source, self.target)

    def selected(self, obj, elements="polygons"):
        if obj.mode != "OBJECT":
            bpy.ops.object.mode_set(mode="OBJECT")
        return set(np.flatnonzero(scene.numbers(getattr(obj.data, elements), "select", 1, bool)).tolist())

    def lost(self):
        """Faces that the edits took away and that they added."""
        return (set(range(len(self.source.data.polygons))) - set(self.truth.faces[:, 0].tolist()),
                set(range(len(self.target.data.polygons))) - set(self.truth.faces[:, 1].tolist()))

    def test_changes_have_names_and_are_selected_on_both(self):
        self.open("delete:30")
        lines = self.call(bpy.ops.quadmatch.diff)
        self.assertEqual(lines[:2], ["1 change, 0 vertices moved", "deletion: faces 30 removed"])
        self.assertEqual((self.source.mode, self.target.mode), ("EDIT", "EDIT"))
        removed, added = self.lost()
        self.assertEqual((self.selected(self.source), self.selected(self.target)), (removed, added))

    def test_each_change_can_be_selected_by_itself(self):
        self.open("delete:30", "extrude:20")
        self.call(bpy.ops.quadmatch.diff)
        self.assertEqual([item.name for item in self.settings.changes][:2], ["deletion: faces 30 removed", "extrusion: faces 24 added"])
        self.call(bpy.ops.quadmatch.select_change, index=1)
        self.assertEqual((len(self.selected(self.source)), len(self.selected(self.target))), (0, 24))
        self.settings.change = 0
        self.call(bpy.ops.quadmatch.select_change)
        self.assertEqual((len(self.selected(self.source)), len(self.selected(self.target))), (30, 0))

    def test_a_slit_adds_no_faces_and_selects_those_along_it(self):
        self.open("rip:6")
        self.call(bpy.ops.quadmatch.diff)
        self.assertTrue(self.settings.changes[0].name.startswith("rip: "), self.settings.changes[0].name)
        here, there = self.selected(self.source), self.selected(self.target)
        self.assertGreater(len(here), 6)
        image = dict(self.truth.faces.tolist())
        self.assertEqual({image[face] for face in here}, there)

    def test_vertices_that_moved_are_a_change(self):
        self.open("renumber")
        pair = self.truth.vertices[100]
        self.target.data.vertices[int(pair[1])].co.x += 0.1
        lines = self.call(bpy.ops.quadmatch.diff)
        self.assertEqual(lines[:2], ["0 changes, 1 vertex moved", "moved: 1 vertex"])
        self.call(bpy.ops.quadmatch.select_change, index=0)
        self.assertEqual((self.selected(self.source, "vertices"), self.selected(self.target, "vertices")), ({int(pair[0])}, {int(pair[1])}))

    def test_a_renumbered_copy_has_no_differences(self):
        self.open("renumber")
        self.assertEqual(self.call(bpy.ops.quadmatch.diff)[0], "no differences")
        self.assertEqual(len(self.settings.changes), 0)

    def test_a_list_of_objects_that_were_changed_since_is_refused(self):
        self.open("delete:30")
        self.call(bpy.ops.quadmatch.diff)
        self.selected(self.target)
        self.assertEqual(json.loads(self.settings.changes[0].elements)["objects"], ["Source", "Target"])
        self.target.data = scene.grid("Other", 2, 2).data
        self.assertRefused(bpy.ops.quadmatch.select_change, "Target was changed since; run Diff again", index=0)
        self.assertRefused(bpy.ops.quadmatch.select_change, "there is no such change; run Diff first", index=7)

    def test_undo_takes_the_list_and_the_selection_away(self):
        self.open("delete:30")
        before = scene.all_of(self.source)
        bpy.ops.ed.undo_push(message="before")
        self.call(bpy.ops.quadmatch.diff)
        bpy.ops.ed.undo()
        bpy.ops.ed.undo()
        self.assertSame(scene.all_of(bpy.data.objects["Source"]), before)
        self.assertEqual(len(bpy.context.scene.quadmatch.changes), 0)
