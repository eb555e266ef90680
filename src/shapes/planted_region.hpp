#pragma once
/// What one sound region can hold of a true correspondence, and how it lies between what it leaves out.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::shapes {

/// A largest part that is connected and has no vertex in conflict, and then whatever else fits beside it, by lowest
/// face.
/// @param truth  pairs of faces of equal size, each face in one.
/// @return       pairs of the truth; with them, no vertex has two images or two originals.
[[nodiscard]] std::vector<FacePair> sound_part(const Mesh& source, const Mesh& target,
                                               const std::vector<FacePair>& truth);

struct Rims {
  std::uint32_t longest = 0;  ///< edges of the longest rim of a mismatch
  /// Fewest faces of the region on a way from one rim, or end of both meshes, to another, across vertices; more than
  /// there are faces where there is only one.
  std::uint32_t narrowest = 0;
  /// For each pair of the region, across how many vertices one must step from it to a rim; 0 at a rim.
  std::vector<std::uint32_t> depth = {};
};

/// @param region  as of sound_part.
[[nodiscard]] Rims measure_rims(const Mesh& source, const Mesh& target, const std::vector<FacePair>& region);

/// For each face, how many steps across vertices lead to it from the nearest start; starts have 0. Only allowed faces
/// are entered; unreached ones get more than there are faces.
[[nodiscard]] std::vector<std::uint32_t> steps_from(const Mesh& mesh, const std::vector<FaceId>& starts,
                                                    const std::vector<bool>& allowed);

}  // namespace quadmatch::shapes
