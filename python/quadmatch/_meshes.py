"""Mesh, and how it comes from and goes to files and other packages."""

from __future__ import annotations

import os
from typing import Any, Mapping

import numpy as np

from quadmatch import _core
from quadmatch._faces import Array, corners, kind, named_data, pool, positions, refuse

#: meshio's names of cells that are faces; lines and points are passed over, solids are refused.
FACES_OF_MESHIO = ("triangle", "quad", "polygon")
PASSED_OVER_OF_MESHIO = ("vertex", "line", "line3")

PLY = {"binary": _core.PlyEncoding.little, "ascii": _core.PlyEncoding.ascii, "big-endian": _core.PlyEncoding.big}


class Mesh:
    """A polygon mesh: connectivity, and beside it positions and data.

    Made from arrays or read from a file; never changed afterwards, so threads may share it. Its arrays are views of
    its own memory: read-only, not copied.

    vertices: array of shape (N, 3), or None where only connectivity is known.
    faces: integers, counted from 0: an array of shape (M, 4) (or (M, k)), a list of lists, or a tuple (offsets,
        indices), where face f has the corners indices[offsets[f]:offsets[f + 1]]. Counter-clockwise seen from outside.
    vertex_count: where vertices is None, the number of vertices; by default the highest that a face names, and one.
    vertex_data, face_data: names, and one number for each vertex or face. "red", "green", "blue" are colours.
    texture_coordinates: one row for each corner, or a tuple (values, index of each corner, -1 for none), so that
        corners which share a row go on sharing it.
    name: what messages call the mesh.

    Raises ValueError, naming the element: a wrong dtype or shape, a position that is not finite, a face that names a
    vertex there is none of or has fewer than three corners.
    """

    __slots__ = ("_core", "__weakref__")

    def __init__(self, vertices: object, faces: object, *, vertex_count: int | None = None,
                 vertex_data: Mapping[str, object] | None = None, face_data: Mapping[str, object] | None = None,
                 texture_coordinates: object = None, name: str = "mesh") -> None:
        points = positions(name, vertices)
        indices, offsets = corners(name, faces)
        if points is not None:
            if vertex_count not in (None, len(points)):
                refuse(name, f"there are {len(points)} positions, but vertex_count is {vertex_count}; leave it out")
            vertex_count = len(points)
        elif vertex_count is None:
            vertex_count = max(int(indices.max()) + 1, 0) if indices.size else 0
        faces_given = indices.size // 4 if offsets is None else offsets.size - 1
        self._core = _core.Mesh(os.fsencode(name), points, vertex_count, indices, offsets,
                                named_data(name, "vertex", vertex_data, vertex_count),
                                named_data(name, "face", face_data, faces_given),
                                pool(name, texture_coordinates, indices.size))

    @classmethod
    def _of(cls, core: _core.Mesh) -> Mesh:
        mesh = cls.__new__(cls)
        mesh._core = core
        return mesh

    @property
    def vertices(self) -> Array | None:
        """Positions, float64 of shape (N, 3), or None."""
        return self._core.positions

    @property
    def faces(self) -> Array | tuple[Array, Array]:
        """int32 of shape (M, 4) where every face is a quad, else a tuple (offsets, indices). Mesh() takes both."""
        indices = self._core.corners
        return indices.reshape(-1, 4) if self._core.all_quads else (self._core.offsets, indices)

    @property
    def corners(self) -> Array:
        """The vertex of each corner, face after face, int32."""
        return self._core.corners

    @property
    def offsets(self) -> Array:
        """Where each face starts in `corners`, and their number at the end; a new array of M + 1."""
        return self._core.offsets

    @property
    def all_quads(self) -> bool:
        """Has every face four corners?"""
        return self._core.all_quads

    @property
    def vertex_count(self) -> int:
        return self._core.vertex_count

    @property
    def face_count(self) -> int:
        return self._core.face_count

    @property
    def edge_count(self) -> int:
        """Edges, where a non-manifold edge of three faces counts three times."""
        return self._core.edge_count

    @property
    def vertex_data(self) -> dict[str, Any]:
        """Name to float64 of shape (N,); for lists a tuple (offsets, values)."""
        return self._core.vertex_data

    @property
    def face_data(self) -> dict[str, Any]:
        """Name to float64 of shape (M,); for lists a tuple (offsets, values)."""
        return self._core.face_data

    @property
    def texture_coordinates(self) -> tuple[Array, Array] | None:
        """(values of shape (K, components), index of each corner or -1), or None."""
        return self._core.texture_coordinates

    @property
    def normals(self) -> tuple[Array, Array] | None:
        """As texture_coordinates, of a file that gives normals to corners."""
        return self._core.normals

    @property
    def face_records(self) -> list[tuple[int, str, str]]:
        """OBJ's records that hold from a face on: (first face, "usemtl", "skin")."""
        return self._core.face_records

    @property
    def path(self) -> str:
        """The file it was read from, or the name it was given."""
        return os.fsdecode(self._core.path)

    @property
    def notes(self) -> list[str]:
        """What the reader met and did not keep or had to guess, a sentence each."""
        return self._core.notes

    def to_meshio(self) -> Any:
        """The mesh as a meshio.Mesh: points, cells in the order of the faces, numbers of vertices and faces as data.

        Raises ImportError where meshio is not installed, ValueError for a mesh without positions.
        """
        import meshio  # only who asks for it needs it

        if self.vertices is None:
            refuse(self.path, "the mesh has no positions, which meshio cannot do without")
        sizes = np.diff(self.offsets)
        bounds = [0, *(np.flatnonzero(np.diff(sizes)) + 1), len(sizes)]
        cells = []
        data: dict[str, list[Array]] = {key: [] for key, values in self.face_data.items() if not isinstance(values, tuple)}
        for first, last in zip(bounds, bounds[1:]):
            size = int(sizes[first])
            rows = self.corners[self.offsets[first]:self.offsets[last]].reshape(-1, size)
            cells.append(({3: "triangle", 4: "quad"}.get(size, "polygon"), rows))
            for key, blocks in data.items():
                blocks.append(self.face_data[key][first:last])
        point_data = {key: values for key, values in self.vertex_data.items() if not isinstance(values, tuple)}
        return meshio.Mesh(self.vertices, cells, point_data=point_data, cell_data=data)

    def __repr__(self) -> str:
        return f"<quadmatch.Mesh {self.path!r}: {self.vertex_count} vertices, {self.face_count} faces>"


