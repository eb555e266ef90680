"""What a match costs in Blender: blender -b --factory-startup --python blender_match.py -- ZIP MESH RUNS; prints processor times as JSON.

Two objects, in the same order and with one of them in random order: from Blender's meshes to a match that has been
verified, and the whole operator Match, which colours and selects besides. The seconds it takes to start Blender and to
load the add-on are not in it.
"""
import json
import sys
import time

import bpy
import numpy as np

zip_file, path, runs = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.preferences.addon_install(filepath=zip_file, overwrite=True)
bpy.ops.preferences.addon_enable(module="quadmatch_addon")

from quadmatch_addon import engine, library
from quadmatch_addon.mesh_arrays import arrays_of


def add(name, positions, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(positions.tolist(), [], faces.tolist())
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def renumbered(vertices, faces, rng):
    """Vertices, faces and first corners in random order."""
    number = rng.permutation(len(vertices))
    moved = np.empty_like(vertices)
    moved[number] = vertices
    turned = np.take_along_axis(faces, (np.arange(4) + rng.integers(0, 4, (len(faces), 1))) % 4, axis=1)
    return moved, number[turned][rng.permutation(len(faces))]


def match(source, target):
    return engine.match(arrays_of(source.data), arrays_of(target.data), ("source", "target"), engine.Options(), lambda matched, most: True)


def operator(source, target):
    settings = bpy.context.scene.quadmatch
    settings.source, settings.target, settings.select = source, target, False
    bpy.ops.quadmatch.match()


def times(work, *pair):
    found = []
    for _ in range(int(runs)):
        began = time.process_time()
        work(*pair)
        found.append((time.process_time() - began) * 1e3)
    return found


quadmatch = library.load()
mesh = quadmatch.read(path)
vertices, faces = np.array(mesh.vertices), np.array(mesh.faces)
source = add("Source", vertices, faces)
copies = {"from-arrays-in-file-order": add("Copy", vertices, faces),
          "from-arrays": add("Renumbered", *renumbered(vertices, faces, np.random.default_rng(1)))}
result = {"faces": len(faces)}
for name, copy in copies.items():
    result[name] = {"matched": match(source, copy).matched, "ms": times(match, source, copy), "operator": times(operator, source, copy)}
print("result", json.dumps(result))
