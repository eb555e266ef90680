"""Two edits of one mesh, brought together."""

from __future__ import annotations

import dataclasses

from quadmatch import _core
from quadmatch._faces import Array
from quadmatch._matching import Cancelled, Match, Progress, check_progress
from quadmatch._meshes import Mesh, as_mesh


@dataclasses.dataclass(frozen=True)
class SideChanges:
    """What one side did to the base."""
    matched_faces: int     #: of the base, that this side has too
    removed_faces: int     #: of the base
    added_faces: int       #: of this side
    changed_vertices: int  #: of the base, whose faces are other ones or joined in another way
    moved_vertices: int    #: of the base, that are elsewhere


@dataclasses.dataclass(frozen=True)
class ConflictArea:
    """Edits that meet. Elements are int32 arrays, ascending."""
    base_vertices: Array    #: where connectivity is changed
    base_faces: Array       #: removed by one side and not by the other
    ours_faces: Array       #: new, and not in the other side
    theirs_faces: Array     #: new, and not in the other side
    merged_vertices: Array  #: of the result, which holds the preferred side here
    centre: tuple[float, float, float]


@dataclasses.dataclass(frozen=True)
class ValueConflict:
    """Values that both sides changed, to different ones; the result has those of the preferred side."""
    name: str    #: "positions", "texture coordinates", "normals", the name of a property, or a record: "usemtl"
    domain: str  #: "vertex", "corner" or "face"
    count: int
    first: tuple[int, ...]  #: the first of them, by number in the result; at most ten


@dataclasses.dataclass(frozen=True)
class MergedAttribute:
    """Values that were taken from a side that changed them."""
    name: str    #: as in ValueConflict
    domain: str
    from_ours: int    #: elements whose value is other than the base's
    from_theirs: int
    remarks: tuple[str, ...]


@dataclasses.dataclass(frozen=True)
class DoubtfulPart:
    """A part of a side that might lie elsewhere on the base, and in which the other side changed something."""
    side: str    #: "ours" or "theirs"
    region: int  #: its place in the match
    faces: int
    first_base: int
    first_side: int
    ways: int
    ambiguous: bool  #: else the confidence is low
    confidence: float


@dataclasses.dataclass(frozen=True)
class Merged:
    """The base with the changes of both sides, and what became of them."""
    mesh: Mesh
    face_origins: Array    #: int32 of shape (F, 3): of each face its number in base, ours and theirs, or -1
    vertex_origins: Array  #: int32 of shape (V, 3): the same of vertices
    ours: SideChanges
    theirs: SideChanges
    same_added_faces: int  #: added by both sides in the same way, and once in the result
    areas: tuple[ConflictArea, ...]
    values: tuple[ValueConflict, ...]
    attributes: tuple[MergedAttribute, ...]
    doubtful: tuple[DoubtfulPart, ...]
    new_departures: tuple[str, ...]  #: what the result has more of than the sides have; see check()
    carried_along: int     #: vertices of one side, moved along with what the other side moved around them

    @property
    def clean(self) -> bool:
        """There are no conflicts."""
        return not self.areas and not self.values


def merge(base: object, ours: object, theirs: object, *, match_ours: Match | None = None,
          match_theirs: Match | None = None, prefer: str = "ours", positions: bool = True,
          progress: Progress | None = None) -> Merged:
    """The base with the changes of both sides: connectivity, positions and all data, however they are numbered.

    Where both changed what is around the same vertex, and not in the same way, or gave one element two values, there
    is a conflict: it is in `areas` or `values`, and the result has there what `prefer` says.

    The result has the order of ours; what is new of theirs follows. A side that changed nothing gives the other one
    back as it is.

    match_ours, match_theirs: from base to that side; without it they are matched here, with `positions`.
    prefer: "ours" or "theirs".
    progress: of the matching, as of match(), first of ours and then of theirs; False stops it and raises Cancelled.

    Raises ValueError with the sentence of the command line: a match is not sound or of other meshes, or a side has no
    part in common with the base.
    """
    check_progress(progress)
    one, left, right = as_mesh("base", base), as_mesh("ours", ours), as_mesh("theirs", theirs)
    to_ours = match_of_side(one, left, positions, progress) if match_ours is None else match_ours._core
    to_theirs = match_of_side(one, right, positions, progress) if match_theirs is None else match_theirs._core
    core, report = _core.merge(one._core, left._core, right._core, to_ours, to_theirs, prefer=prefer)
    return Merged(mesh=Mesh._of(core), ours=SideChanges(**report.pop("ours")), theirs=SideChanges(**report.pop("theirs")),
                  areas=tuple(ConflictArea(**row) for row in report.pop("areas")),
                  values=tuple(ValueConflict(**row) for row in report.pop("values")),
                  attributes=tuple(MergedAttribute(**row) for row in report.pop("attributes")),
                  doubtful=tuple(DoubtfulPart(**row) for row in report.pop("doubtful")), **report)


def match_of_side(base: Mesh, side: Mesh, positions: bool, progress: Progress | None) -> _core.Match:
    found = _core.match_side(base._core, side._core, positions=bool(positions), progress=progress)
    if not found.complete:
        raise Cancelled("the search was stopped, so nothing is merged")
    return found
