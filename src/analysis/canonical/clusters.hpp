#pragma once
/// What of a mesh must be looked at together: faces that hang together across edges or vertices.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/components.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::canonical {

/// Components that share vertices are tied: a map of one of them says something about the others. A cluster is a
/// largest set of tied components, most often a single one.
struct Clusters {
  Components components;
  /// The cluster of each component, 0 ... size - 1, numbered by their lowest face.
  std::vector<std::uint32_t> of_component;
  /// The lowest face of each.
  std::vector<FaceId> first_face;
  /// Is it one component?
  std::vector<bool> is_single;
  /// Is it one component, and has none of its vertices more than one fan?
  std::vector<bool> is_clean;

  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(first_face.size()); }
  [[nodiscard]] std::uint32_t of_face(FaceId face) const { return of_component[components.of_face[face]]; }
};

/// @par Cost  O(#corners).
[[nodiscard]] Clusters clusters_of(const Mesh& mesh);

}  // namespace quadmatch::canonical
