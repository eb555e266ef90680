"""A mesh of Blender as arrays, in the object's own space."""
import dataclasses
import functools
import hashlib

import numpy as np


@dataclasses.dataclass(frozen=True)
class MeshArrays:
    positions: np.ndarray  #: float32 of shape (V, 3), without modifiers and shape keys
    corners: np.ndarray  #: int32: the vertex of each corner ("loop"), face by face
    edges: np.ndarray  #: int32: the edge from each corner to the next one of its face
    starts: np.ndarray  #: int32: the first corner of each face
    sizes: np.ndarray  #: int32: the corners of each face

    @property
    def vertex_count(self):
        return len(self.positions)

    @property
    def face_count(self):
        return len(self.starts)

    @functools.cached_property
    def all_quads(self):
        return bool((self.sizes == 4).all())

    @functools.cached_property
    def face_of_corner(self):
        return np.repeat(np.arange(self.face_count), self.sizes)

    @functools.cached_property
    def centres(self):
        """Of each face, (F, 3)."""
        sums = np.add.reduceat(self.positions[self.corners].astype(np.float64), self.starts, axis=0)
        return sums / self.sizes[:, None]

    @functools.cached_property
    def fingerprint(self):
        """Equal for equal connectivity in the same order."""
        digest = hashlib.blake2b(self.corners.tobytes())
        digest.update(self.starts.tobytes())
        return digest.hexdigest()


def read(elements, name, count, dtype):
    """An attribute of all of Blender's vertices, edges, …"""
    values = np.empty(count, dtype)
    elements.foreach_get(name, values)
    return values


def arrays_of(mesh):
    positions = read(mesh.vertices, "co", 3 * len(mesh.vertices), np.float32).reshape(-1, 3)
    corners = read(mesh.loops, "vertex_index", len(mesh.loops), np.int32)
    edges = read(mesh.loops, "edge_index", len(mesh.loops), np.int32)
    starts = read(mesh.polygons, "loop_start", len(mesh.polygons), np.int32)
    sizes = read(mesh.polygons, "loop_total", len(mesh.polygons), np.int32)
    return MeshArrays(positions, corners, edges, starts, sizes)


def edge_vertices(mesh):
    """int32 of shape (E, 2)."""
    return read(mesh.edges, "vertices", 2 * len(mesh.edges), np.int32).reshape(-1, 2)
