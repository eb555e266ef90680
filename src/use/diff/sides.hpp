#pragma once
/// Two meshes and what a match says of them, the same from either side.

#include <cstdint>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {

/// What lies across a side of a face.
enum class Beyond : std::uint8_t { Nothing, Matched, Unmatched };

/// One of the meshes. Images are of sides, not of corners: a half-edge of a matched face lies on one of its partner,
/// whichever way round.
struct Side {
  const Mesh* mesh = nullptr;
  /// The half-edge of the other mesh on which each lies; not valid where its face is unmatched.
  PerHalfedge<HalfedgeId> image;

  [[nodiscard]] bool is_matched(FaceId f) const { return image[mesh->first(f)].valid(); }
  [[nodiscard]] Beyond beyond(HalfedgeId h) const {
    const HalfedgeId other = mesh->twin(h);
    return !other.valid() ? Beyond::Nothing : image[other].valid() ? Beyond::Matched : Beyond::Unmatched;
  }
};

struct Sides {
  Side source, target;
};

/// @param least_confidence  regions below it are passed over.
[[nodiscard]] Sides lay_sides(const Mesh& source, const Mesh& target, const Match& match, double least_confidence);

}  // namespace quadmatch::use
