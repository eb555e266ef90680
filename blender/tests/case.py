"""What all tests share."""
import unittest

import bpy

import scene


class Case(unittest.TestCase):
    def setUp(self):
        scene.clear()
        self.settings = bpy.context.scene.quadmatch

    def pick(self, source, target):
        self.settings.source, self.settings.target = source, target

    def call(self, operator, *arguments, **properties):
        """An operator with undo, as from a button."""
        self.assertEqual(operator("EXEC_DEFAULT", True, *arguments, **properties), {"FINISHED"})
        return self.settings.report.split("\n")

    def assertSame(self, one, other):
        self.assertEqual(scene.differences(one, other), [])

    def assertRefused(self, operator, sentence, *objects, **properties):
        """The operator says this and changes nothing of these objects."""
        before = [scene.all_of(obj) for obj in objects]
        with self.assertRaises(RuntimeError) as caught:
            operator("EXEC_DEFAULT", True, **properties)
        said = str(caught.exception).strip()
        self.assertIn(sentence, said)
        self.assertTrue(said.endswith("."), said)
        self.assertNotIn("Traceback", said)
        for obj, was in zip(objects, before):
            self.assertSame(scene.all_of(obj), was)
