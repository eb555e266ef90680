#include <quadmatch/analysis/vertex_code.hpp>

namespace quadmatch {
namespace {

constexpr std::uint16_t kOneEdge = 4;
constexpr std::uint16_t kOnBoundary = 2;
constexpr std::uint16_t kTouchesNonQuad = 1;
constexpr std::uint16_t kMostEdges = 16383 * kOneEdge;

void add_edge(VertexCode& code) {
  if (code.value < kMostEdges) code.value = static_cast<std::uint16_t>(code.value + kOneEdge);
}

}  // namespace

PerFan<VertexCode> vertex_codes(const Mesh& mesh) {
  // One edge for each corner in file order, and at the corner where a boundary fan ends the edge that closes it: faster
  // than walking the fans.
  PerFan<VertexCode> codes(mesh.fan_count());
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    VertexCode& code = codes[mesh.fan(HalfedgeId(h))];
    add_edge(code);
    if (mesh.twin(HalfedgeId(h)).valid()) continue;
    add_edge(code);
    code.value |= kOnBoundary;
  }
  for (std::uint32_t f = 0; !mesh.all_quads() && f < mesh.face_count(); ++f) {
    if (mesh.size(FaceId(f)) == 4) continue;
    for (const HalfedgeId h : mesh.halfedges(FaceId(f))) codes[mesh.fan(h)].value |= kTouchesNonQuad;
  }
  return codes;
}

}  // namespace quadmatch
