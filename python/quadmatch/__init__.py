"""Which parts of two quad meshes are the same, from connectivity alone.

>>> import quadmatch
>>> match = quadmatch.match(V1, F1, V2, F2)       # doctest: +SKIP
>>> match.face_map[7]                             # doctest: +SKIP

Vertices are (N, 3) arrays or None, faces an (M, 4) array, a list of lists, or a tuple (offsets, indices); all count
from 0. See docs/python.md.
"""

from quadmatch._analysis import CheckReport, Component, Skeleton, check, connectivity_hash, skeleton
from quadmatch._core import version as __version__
from quadmatch._diff import Change, Difference, DiffTotals, DoubtfulRegion, WholeMotion, diff
from quadmatch._matching import Cancelled, Match, Region, Verdict, match, read_match, verify, write_match
from quadmatch._merge import (
    ConflictArea, DoubtfulPart, Merged, MergedAttribute, SideChanges, ValueConflict, merge)
from quadmatch._meshes import Mesh, read, write
from quadmatch._symmetry import CentreLine, MirrorPlane, Symmetrized, Symmetry, symmetrize, symmetry
from quadmatch._transfer import LeftOutRegion, Transferred, TransferredAttribute, transfer

__all__ = [
    "Cancelled", "CentreLine", "Change", "CheckReport", "Component", "ConflictArea", "DiffTotals", "Difference",
    "DoubtfulPart", "DoubtfulRegion", "LeftOutRegion", "Match", "Merged", "MergedAttribute", "Mesh", "MirrorPlane",
    "Region", "SideChanges", "Skeleton", "Symmetrized", "Symmetry", "Transferred", "TransferredAttribute",
    "ValueConflict", "Verdict", "WholeMotion", "__version__", "check", "connectivity_hash", "diff", "match", "merge",
    "read", "read_match", "skeleton", "symmetrize", "symmetry", "transfer", "verify", "write", "write_match",
]
