"""Carry data over."""

from __future__ import annotations

import dataclasses
from typing import Iterable

from quadmatch import _core
from quadmatch._matching import Match, Progress, whole_match
from quadmatch._meshes import Mesh, as_mesh


@dataclasses.dataclass(frozen=True)
class TransferredAttribute:
    """What became of one attribute; numbers of elements of the target, in its domain."""
    name: str
    domain: str   #: "vertex", "corner", "face" or "further"
    carried: int  #: have the source's value
    kept: int     #: have the target's own
    filled: int   #: interpolated, or taken from the nearest
    without: int  #: have none
    remarks: tuple[str, ...]


@dataclasses.dataclass(frozen=True)
class LeftOutRegion:
    """A region from which nothing was carried, or only what did not move."""
    reason: str  #: "ambiguous" or "low confidence"
    region: int  #: its place in the match
    faces: int
    first_source: int
    first_target: int
    ways: int
    confidence: float


@dataclasses.dataclass(frozen=True)
class Transferred:
    """The target with the source's data, and what became of them."""
    mesh: Mesh
    attributes: tuple[TransferredAttribute, ...]
    left_out: tuple[LeftOutRegion, ...]
    faces: int             #: of the target
    vertices: int          #: of the target, that a face uses
    matched_faces: int     #: that take the source's data
    matched_vertices: int
    reversing: bool        #: some of them lie turned over

    @property
    def complete(self) -> bool:
        """Did all of the target take the source's data?"""
        return self.matched_faces == self.faces and self.matched_vertices == self.vertices


def words(only: Iterable[str]) -> list[str]:
    """A list of words, or one text with commas between them, as on the command line."""
    return only.split(",") if isinstance(only, str) else list(only)


def transfer(source: object, target: object, match: Match | None = None, *, only: Iterable[str] = (), fill: str = "keep",
             order: bool = False, allow_ambiguous: bool = False, min_confidence: float = 0.0,
             positions: bool = True, orientation: str = "auto", progress: Progress | None = None) -> Transferred:
    """The target with the source's data wherever both are the same.

    match: from source to target; without it they are matched here, with `orientation` and `positions`.
    only: what to carry, of "uv", "colours", "properties", "groups", "materials", "smoothing", "normals", "positions",
        "none"; by default all but normals and positions, which belong to the pose.
    fill: what the rest of the target gets: "keep" its own, "none", or "smooth", going on from the matched part.
    order: number the result as the source.
    allow_ambiguous: carry parts that could lie otherwise, too.
    positions: False: by connectivity alone.
    progress: of the matching, as of match(); False stops it and raises Cancelled.

    Where nothing of the source is found or all is doubtful, nothing is carried: matched_faces is 0.

    Raises ValueError with the sentence of the command line: the source has nothing of what is to be carried, or the
    match is not sound or of other meshes.
    """
    one, other = as_mesh("source", source), as_mesh("target", target)
    if match is None:
        match = whole_match(one, other, positions=positions, orientation=orientation, progress=progress)
    core, report = _core.transfer(one._core, other._core, match._core, only=words(only), fill=fill, order=bool(order),
                                  allow_ambiguous=bool(allow_ambiguous), min_confidence=float(min_confidence),
                                  positions=bool(positions))
    attributes = tuple(TransferredAttribute(**row) for row in report.pop("attributes"))
    left_out = tuple(LeftOutRegion(**row) for row in report.pop("left_out"))
    return Transferred(mesh=Mesh._of(core), attributes=attributes, left_out=left_out, **report)