def from_meshio(name: str, other: Any) -> Mesh:
    """The faces of all blocks in their order; data of one number for each point or cell."""
    lists: list[list[int]] = []
    kept = []
    for number, block in enumerate(other.cells):
        if any(block.type == word or block.type.startswith(word) for word in FACES_OF_MESHIO):
            rows = np.asarray(block.data)
            if block.type.startswith("triangle") and rows.shape[1] != 3 or block.type.startswith("quad") and rows.shape[1] != 4:
                refuse(name, f"cells of type {block.type} have more nodes than corners; make them linear first")
            lists.extend(rows.tolist())
            kept.append(number)
        elif block.type not in PASSED_OVER_OF_MESHIO:
            refuse(name, f"cells of type {block.type} are no faces; extract the surface first")
    points = np.asarray(other.points)
    if points.ndim == 2 and points.shape[1] == 2:
        points = np.column_stack([points, np.zeros(len(points))])
    vertex_data = {key: values for key, values in other.point_data.items() if is_scalar(values)}
    face_data = {key: np.concatenate([blocks[number] for number in kept]) for key, blocks in other.cell_data.items()
                 if kept and all(is_scalar(blocks[number]) for number in kept)}
    return Mesh(points, lists, vertex_data=vertex_data, face_data=face_data, name=name)


def is_scalar(values: object) -> bool:
    array = np.asarray(values)
    return array.ndim == 1 and array.dtype.kind in "iufb"


def as_mesh(name: str, value: object) -> Mesh:
    """A Mesh, a path, or an object that has points and cells (meshio), or vertices and faces (trimesh)."""
    if isinstance(value, Mesh):
        return value
    if isinstance(value, (str, bytes, os.PathLike)):
        return read(value)
    if hasattr(value, "points") and hasattr(value, "cells") and hasattr(value, "cell_data"):
        return from_meshio(name, value)
    if hasattr(value, "vertices") and hasattr(value, "faces"):
        return Mesh(np.asarray(value.vertices), np.asarray(value.faces), name=name)
    shape = f", {kind(value)}" if isinstance(value, np.ndarray) else ""
    refuse(name, f"this is no mesh but an object of type {type(value).__name__}{shape}; give a quadmatch.Mesh, a path, or an object with "
                 "vertices and faces")


def path_bytes(path: str | bytes | os.PathLike[Any]) -> bytes:
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise ValueError("a path must not contain a null character")
    return encoded


def read(path: str | bytes | os.PathLike[Any]) -> Mesh:
    """Read an OBJ, PLY, OFF or USD text file; "-" reads standard input.

    Raises FileNotFoundError or OSError where it cannot be read, ValueError with path and line where it is wrong.
    """
    return Mesh._of(_core.read(path_bytes(path)))


def write(path: str | bytes | os.PathLike[Any], mesh: object, *, ply: str = "binary") -> None:
    """Write a mesh with all it carries, in the format of the path's ending, whole or not at all.

    ply: "binary", "ascii" or "big-endian".

    Raises OSError where it cannot be written, ValueError for an ending that tells no format.
    """
    if ply not in PLY:
        raise ValueError(f"ply: there is no '{ply}'; give binary, ascii or big-endian")
    _core.write(path_bytes(path), as_mesh("mesh", mesh)._core, PLY[ply])
