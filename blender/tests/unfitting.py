"""Not a part of the other tests: an add-on whose extension module was built for another Python.
blender -b --factory-startup --python-exit-code 3 --python unfitting.py -- ZIP PROGRAM
"""
import os
import pathlib
import sys
import unittest

import bpy
import numpy as np

zip_file, program = sys.argv[sys.argv.index("--") + 1:]
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
os.environ["PATH"] = "/usr/bin:/bin"  # where there is no quadmatch
bpy.ops.preferences.addon_install(filepath=zip_file, overwrite=True)
bpy.ops.preferences.addon_enable(module="quadmatch_addon")

import scene
from case import Case
from quadmatch_addon import engine, work
from quadmatch_addon import program as program_module
from quadmatch_addon.refusal import Cancelled

SENTENCE = "the add-on's extension module was built for cpython-37m-x86_64-linux-gnu, but this Blender runs Python 3."


class Unfitting(Case):
    def setUp(self):
        super().setUp()
        self.preferences = bpy.context.preferences.addons["quadmatch_addon"].preferences
        self.source = scene.load(scene.ROOT / "examples" / "bear.obj", "Source")
        self.target = scene.load(scene.ROOT / "examples" / "bear_no_ears_posed.obj", "Target")
        self.pick(self.source, self.target)

    def tearDown(self):
        self.preferences.program = ""

    def test_without_the_program_it_says_what_does_not_fit_and_changes_nothing(self):
        self.assertRefused(bpy.ops.quadmatch.match, SENTENCE, self.source, self.target)
        self.assertRefused(bpy.ops.quadmatch.transfer, "the program quadmatch would do as well, but it is not on PATH", self.source, self.target)
        who, why = engine.state()
        self.assertTrue(why.startswith(SENTENCE), why)
        self.assertIn("install it", who)

    def test_the_program_matches_and_transfers_instead(self):
        self.preferences.program = program
        self.source.vertex_groups.new(name="Arm").add(range(2946), 0.5, "REPLACE")
        self.assertEqual(self.call(bpy.ops.quadmatch.match)[:2], ["2,644 faces are the same", "Source: 89.8 % of 2,944, 300 unmatched"])
        self.assertIn("2,644 of Target's 2,688 faces", self.call(bpy.ops.quadmatch.transfer)[0])
        bpy.ops.object.mode_set(mode="OBJECT")
        self.assertEqual(int((scene.weights(self.target, "Arm") == 0.5).sum()), 2666)

    def test_the_program_finds_the_mirror(self):
        self.preferences.program = program
        bpy.context.view_layer.objects.active = self.source
        self.settings.select = False
        self.call(bpy.ops.quadmatch.mirror_map)
        partner = scene.numbers(self.source.data.attributes["quadmatch_mirror"].data, "value", 1, np.int32)
        paired = np.flatnonzero(partner >= 0)
        self.assertGreater(len(paired), 2800)
        np.testing.assert_array_equal(partner[partner[paired]], paired)

    def test_the_program_names_changes(self):
        self.preferences.program = program
        lines = self.call(bpy.ops.quadmatch.diff)
        self.assertEqual(lines[0], "2 changes, 2,666 vertices moved")
        self.assertEqual([item.name for item in self.settings.changes], lines[1:4])

    def test_the_program_takes_anchors(self):
        self.preferences.program = program
        one, other = scene.grid("One", 4, 4), scene.grid("Other", 4, 4)
        one.vertex_groups.new(name="Mark").add([0], 1.0, "REPLACE")
        self.pick(one, other)
        self.settings.positions, self.settings.allow_ambiguous = False, True
        for first, second, corner in (((0, 1), (24, 23), 24), ((0, 1), (4, 9), 4)):
            self.settings.anchors.clear()
            anchor = self.settings.anchors.add()
            anchor.source, anchor.target, anchor.source_edge, anchor.target_edge = "One", "Other", first, second
            self.call(bpy.ops.quadmatch.transfer)
            self.assertEqual(np.flatnonzero(scene.weights(other, "Mark") == 1).tolist(), [corner])

    def test_the_program_takes_faces_of_any_size(self):
        self.preferences.program = program
        self.pick(*scene.mixed_pair())
        self.assertEqual(self.call(bpy.ops.quadmatch.match)[0], "3 faces are the same")

    def test_where_nothing_is_the_same_it_is_refused(self):
        self.preferences.program = program
        pair = scene.grid("One", 1, 1), scene.add("Triangle", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        self.pick(*pair)
        self.assertRefused(bpy.ops.quadmatch.transfer, "no faces are the same", *pair)

    def test_what_the_program_complains_of_is_passed_on(self):
        self.preferences.program = program
        bpy.context.view_layer.objects.active = self.source
        script = scene.FOLDER / "complains"
        script.write_text("#!/bin/sh\necho 'quadmatch: the disk is full; make room' >&2\nexit 2\n")
        script.chmod(0o755)
        self.preferences.program = str(script)
        for operator in (bpy.ops.quadmatch.match, bpy.ops.quadmatch.mirror_map, bpy.ops.quadmatch.diff):
            self.assertRefused(operator, "the disk is full; make room", self.source, self.target)

    def test_a_program_that_is_another_one_is_refused(self):
        self.preferences.program = "/usr/bin/false"
        self.assertRefused(bpy.ops.quadmatch.transfer, "/usr/bin/false gave no answer that can be read; is it the program quadmatch?", self.source, self.target)

    def test_a_slow_program_can_be_cancelled(self):
        script = scene.FOLDER / "sleeps"
        script.write_text("#!/bin/sh\nexec sleep 600\n")
        script.chmod(0o755)
        self.preferences.program = str(script)
        task = work.Task(lambda progress: program_module.run(str(script), "match", {}, [], progress))
        task.cancel()
        task._thread.join()
        with self.assertRaises(Cancelled):
            task.outcome()


result = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromTestCase(Unfitting))
if not result.wasSuccessful():
    raise RuntimeError("tests failed")
