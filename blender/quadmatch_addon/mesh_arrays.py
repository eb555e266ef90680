"""A mesh of Blender as arrays, in the object's own space."""
import dataclasses
import functools
import hashlib

import numpy as np

from .refusal import Refusal


@dataclasses.dataclass(frozen=True)
class MeshArrays:
    positions: np.ndarray  #: float32 of shape (V, 3), without modifiers and shape keys
    corners: np.ndarray  #: int32: the vertex of each corner ("loop"), face by face
    starts: np.ndarray  #: int32: the first corner of each face
    sizes: np.ndarray  #: int32: the corners of each face
    edges: object = None  #: int32: the edge from each corner to the next one of its face; where they were asked for

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
        digest = hashlib.sha1(self.corners, usedforsecurity=False)
        digest.update(self.starts)
        return digest.hexdigest()


def read(elements, name, count, dtype):
    """An attribute of all of Blender's vertices, edges, …"""
    values = np.empty(count, dtype)
    elements.foreach_get(name, values)
    return values


def indices(elements, name, count):
    """Numbers of vertices, edges or corners, as int32.

    Blender keeps them unsigned, and copies whole arrays only to the same type.
    """
    return read(elements, name, count, np.uint32).view(np.int32)


def edges_of(mesh):
    """int32: the edge from each corner to the next one of its face."""
    return indices(mesh.loops, "edge_index", len(mesh.loops))


def arrays_of(mesh, edges=False):
    positions = read(mesh.vertices, "co", 3 * len(mesh.vertices), np.float32).reshape(-1, 3)
    corners = indices(mesh.loops, "vertex_index", len(mesh.loops))
    starts = indices(mesh.polygons, "loop_start", len(mesh.polygons))
    sizes = np.diff(starts, append=np.int32(len(corners)))
    if starts[0] != 0 or sizes.min() < 3:
        raise Refusal(f"the mesh {mesh.name} keeps its faces in another order than their corners; "
                      "enter edit mode and leave it once")
    return MeshArrays(positions, corners, starts, sizes, edges_of(mesh) if edges else None)


def edge_vertices(mesh):
    """int32 of shape (E, 2)."""
    return indices(mesh.edges, "vertices", 2 * len(mesh.edges)).reshape(-1, 2)
