"""What there is to say of one mesh: is it well-formed, how irregular is it, and which is it?"""

from __future__ import annotations

import dataclasses

import numpy as np

from quadmatch import _core
from quadmatch._faces import Array
from quadmatch._matching import count
from quadmatch._meshes import as_mesh


@dataclasses.dataclass(frozen=True)
class Component:
    """Faces joined through shared vertices."""
    vertices: int
    edges: int
    faces: int
    boundary_loops: int
    extraordinary: int
    manifold: bool
    orientable: bool
    euler: int
    genus: int | None  #: None where it is not manifold


@dataclasses.dataclass(frozen=True)
class CheckReport:
    """Sizes of a mesh, and every place where it departs from a simple and well-formed one."""
    well_formed: bool
    vertices: int  #: that a face uses
    edges: int
    faces: int
    triangles: int
    quads: int
    larger: int
    boundary_loops: int
    extraordinary: int
    components: tuple[Component, ...]
    departure_counts: dict[str, int]
    departures: tuple[tuple[str, str], ...]  #: kind and sentence


@dataclasses.dataclass(frozen=True)
class Skeleton:
    """The graph that particles trace from extraordinary vertices."""
    vertices: int          #: of the mesh, that a face uses
    nodes: Array           #: int32: the vertex of each node
    arcs: Array            #: int32 of shape (A, 2): nodes at both ends; -1: it ends on the boundary
    paths: tuple[Array, ...]  #: int32: the vertices along each arc, both ends included

    @property
    def reduction(self) -> float:
        """The share of vertices that the skeleton does without."""
        return 1.0 - len(self.nodes) / self.vertices if self.vertices else 0.0


def check(mesh: object, *, kept: int = 10) -> CheckReport:
    """Is a mesh simple and well-formed?

    kept: how many departures of each kind to describe; all are counted.
    """
    found = _core.check(as_mesh("mesh", mesh)._core, count("kept", kept, 0))
    found["components"] = tuple(Component(**row) for row in found["components"])
    found["departures"] = tuple(found["departures"])
    return CheckReport(**found)


def skeleton(mesh: object, *, separatrices: bool = False) -> Skeleton:
    """Trace the skeleton graph.

    separatrices: the graph of extraordinary vertices only, whose arcs pass through crossings.
    """
    core = as_mesh("mesh", mesh)._core
    found = _core.skeleton(core, bool(separatrices))
    paths = tuple(np.split(found["paths"], found["path_offsets"][1:-1])) if len(found["arcs"]) else ()
    return Skeleton(vertices=int(np.unique(core.corners).size), nodes=found["nodes"], arcs=found["arcs"], paths=paths)


def connectivity_hash(mesh: object) -> tuple[str, str]:
    """The hash of what a mesh is, however it is numbered: (oriented, unoriented). Equal exactly for meshes that are the
    same; the second also for mirror images."""
    return _core.connectivity_hash(as_mesh("mesh", mesh)._core)
