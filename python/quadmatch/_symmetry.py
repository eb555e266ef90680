"""The mirror of a mesh, and one side copied to the other."""

from __future__ import annotations

import dataclasses
from typing import Iterable

from quadmatch import _core
from quadmatch._faces import Array
from quadmatch._matching import Match, Progress, check_progress
from quadmatch._meshes import Mesh, as_mesh
from quadmatch._transfer import TransferredAttribute, words


@dataclasses.dataclass(frozen=True)
class CentreLine:
    """Where a mesh meets its mirror image: what lies on itself. int32 arrays, ascending, views of the symmetry."""
    vertices: Array
    edges: Array          #: of shape (K, 2): the vertices at both ends of edges along the line
    crossed_edges: Array  #: of shape (K, 2): of edges that the line crosses; the ends are each other's partners
    faces: Array          #: that the line runs through


@dataclasses.dataclass(frozen=True)
class MirrorPlane:
    """The plane that lays vertices on their partners best: points p with dot(normal, p) = offset."""
    normal: tuple[float, float, float]  #: of length 1
    offset: float
    error: float  #: how far a vertex's image is from its partner in the middle of all pairs, as a share of the model's size
    fits: bool    #: the model is at rest, not posed


class Symmetry:
    """Which vertex and which face of a mesh lies opposite which. Made by symmetry()."""

    __slots__ = ("_core", "__weakref__")

    def __init__(self, core: _core.Symmetry) -> None:
        self._core = core

    @property
    def match(self) -> Match:
        """The mesh on itself, turned over; its own inverse. write_match() writes it as a map."""
        return Match(self._core.match)

    @property
    def vertex_map(self) -> Array:
        """int32: for each vertex its partner, itself on the centre line, or -1. A new array."""
        return self._core.match.vertex_map

    @property
    def face_map(self) -> Array:
        """int32: for each face its partner, itself where the centre line runs through it, or -1. A new array."""
        return self._core.match.face_map

    @property
    def line(self) -> CentreLine:
        return CentreLine(**self._core.line)

    @property
    def plane(self) -> MirrorPlane | None:
        """None where the mesh has no positions or nothing is paired."""
        found = self._core.plane
        return None if found is None else MirrorPlane(**found)

    @property
    def unpaired_faces(self) -> Array:
        """int32, ascending. A view, not copied."""
        return self._core.unpaired_faces

    @property
    def unpaired_vertices(self) -> Array:
        """int32, ascending; of those that a face uses. A view, not copied."""
        return self._core.unpaired_vertices

    @property
    def face_pairs(self) -> int:
        """Faces on the line are not counted."""
        return self._core.face_pairs

    @property
    def vertex_pairs(self) -> int:
        """Vertices on the line are not counted."""
        return self._core.vertex_pairs

    @property
    def mirrors(self) -> int:
        """How many mirrors fit the largest component as well, this one included; 0: none was found."""
        return self._core.mirrors

    @property
    def maybe_more(self) -> bool:
        """There may be more mirrors than were counted."""
        return self._core.maybe_more

    @property
    def whole(self) -> bool:
        """Every face and vertex has a partner."""
        return self._core.whole

    @property
    def complete(self) -> bool:
        """False where the progress function stopped the search."""
        return self._core.complete

    def __repr__(self) -> str:
        paired = self._core.faces - len(self._core.unpaired_faces)
        return f"<quadmatch.Symmetry: {paired} faces of {self._core.faces} paired, {self.mirrors} mirrors>"


@dataclasses.dataclass(frozen=True)
class Symmetrized:
    """The mesh with one side copied to the other, and what became of its data."""
    mesh: Mesh
    moved: int       #: vertices that moved by more than rounding
    farthest: float  #: how far the farthest of them moved, in units of the mesh
    attributes: tuple[TransferredAttribute, ...]  #: of all that was copied but positions


def symmetry(mesh: object, *, positions: bool = True, progress: Progress | None = None) -> Symmetry:
    """Find the mirror of a mesh by its connectivity, so in any pose.

    Where several are as good, the one is taken that has a centre line, whose edges are as long as their partners, and
    whose plane is nearest to x = 0.

    positions: False: connectivity alone, never look at where vertices are.
    progress: as of match(); False stops the search, and what was found so far is returned, with `complete` False.

    The same input gives the same mirror. The GIL is released meanwhile; KeyboardInterrupt stops the work.
    """
    check_progress(progress)
    return Symmetry(_core.symmetry(as_mesh("mesh", mesh)._core, positions=bool(positions), progress=progress))


def symmetrize(mesh: object, symmetry: Symmetry | None = None, *, side: str,
               only: Iterable[str] = ("positions",)) -> Symmetrized:
    """Copy one side of a mesh to the other; what has no partner stays as it is.

    symmetry: of this mesh; without it it is sought here.
    side: the side that is copied: "+x", "-x", "+y", "-y", "+z" or "-z". "+x" is the side that lies farther to +x than
        its partners, in any pose.
    only: what is copied, of "positions", "uv", "colours", "properties", "groups", "materials", "smoothing", "normals".
        Positions are mirrored in the plane between the sides, and the centre line is moved into it; all else is copied
        as it is.

    Raises ValueError with the sentence of the command line: the mesh has no positions or no mirror, is posed where
    positions are to be copied, has nothing of what is to be copied, or the symmetry is of another mesh.
    """
    given = as_mesh("mesh", mesh)
    mirror = _core.symmetry(given._core, positions=True, progress=None) if symmetry is None else symmetry._core
    core, report = _core.symmetrize(given._core, mirror, side=side, only=words(only))
    attributes = tuple(TransferredAttribute(**row) for row in report.pop("attributes"))
    return Symmetrized(mesh=Mesh._of(core), attributes=attributes, **report)
