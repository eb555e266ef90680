#pragma once
/// Connected components across edges, the pieces a fire can spread through (§2.1, the dual graph).

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch {

struct Components {
  /// The component of each face, 0 ... size - 1, numbered by their lowest face.
  PerFace<std::uint32_t> of_face;
  /// Faces in each.
  std::vector<std::uint32_t> face_count;
};

/// Label the components of the dual graph. Faces that meet only at a vertex or a seam are not connected.
/// @par Cost  O(#corners).
[[nodiscard]] Components connected_components(const Mesh& mesh);

}  // namespace quadmatch
