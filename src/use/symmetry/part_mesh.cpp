#include "part_mesh.hpp"

#include <cassert>
#include <utility>

#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {
namespace {

/// What was taken out of a mesh is one.
Mesh built(PolygonSoup soup) {
  Expected<Mesh> mesh = Mesh::build(std::move(soup));
  assert(mesh.has_value());
  return *std::move(mesh);
}

Mesh mesh_of(const Mesh& whole, const std::vector<FaceId>& faces) {
  PolygonSoup soup;
  PerVertex<VertexId> number(whole.vertex_count());
  if (!whole.all_quads()) soup.face_starts.push_back(0);
  for (const FaceId face : faces) {
    for (const HalfedgeId h : whole.halfedges(face)) {
      const VertexId v = whole.origin(h);
      if (!number[v].valid()) {
        number[v] = VertexId(soup.vertex_count++);
        if (!whole.positions().empty()) soup.positions.push_back(whole.positions()[v.value]);
      }
      soup.corners.push_back(number[v]);
    }
    if (!whole.all_quads()) soup.face_starts.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  return built(std::move(soup));
}

}  // namespace

Mesh with_positions(const Mesh& mesh, std::vector<Point> positions) {
  PolygonSoup soup;
  soup.vertex_count = mesh.vertex_count();
  soup.positions = std::move(positions);
  soup.corners.assign(mesh.corners().begin(), mesh.corners().end());
  if (!mesh.all_quads()) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) soup.face_starts.push_back(mesh.first(FaceId(f)).value);
    soup.face_starts.push_back(mesh.halfedge_count());
  }
  return built(std::move(soup));
}

Mesh moved(const Mesh& mesh, const MirrorPlane& plane) {
  std::vector<Point> positions;
  positions.reserve(mesh.vertex_count());
  for (const Point& p : mesh.positions()) positions.push_back(plane.mirrored(p));
  return with_positions(mesh, std::move(positions));
}

PartMesh::PartMesh(const Mesh& whole, std::vector<FaceId> faces)
    : whole_(whole), faces_(std::move(faces)), mesh_(mesh_of(whole, faces_)) {}

HalfedgeId PartMesh::to_whole(HalfedgeId h) const {
  return HalfedgeId(whole_.first(faces_[mesh_.face(h).value]).value + mesh_.corner(h));
}

}  // namespace quadmatch::use
