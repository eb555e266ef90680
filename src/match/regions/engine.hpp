#pragma once
/// The regions engine: many anchors, many regions, belief by evidence. One function, its stages in order.

#include <cstddef>
#include <functional>
#include <vector>

#include <quadmatch/match/matcher.hpp>

#include "split.hpp"

namespace quadmatch::regions {

/// Called with the faces matched so far; false cancels.
using EngineProgress = std::function<bool(std::size_t matched)>;

/// What came of it.
struct Outcome {
  /// Sound, and no two share a face.
  std::vector<Piece> pieces;
  bool complete = true;
};

/// Match two meshes, orientation preserving.
/// @param anchors  the user's, of this laying; never overruled.
[[nodiscard]] Outcome match_regions(const Sides& sides, const MatchOptions& options, const std::vector<Anchor>& anchors,
                                    const EngineProgress& progress);

}  // namespace quadmatch::regions
