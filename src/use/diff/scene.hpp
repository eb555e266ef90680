#pragma once
/// One area of change as seen from either end: what was before, and what is after. Kinds are named for what came; what
/// went is the same seen the other way round.

#include <vector>

#include "disputes.hpp"

namespace quadmatch::use {

/// One side of a matched face at the rim of the area, in both meshes.
struct RimSide {
  HalfedgeId before, after;
  Beyond in_before = Beyond::Nothing, in_after = Beyond::Nothing;
};

struct Scene {
  const Side* before = nullptr;
  const Side* after = nullptr;
  std::vector<FaceId> faces_before = {}, faces_after = {};  ///< unmatched, ascending
  std::uint32_t pieces_before = 0, pieces_after = 0;
  std::vector<RimSide> rim = {};
  /// It is a vertex at which matched faces hang together before only, or after only.
  bool torn = false, joined = false;
  bool positions = false;  ///< may be asked where connectivity leaves a choice of names
};

/// The area from source to target.
[[nodiscard]] Scene forwards(const Sides& sides, const Area& area, bool positions);
/// The same from target to source.
[[nodiscard]] Scene backwards(const Scene& scene);

}  // namespace quadmatch::use
