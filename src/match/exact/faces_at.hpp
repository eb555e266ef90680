#pragma once
/// The faces at each vertex of both meshes.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "partial.hpp"

namespace quadmatch::exact {

class FacesAt {
 public:
  explicit FacesAt(const Partial& partial) {
    for (const Side side : {kSource, kTarget}) fill(partial.mesh(side), first_at_[side], faces_at_[side]);
  }

  /// A face that passes the vertex twice is there twice.
  [[nodiscard]] std::span<const FaceId> of(Side side, VertexId v) const {
    const std::uint32_t first = first_at_[side][v.value];
    return std::span(faces_at_[side]).subspan(first, first_at_[side][v.value + 1] - first);
  }

 private:
  static void fill(const Mesh& mesh, std::vector<std::uint32_t>& first, std::vector<FaceId>& faces) {
    first.assign(mesh.vertex_count() + 1, 0);
    for (const VertexId v : mesh.corners()) ++first[v.value + 1];
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) first[v + 1] += first[v];
    faces.resize(mesh.halfedge_count());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
      faces[next[mesh.origin(HalfedgeId(h)).value]++] = mesh.face(HalfedgeId(h));
    }
  }

  std::array<std::vector<std::uint32_t>, 2> first_at_;
  std::array<std::vector<FaceId>, 2> faces_at_;
};

}  // namespace quadmatch::exact
