"""Which corners, edges, vertices and faces of two meshes are the same, of the regions that are trusted.

Everything that is carried goes along these pairs: first column source, second target. No target is in two pairs.
"""
import dataclasses
import functools

import numpy as np


@dataclasses.dataclass(frozen=True)
class Trust:
    """Which regions count."""
    allow_ambiguous: bool = False
    min_confidence: float = 0.0

    def of(self, region):
        return (self.allow_ambiguous or not region.ambiguous) and region.confidence >= self.min_confidence


class Correspondence:
    def __init__(self, source, target, found, trust=Trust()):
        """source, target: MeshArrays; found: Found."""
        self.source, self.target, self._found = source, target, found
        self.regions = [region for region in found.regions if trust.of(region)]
        self.left_out = [region for region in found.regions if not trust.of(region)]

    @functools.cached_property
    def faces(self):
        return np.concatenate([region.faces[:, :2] for region in self.regions] or [np.zeros((0, 2), np.int32)])

    @functools.cached_property
    def corners(self):
        return np.concatenate([self._corners(region, 0) for region in self.regions] or [np.zeros((0, 2), np.int32)])

    @functools.cached_property
    def edges(self):
        """Of edges that several pairs lie on, the first one's word counts: the largest region's."""
        sides = []
        for region in self.regions:
            # The edge leaves a corner to the next one; turned over, the target's runs the other way.
            corners = self._corners(region, -1 if region.reversing else 0)
            sides.append(np.stack([self.source.edges[corners[:, 0]], self.target.edges[corners[:, 1]]], axis=1))
        return _first_of_each_target(np.concatenate(sides or [np.zeros((0, 2), np.int32)]))

    @functools.cached_property
    def vertices(self):
        """Corners of trusted faces. A vertex of the source is in several pairs where an edit took it apart."""
        return _first_of_each_target(np.concatenate([self.own_vertices, self._corner_vertices]))

    @functools.cached_property
    def own_vertices(self):
        """The same, one-to-one: what the match as a whole says."""
        partner = np.full(self.source.vertex_count, -1, np.int64)
        partner[self._found.vertices[:, 0]] = self._found.vertices[:, 1]
        pairs = self._corner_vertices
        return np.unique(pairs[partner[pairs[:, 0]] == pairs[:, 1]], axis=0)

    @functools.cached_property
    def _corner_vertices(self):
        return np.stack([self.source.corners[self.corners[:, 0]], self.target.corners[self.corners[:, 1]]], axis=1)

    @functools.cached_property
    def turned_vertices(self):
        """Which of `vertices` lie in a region that is turned over."""
        turned = np.zeros(self.target.vertex_count, bool)
        for region in reversed(self.regions):  # so that the largest has the last word
            corners = self._corners(region, 0)[:, 1]
            turned[self.target.corners[corners]] = region.reversing
        return turned[self.vertices[:, 1]]

    def _corners(self, region, shift):
        """Corner pairs of a region, the target's moved on by `shift` in its face."""
        source, target, rotation = region.faces.T.astype(np.int64)
        sizes = self.source.sizes[source]
        first = np.cumsum(sizes) - sizes
        place = np.arange(sizes.sum()) - np.repeat(first, sizes)
        there = np.repeat(rotation, sizes) + (-place if region.reversing else place) + shift
        return np.stack([np.repeat(self.source.starts[source], sizes) + place,
                         np.repeat(self.target.starts[target], sizes) + there % np.repeat(sizes, sizes)], axis=1)


def _first_of_each_target(pairs):
    _, first = np.unique(pairs[:, 1], return_index=True)
    return pairs[np.sort(first)]
