#pragma once
/// Meshes made of a mesh: one component of it, or the same with other positions.

#include <vector>

#include <quadmatch/mesh/components.hpp>
#include <quadmatch/use/symmetry.hpp>

namespace quadmatch::use {

/// The same mesh with other positions.
/// @param positions  one per vertex
[[nodiscard]] Mesh with_positions(const Mesh& mesh, std::vector<Point> positions);

/// The same mesh with its positions mirrored in a plane, and its faces as they are. @pre it has positions
[[nodiscard]] Mesh moved(const Mesh& mesh, const MirrorPlane& plane);

/// One component as a mesh of its own.
class PartMesh {
 public:
  PartMesh(const Mesh& whole, const Components& components, std::uint32_t component);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  /// @pre  h is of the component
  [[nodiscard]] HalfedgeId from_whole(HalfedgeId h) const;
  [[nodiscard]] HalfedgeId to_whole(HalfedgeId h) const;

 private:
  const Mesh& whole_;
  std::vector<FaceId> faces_;  // of the whole, ascending
  Mesh mesh_;
};

}  // namespace quadmatch::use
