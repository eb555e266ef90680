#pragma once
/// The regions engine: many anchors, many regions, belief by evidence. One function, its stages in order.

#include <vector>

#include "split.hpp"

namespace quadmatch::regions {

/// Match two meshes, orientation preserving. @return sound pieces that share no face.
[[nodiscard]] std::vector<Piece> match_regions(const Sides& sides);

}  // namespace quadmatch::regions
