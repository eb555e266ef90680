"""Runs the tests inside Blender, on the add-on as installed from its zip:
blender -b --factory-startup --python-exit-code 3 --python run.py -- ZIP [PATTERN]
"""
import pathlib
import sys
import unittest

import bpy

zip_file, *pattern = sys.argv[sys.argv.index("--") + 1:]
here = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(here))
bpy.ops.preferences.addon_install(filepath=zip_file, overwrite=True)
if bpy.ops.preferences.addon_enable(module="quadmatch_addon") != {"FINISHED"}:
    raise SystemExit("the add-on cannot be enabled")

suite = unittest.defaultTestLoader.discover(str(here), pattern=pattern[0] if pattern else "test_*.py", top_level_dir=str(here))
if suite.countTestCases() == 0:
    raise RuntimeError("there are no tests")
# Blender says on standard output what operators report, the tests on standard error.
result = unittest.TextTestRunner(verbosity=2).run(suite)
if not result.wasSuccessful():
    raise RuntimeError("tests failed")
