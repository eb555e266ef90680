"""What a match costs from Python. usage: python_match.py MESH RUNS; prints processor times in milliseconds as JSON.

The mesh is matched, as four arrays, with a copy in its own order and with one in random order.
"""
import json
import sys
import time

import numpy as np

import quadmatch


def renumbered(vertices, faces, rng):
    """Vertices, faces and first corners in random order."""
    number = rng.permutation(len(vertices))
    moved = np.empty_like(vertices)
    moved[number] = vertices
    turned = np.take_along_axis(faces, (np.arange(4) + rng.integers(0, 4, (len(faces), 1))) % 4, axis=1)
    return moved, number[turned][rng.permutation(len(faces))]


def times(vertices, faces, other_vertices, other_faces, runs):
    found = []
    for _ in range(runs):
        began = time.process_time()
        match = quadmatch.match(vertices, faces, other_vertices, other_faces)
        found.append((time.process_time() - began) * 1e3)
    return found, match.matched_faces


def main(path, runs):
    mesh = quadmatch.read(path)
    vertices, faces = np.array(mesh.vertices), mesh.faces.astype(np.int64)  # as NumPy makes them by default
    result = {"faces": len(faces)}
    copies = {"from-arrays-in-file-order": (vertices.copy(), faces.copy()),
              "from-arrays": renumbered(vertices, faces, np.random.default_rng(1))}
    for name, copy in copies.items():
        found, matched = times(vertices, faces, *copy, runs)
        result[name] = {"ms": found, "matched": matched}
    print(json.dumps(result))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
