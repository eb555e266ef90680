"""What users have, as the arrays that a mesh is made of. Every refusal is a ValueError of one plain sentence."""

from __future__ import annotations

import itertools
from typing import Any, Mapping, NoReturn, Optional, Tuple

import numpy as np

from quadmatch import _core

Array = Any  # NumPy's own types say neither shape nor, for what users give, dtype

#: What a mesh is made of: indices of all corners, and where the faces start (None: every face is a quad).
Corners = Tuple[Array, Optional[Array]]


def refuse(name: str, sentence: str) -> NoReturn:
    raise ValueError(f"{name}: {sentence}")


def kind(array: Array) -> str:
    return f"{array.dtype} of shape {array.shape}"


def as_array(name: str, what: str, value: object) -> Array:
    try:
        return np.asarray(value)
    except ValueError:  # ragged
        refuse(name, f"{what} do not all have the same length; give rows of equal length")


def integers(name: str, what: str, array: Array) -> Array:
    """Any integers as a contiguous array of int64."""
    if array.size == 0:
        return np.zeros(array.shape, np.int64)
    if array.dtype.kind not in "iu":
        refuse(name, f"{what} must be integers, but the array is {kind(array)}; convert it with .astype(int)")
    if array.dtype == np.uint64 and int(array.max()) > np.iinfo(np.int64).max:
        refuse(name, f"{what} hold {int(array.max())}, which is out of range")
    return np.ascontiguousarray(array, np.int64)


def numbers(name: str, what: str, array: Array) -> Array:
    """Any real numbers as a contiguous array of float64."""
    if array.size > 0 and array.dtype.kind not in "iuf":
        refuse(name, f"{what} must be real numbers, but the array is {kind(array)}; convert it with .astype(float)")
    return np.ascontiguousarray(array, np.float64)


def positions(name: str, vertices: object) -> Array | None:
    if vertices is None:
        return None
    array = as_array(name, "positions", vertices)
    if array.ndim != 2 or array.shape[1] != 3:
        refuse(name, f"positions must be an array of shape (N, 3), but it is {kind(array)}")
    return numbers(name, "positions", array)


def corners(name: str, faces: object) -> Corners:
    """An (M, k) array, a list of lists, or a tuple (offsets, indices)."""
    if isinstance(faces, tuple):
        return from_offsets(name, faces)
    if isinstance(faces, list):
        ragged = from_lists(name, faces)
        if ragged is not None:
            return ragged
    array = as_array(name, "faces", faces)
    if array.ndim != 2 or array.shape[1] < 3:
        refuse(name, f"faces must be an array of shape (M, 4), a list of lists, or a tuple (offsets, indices), but it "
                     f"is {kind(array)}")
    if array.size == 0:
        refuse(name, "there are no faces; give the mesh with its faces")
    flat = integers(name, "faces", array).reshape(-1)
    if array.shape[1] == 4:
        return flat, None
    return flat, np.arange(0, flat.size + 1, array.shape[1], dtype=np.int64)


def from_offsets(name: str, faces: tuple[object, ...]) -> Corners:
    if len(faces) != 2:
        refuse(name, f"a tuple of faces must be (offsets, indices), but it has {len(faces)} parts; give single faces as "
                     "a list")
    offsets = as_array(name, "offsets", faces[0])
    indices = as_array(name, "indices", faces[1])
    for what, array in (("offsets", offsets), ("indices", indices)):
        if array.ndim != 1:
            refuse(name, f"{what} must be an array of one axis, but it is {kind(array)}")
    if offsets.size == 0:
        refuse(name, "offsets are empty; give M + 1 of them for M faces, from 0 to the number of indices")
    return integers(name, "indices", indices), integers(name, "offsets", offsets)


def from_lists(name: str, faces: list[Any]) -> Corners | None:
    """Faces as lists; None where they all have the same length, so that NumPy does it faster."""
    if not faces:
        refuse(name, "there are no faces; give the mesh with its faces")
    lengths = []
    for number, face in enumerate(faces):
        if isinstance(face, (str, bytes)) or not hasattr(face, "__len__"):
            refuse(name, f"face f{number} is {face!r}; give the numbers of its vertices as a list")
        lengths.append(len(face))
    if min(lengths) == max(lengths) > 2:
        return None
    shortest = min(range(len(faces)), key=lengths.__getitem__)
    if lengths[shortest] < 3:
        refuse(name, f"face f{shortest} has fewer than three corners")
    try:
        flat = np.asarray(list(itertools.chain.from_iterable(faces)))
    except ValueError:  # lists in lists in lists
        flat = np.zeros((0, 0))
    if flat.ndim != 1:
        refuse(name, "faces must be lists of vertex numbers")
    offsets = np.concatenate([[0], np.cumsum(lengths)])
    return integers(name, "faces", flat), integers(name, "offsets", offsets)


#: How a file holds numbers of a type of NumPy.
STORED = {"int8": "int8", "uint8": "uint8", "bool": "uint8", "int16": "int16", "uint16": "uint16", "int32": "int32",
          "uint32": "uint32", "float16": "float32", "float32": "float32", "float64": "float64"}


def stored_as(name: str, what: str, array: Array) -> _core.ScalarType:
    if array.dtype.kind in "iu" and array.dtype.itemsize == 8:
        if array.size and not (np.iinfo(np.int32).min <= int(array.min()) and int(array.max()) <= np.iinfo(np.int32).max):
            refuse(name, f"{what} hold integers beyond 32 bits, which no mesh file keeps; give float64")
        return _core.ScalarType.int32
    if array.dtype.name not in STORED:
        refuse(name, f"{what} must be numbers, but the array is {kind(array)}")
    kept: _core.ScalarType = getattr(_core.ScalarType, STORED[array.dtype.name])
    return kept


def named_data(name: str, domain: str, data: Mapping[str, object] | None, count: int) -> list[Any]:
    """Values beside the mesh: one number for each vertex or face."""
    found = []
    for key, values in (data or {}).items():
        what = f"{domain} data '{key}'"
        array = as_array(name, what, values)
        if array.shape != (count,):
            refuse(name, f"{what} must have shape ({count},), one number for each {domain}, but it is {kind(array)}")
        scalar = stored_as(name, what, array)
        found.append((str(key), scalar, np.ascontiguousarray(array, np.float64)))
    return found


def pool(name: str, texture_coordinates: object, corner_count: int) -> Any:
    """Texture coordinates: (values, index of each corner), or values for each corner."""
    if texture_coordinates is None:
        return None
    what = "texture coordinates"
    if isinstance(texture_coordinates, tuple) and len(texture_coordinates) == 2:
        values = as_array(name, what, texture_coordinates[0])
        index = integers(name, "indices of " + what, as_array(name, what, texture_coordinates[1]))
    else:
        values = as_array(name, what, texture_coordinates)
        index = np.arange(corner_count, dtype=np.int64)
    if values.ndim != 2 or values.shape[1] not in (1, 2, 3):
        refuse(name, f"{what} must be an array of shape (K, 2), or a tuple of it and the index of each corner, but it is "
                     f"{kind(values)}")
    values = numbers(name, what, values)
    if not np.isfinite(values).all():
        refuse(name, f"{what} hold a number that is not finite; correct it")
    if index.shape != (corner_count,):
        refuse(name, f"{what} need an index for each of the {corner_count} corners, but there are {index.size}")
    if index.size and not (-1 <= int(index.min()) and int(index.max()) < len(values)):
        refuse(name, f"{what} are indexed outside their {len(values)} rows; -1 means none")
    return values, index
