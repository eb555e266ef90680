"""Which parts of two quad meshes are the same, from connectivity alone.

>>> import quadmatch
>>> match = quadmatch.match(V1, F1, V2, F2)       # doctest: +SKIP
>>> match.face_map[7]                             # doctest: +SKIP

Vertices are (N, 3) arrays or None, faces an (M, 4) array, a list of lists, or a tuple (offsets, indices); all count
from 0. See docs/python.md.
"""

from quadmatch._analysis import CheckReport, Component, Skeleton, check, connectivity_hash, skeleton
from quadmatch._core import version as __version__
from quadmatch._matching import Match, Region, Verdict, match, read_match, verify, write_match
from quadmatch._meshes import Mesh, read, write
from quadmatch._transfer import LeftOutRegion, Transferred, TransferredAttribute, transfer

__all__ = [
    "CheckReport", "Component", "LeftOutRegion", "Match", "Mesh", "Region", "Skeleton", "Transferred",
    "TransferredAttribute", "Verdict", "__version__", "check", "connectivity_hash", "match", "read", "read_match",
    "skeleton", "transfer", "verify", "write", "write_match",
]
