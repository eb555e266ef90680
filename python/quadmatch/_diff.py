"""What was changed between two meshes."""

from __future__ import annotations

import dataclasses

from quadmatch import _core
from quadmatch._faces import Array
from quadmatch._matching import Match, Progress, whole_match
from quadmatch._meshes import as_mesh


@dataclasses.dataclass(frozen=True)
class Change:
    """One area that is different. Elements are int32 arrays, ascending."""
    kind: str              #: as the command line names it: "deletion", "inserted loop", "extrusion", "rip", ...
    size: int              #: faces that came or went, or else are joined otherwise
    rows: int              #: how many rows of an inserted or removed loop there are; 0 for other kinds
    edges: int             #: along which matched faces were adjacent and are not, or are and were not
    source_faces: Array    #: without partner
    target_faces: Array    #: without partner
    rejoined: Array        #: of the source: faces that have a partner, but other neighbours
    source_vertices: Array  #: without partner
    target_vertices: Array  #: without partner


@dataclasses.dataclass(frozen=True)
class DiffTotals:
    """Counts of elements; vertices are those that a face uses."""
    source_faces: int
    target_faces: int
    source_vertices: int
    target_vertices: int
    matched_faces: int
    matched_vertices: int
    rejoined_faces: int  #: matched, with other neighbours
    turned_faces: int    #: matched, and wound the other way


@dataclasses.dataclass(frozen=True)
class WholeMotion:
    """How the whole was moved as one body."""
    degrees: float  #: turned, 0 to 180
    scale: float
    mirrored: bool
    shift: float    #: of the centre of what is matched


@dataclasses.dataclass(frozen=True)
class DoubtfulRegion:
    """A region of the match that could lie otherwise, or for which little speaks."""
    region: int  #: its place in the match
    faces: int
    first_source: int
    first_target: int
    ways: int
    ambiguous: bool  #: else the confidence is low
    confidence: float
    left_out: bool   #: its faces count as unmatched


@dataclasses.dataclass(frozen=True)
class Difference:
    """What was changed, from the largest change on. True where anything was."""
    same: bool                  #: no change, no face turned over, no vertex moved
    changes: tuple[Change, ...]
    totals: DiffTotals
    moved: Array                #: int32 of shape (K, 2): source vertex, target vertex, that are elsewhere
    whole_motion: WholeMotion | None  #: where all moved as one rigid, evenly scaled body
    doubtful: tuple[DoubtfulRegion, ...]
    match: Match

    def __bool__(self) -> bool:
        return not self.same


def diff(source: object, target: object, match: Match | None = None, *, ignore_positions: bool = False,
         tolerance: float = 2e-6, min_confidence: float = 0.0, positions: bool = True, orientation: str = "auto",
         progress: Progress | None = None) -> Difference:
    """Name what was changed from source to target, part by part, as a modeller would.

    match: from source to target; without it they are matched here, with `orientation` and `positions`.
    ignore_positions: say nothing of where vertices are.
    tolerance: how far a vertex may be from where it was and not count as moved, as a share of the size of the source.
    min_confidence: take regions of which a smaller share of the extraordinary vertices agrees for unmatched, 0 to 1.
    progress: of the matching, as of match(); False stops it and raises Cancelled.

    Raises ValueError with the sentence of the command line where the match is not sound or of other meshes.
    """
    one, other = as_mesh("source", source), as_mesh("target", target)
    if match is None:
        match = whole_match(one, other, positions=positions, orientation=orientation, progress=progress)
    found = _core.diff(one._core, other._core, match._core, ignore_positions=bool(ignore_positions),
                       tolerance=float(tolerance), min_confidence=float(min_confidence))
    motion = found.pop("whole_motion")
    return Difference(changes=tuple(Change(**row) for row in found.pop("changes")),
                      totals=DiffTotals(**found.pop("totals")),
                      whole_motion=None if motion is None else WholeMotion(**motion),
                      doubtful=tuple(DoubtfulRegion(**row) for row in found.pop("doubtful")), match=match, **found)
