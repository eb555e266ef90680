"""Match, Region, and what makes and judges them."""

from __future__ import annotations

import dataclasses
import os
from typing import Any, Callable, Iterable, Optional, Sequence, overload

import numpy as np

from quadmatch import _core
from quadmatch._faces import Array, as_array, integers, kind, refuse
from quadmatch._meshes import Mesh, as_mesh, path_bytes

#: Called with the faces matched so far and the most there can be; False (not None) stops the work.
Progress = Callable[[int, int], Optional[bool]]


class Region:
    """A connected part of a match. Its arrays are views of the match: read-only, not copied."""

    __slots__ = ("_core",)

    def __init__(self, core: _core.Region) -> None:
        self._core = core

    @property
    def orientation(self) -> str:
        """"preserving", or "reversing" where the target lies turned over."""
        return "reversing" if self._core.reversing else "preserving"

    @property
    def faces(self) -> Array:
        """int32 of shape (K, 3): source face, target face, rotation, in the order in which they grew.

        Corner i of the source face lies on corner (rotation + i) mod n of the target face when preserving, on
        (rotation - i) mod n when reversing.
        """
        return self._core.faces

    @property
    def waves(self) -> Array:
        """Faces matched at the end of each wave, where match() was asked for waves."""
        return self._core.waves

    @property
    def agreeing(self) -> int:
        """Extraordinary vertices that lie on one that looks the same."""
        return self._core.agreeing

    @property
    def source_extraordinary(self) -> int:
        """Extraordinary vertices that the region touches in the source."""
        return self._core.source_extraordinary

    @property
    def target_extraordinary(self) -> int:
        """The same in the target."""
        return self._core.target_extraordinary

    @property
    def confidence(self) -> float:
        """The share of extraordinary vertices that agree, from 0 to 1."""
        return self._core.confidence

    @property
    def ways(self) -> int:
        """How many maps of these faces are as good, this one included."""
        return self._core.ways

    @property
    def ambiguous(self) -> bool:
        """There are several ways, and positions did not choose: another may be the true one."""
        return self._core.ambiguous

    def __len__(self) -> int:
        return len(self._core.faces)

    def __repr__(self) -> str:
        return f"<quadmatch.Region: {len(self)} faces, {self.orientation}>"


class Match:
    """Which faces and vertices of two meshes are the same. Made by match() or read_match()."""

    __slots__ = ("_core", "__weakref__")

    def __init__(self, core: _core.Match) -> None:
        self._core = core

    @property
    def regions(self) -> list[Region]:
        """From the largest."""
        return [Region(core) for core in self._core.regions]

    @property
    def faces(self) -> Array:
        """int32 of shape (K, 3), the faces of all regions: source face, target face, rotation. A view if there is one."""
        parts = [core.faces for core in self._core.regions]
        if len(parts) == 1:
            return parts[0]
        return np.concatenate(parts) if parts else np.zeros((0, 3), np.int32)

    @property
    def vertices(self) -> Array:
        """int32 of shape (K, 2): source vertex, target vertex, one-to-one, ascending. A view, not copied."""
        return self._core.vertices

    @property
    def face_map(self) -> Array:
        """int32: for each face of the source its partner, or -1. A new array."""
        return self._core.face_map

    @property
    def vertex_map(self) -> Array:
        """int32: for each vertex of the source its partner, or -1. A new array."""
        return self._core.vertex_map

    @property
    def matched_faces(self) -> int:
        return self._core.matched_faces

    @property
    def source_faces(self) -> int:
        return self._core.source_faces

    @property
    def target_faces(self) -> int:
        return self._core.target_faces

    @property
    def source_vertices(self) -> int:
        return self._core.source_vertices

    @property
    def target_vertices(self) -> int:
        return self._core.target_vertices

    @property
    def complete(self) -> bool:
        """False where the progress function or the time limit stopped the search."""
        return self._core.complete

    @property
    def settings(self) -> dict[str, str]:
        """What it was made with."""
        return dict(self._core.settings)

    @property
    def optimality(self) -> dict[str, Any] | None:
        """algorithm="exact": what is proved ("bound", "proved", "nodes", "at_least", "decision"), else None."""
        return self._core.optimality

    def __repr__(self) -> str:
        return (f"<quadmatch.Match: {self.matched_faces} faces of {self.source_faces} and {self.target_faces}, "
                f"{len(self._core.regions)} regions>")


class Cancelled(Exception):
    """The progress function stopped a search, of which a part would be a wrong answer."""


@dataclasses.dataclass(frozen=True)
class Verdict:
    """What the definition says of a match. True where it is sound."""
    fault_count: int
    faults: tuple[str, ...]  #: the first of them, a sentence each
    matched_faces: int
    largest_region: int
    matched_vertices: int

    @property
    def sound(self) -> bool:
        return self.fault_count == 0

    def __bool__(self) -> bool:
        return self.sound


def two_meshes(given: Sequence[object], function: str) -> tuple[Mesh, Mesh]:
    """Two meshes, or four parts: vertices and faces of the source, vertices and faces of the target."""
    if len(given) == 2:
        return as_mesh("source", given[0]), as_mesh("target", given[1])
    if len(given) == 4:
        return Mesh(given[0], given[1], name="source"), Mesh(given[2], given[3], name="target")
    raise TypeError(f"{function}() takes two meshes, or V1, F1, V2, F2; {len(given)} were given")


