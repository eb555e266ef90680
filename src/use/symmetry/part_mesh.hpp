#pragma once
/// Meshes made of a mesh: some of its faces, or the same with other positions.

#include <vector>

#include <quadmatch/use/symmetry.hpp>

namespace quadmatch::use {

/// The same mesh with other positions.
/// @param positions  one per vertex
[[nodiscard]] Mesh with_positions(const Mesh& mesh, std::vector<Point> positions);

/// The same mesh with its positions mirrored in a plane, and its faces as they are. @pre it has positions
[[nodiscard]] Mesh moved(const Mesh& mesh, const MirrorPlane& plane);

/// Some faces as a mesh of their own.
class PartMesh {
 public:
  /// @param faces  ascending
  PartMesh(const Mesh& whole, std::vector<FaceId> faces);

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  [[nodiscard]] HalfedgeId to_whole(HalfedgeId h) const;

 private:
  const Mesh& whole_;
  std::vector<FaceId> faces_;  // of the whole, ascending
  Mesh mesh_;
};

}  // namespace quadmatch::use
