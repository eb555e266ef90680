#pragma once
/// Where the two meshes go on differently beyond matched faces, gathered into areas of change.

#include <vector>

#include "sides.hpp"

namespace quadmatch::use {

/// A side of a matched face beyond which the meshes differ: no face, an unmatched face, or one that does not lie on
/// what is beyond its image.
struct Dispute {
  HalfedgeId source, target;  ///< the side, and its image
  Beyond in_source = Beyond::Nothing, in_target = Beyond::Nothing;

  /// Matched faces are adjacent in one mesh and not in the other, and no unmatched face has to do with it.
  [[nodiscard]] bool is_cut() const { return in_source != Beyond::Unmatched && in_target != Beyond::Unmatched; }
};

/// What belongs together: areas of unmatched faces of both meshes, and the disputes around and between them.
struct Area {
  std::vector<FaceId> source_faces, target_faces;  ///< ascending
  /// Pieces, connected across edges, that these make.
  std::uint32_t source_pieces = 0, target_pieces = 0;
  std::vector<Dispute> disputes;  ///< ascending by source
  /// Or else a single vertex where matched faces meet in the source only, or in the target only, though no edge tells
  /// of it; and those faces, of the source.
  bool torn = false, joined = false;
  std::vector<FaceId> met = {};
};

/// All of them, in the order of their lowest parts. Unmatched pieces are in one area where they meet the same edge of
/// matched faces; cuts are in one where they meet at a vertex.
/// @par Cost  O(#V + #corners).
[[nodiscard]] std::vector<Area> find_areas(const Sides& sides);

}  // namespace quadmatch::use
