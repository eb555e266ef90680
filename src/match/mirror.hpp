#pragma once
/// Between a mesh and its mirror image.

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// The half-edge that leaves the same corner in the mirror, and back again: corner k is corner n - 1 - k there
/// (Mesh::mirrored).
[[nodiscard]] inline HalfedgeId in_mirror(const Mesh& mesh, HalfedgeId h) {
  const FaceId f = mesh.face(h);
  return HalfedgeId(mesh.first(f).value + mesh.size(f) - 1 - mesh.corner(h));
}

}  // namespace quadmatch
