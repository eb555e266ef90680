#pragma once
/// A mirror as the regions of a sound match, and back.

#include <functional>
#include <vector>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/match.hpp>

#include "mirror_map.hpp"

namespace quadmatch::use {

/// Of regions of a mesh on another, or itself: the half-edge on which each lies, turned over; not valid where none.
/// @pre  they are reversing
[[nodiscard]] PerHalfedge<HalfedgeId> images_of(const Mesh& mesh, const Mesh& other,
                                                const std::vector<Region>& regions);

/// The laid faces for which `wanted` holds, each with its partner, in regions that are sound: connected, one-to-one at
/// vertices, adjacent exactly where their partners are. From the largest, ties by first face.
/// @par Cost  O(#faces).
[[nodiscard]] std::vector<Region> regions_of(const Mesh& mesh, const PerFan<VertexCode>& codes, const MirrorMap& map,
                                             const std::function<bool(FaceId)>& wanted);

/// The vertex map of such regions: one-to-one, where they disagree the larger one's, ascending. Where each region's
/// partners are in regions too it is its own inverse.
/// @param mutual  with (v, w) comes (w, v)
[[nodiscard]] std::vector<VertexPair> vertices_of(const Mesh& mesh, const std::vector<Region>& regions, bool mutual);

}  // namespace quadmatch::use