def anchor_rows(anchors: object) -> list[list[int]]:
    if anchors is None or (isinstance(anchors, (list, tuple)) and not anchors):
        return []
    array = as_array("anchors", "rows", anchors)
    if array.size == 0:
        return []
    if array.ndim != 2 or array.shape[1] != 4:
        refuse("anchors", "rows must be source face, corner, target face, corner, so of shape (K, 4), but it is "
                          + kind(array))
    rows: list[list[int]] = integers("anchors", "rows", array).tolist()
    return rows


def count(name: str, value: int, least: int) -> int:
    if isinstance(value, bool) or not isinstance(value, (int, np.integer)) or not least <= value < 2**32:
        refuse(name, f"{value!r} is no count; give a whole number from {least} on")
    return int(value)


def check_progress(progress: object) -> None:
    if progress is not None and not callable(progress):
        refuse("progress", f"{progress!r} cannot be called; give a function of two numbers")


@overload
def match(source: object, target: object, /, *, algorithm: str = ..., orientation: str = ..., anchors: object = ...,
          positions: bool = ..., min_confidence: float = ..., min_region: int = ..., rounds: int = ...,
          arc_lengths: bool = ..., without: Iterable[str] = ..., waves: bool = ..., at_least: int | None = ...,
          time_limit: float | None = ..., progress: Progress | None = ...) -> Match: ...


@overload
def match(source_vertices: object, source_faces: object, target_vertices: object, target_faces: object, /, *,
          algorithm: str = ..., orientation: str = ..., anchors: object = ..., positions: bool = ...,
          min_confidence: float = ..., min_region: int = ..., rounds: int = ..., arc_lengths: bool = ...,
          without: Iterable[str] = ..., waves: bool = ..., at_least: int | None = ...,
          time_limit: float | None = ..., progress: Progress | None = ...) -> Match: ...


def match(*meshes: object, algorithm: str = "regions", orientation: str = "auto", anchors: object = None,
          positions: bool = True, min_confidence: float = 0.0, min_region: int = 1, rounds: int = 10,
          arc_lengths: bool = False, without: Iterable[str] = (), waves: bool = False, at_least: int | None = None,
          time_limit: float | None = None, progress: Progress | None = None) -> Match:
    """Match two meshes: match(source, target) or match(V1, F1, V2, F2).

    source, target: Mesh, path, or an object as of meshio or trimesh; V and F as Mesh() takes them.
    algorithm: "regions", "lazy-greedy", "greedy" or "exact".
    orientation: "preserving", "reversing" (a mirror image), or "auto": reversing where preserving leaves much unmatched.
    anchors: rows (source face, corner, target face, corner) that are the same, whatever else says so.
    positions: False: connectivity alone, never look at where vertices are.
    min_confidence, min_region: leave out regions of less agreement (0 to 1), or of fewer faces.
    rounds, arc_lengths: the paper's algorithms: how they colour for anchors.
    without: for experiments: stages of regions to leave out, as of `quadmatch match --without`.
    waves: keep the order of growth.
    at_least, time_limit: algorithm="exact": only settle whether so many faces can be matched; seconds to stop after.
    progress: called now and then, and at the end, with the faces matched and the most there can be; False stops the
        work, and the match so far is returned, with `complete` False. What it raises is passed on.

    The same input gives the same match. The GIL is released meanwhile; KeyboardInterrupt stops the work.

    Raises ValueError with the sentence of the command line.
    """
    source, target = two_meshes(meshes, "match")
    check_progress(progress)
    if isinstance(without, str):
        without = [without]
    if time_limit is not None and not 0.001 <= time_limit <= 1e9:
        refuse("time_limit", f"{time_limit!r} is no time; give seconds, 0.001 or more")
    return Match(_core.match(
        source._core, target._core, algorithm=algorithm, orientation=orientation, positions=bool(positions),
        without=list(without), min_confidence=float(min_confidence), min_region=count("min_region", min_region, 0),
        rounds=count("rounds", rounds, 0), arc_lengths=bool(arc_lengths), waves=bool(waves),
        at_least=0 if at_least is None else count("at_least", at_least, 1), time_limit=float(time_limit or 0),
        anchors=anchor_rows(anchors), progress=progress))


def whole_match(source: Mesh, target: Mesh, *, positions: bool, orientation: str, progress: Progress | None) -> Match:
    """The match that is put to use. To what was not searched all would look new."""
    found = match(source, target, positions=positions, orientation=orientation, progress=progress)
    if not found.complete:
        raise Cancelled("the search was stopped, so what is the same is not known")
    return found


def verify(source: object, target: object, match: Match, *, faults: int = 10) -> Verdict:
    """Check a match against the definition, independently of what made it.

    faults: how many to describe; all are counted.

    Raises ValueError where the match is of meshes of other sizes.
    """
    found = _core.verify(as_mesh("source", source)._core, as_mesh("target", target)._core, match._core,
                         count("faults", faults, 0))
    return Verdict(**found)


def read_match(path: str | bytes | os.PathLike[Any]) -> Match:
    """Read a match file, whoever wrote it. Raises FileNotFoundError, OSError, or ValueError with path and line."""
    return Match(_core.read_match(path_bytes(path)))


def write_match(path: str | bytes | os.PathLike[Any], match: Match) -> None:
    """Write a match file, whole or not at all. Raises OSError."""
    _core.write_match(path_bytes(path), match._core)
