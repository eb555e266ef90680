#pragma once
/// The regions engine: many anchors, many regions, belief by evidence. One function, its stages in order.

#include <vector>

#include "split.hpp"

namespace quadmatch::regions {

/// Which of the later stages are to run, for comparison.
struct Stages {
  bool seams = true;
  bool slivers = true;
  bool islands = true;
  bool slides = true;
  bool ties = true;
  bool restarts = true;
  bool acceptance = true;
};

struct EngineOptions {
  /// Let edge lengths and distances weigh in where evidence is thin.
  bool positions = true;
  Stages stages = {};
};

/// Match two meshes, orientation preserving. @return sound pieces that share no face.
[[nodiscard]] std::vector<Piece> match_regions(const Sides& sides, const EngineOptions& options);

}  // namespace quadmatch::regions
