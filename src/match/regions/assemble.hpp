#pragma once
/// From pieces to the match that users see: the largest region first, one vertex map, evidence.

#include <vector>

#include <quadmatch/mesh/match.hpp>

#include "split.hpp"

namespace quadmatch::regions {

/// @param pieces       sound, sharing no face.
/// @param orientation  Reversing: the target was laid in its mirror image; rotations are given for it as it was.
[[nodiscard]] Match assemble(const Sides& sides, std::vector<Piece> pieces, Orientation orientation, bool with_waves);

}  // namespace quadmatch::regions
