"""What a match says, whoever found it: arrays of pairs, region by region."""
import dataclasses

import numpy as np


@dataclasses.dataclass(frozen=True)
class Region:
    faces: np.ndarray  #: int32 of shape (K, 3): source face, target face, rotation, as in a match file
    reversing: bool  #: the target's faces run the other way round
    confidence: float  #: 0 to 1
    ways: int
    ambiguous: bool  #: it could lie otherwise, and nothing chose

    @property
    def doubt(self):
        return f"{len(self.faces):,} faces fit in {self.ways} ways" if self.ambiguous else ""


@dataclasses.dataclass(frozen=True)
class Found:
    """A match. Regions are ordered from the largest."""
    regions: tuple
    vertices: np.ndarray  #: int32 of shape (K, 2): source vertex, target vertex, one-to-one

    @property
    def matched(self):
        return sum(len(region.faces) for region in self.regions)


def from_library(match):
    """From quadmatch.Match."""
    regions = tuple(Region(region.faces, region.orientation == "reversing", region.confidence, region.ways,
                           region.ambiguous) for region in match.regions)
    return Found(regions, match.vertices)


def from_match_file(data):
    """From the object in a match file, docs/formats.md."""
    regions = []
    for region in data["regions"]:
        evidence = region.get("evidence", {})
        seen = min(evidence.get("source_extraordinary", 0), evidence.get("target_extraordinary", 0))
        confidence = evidence.get("agreeing", 0) / seen if seen else 1.0
        regions.append(Region(np.array(region["faces"], np.int32).reshape(-1, 3), region["orientation"] == "reversing",
                              confidence, region.get("ways", 1), region.get("ambiguous", False)))
    return Found(tuple(regions), np.array(data["vertices"], np.int32).reshape(-1, 2))
