#include "redraft.hpp"

#include <utility>

#include "geometry.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {

Redraft::Redraft(const PolygonSoup& source) : source_(source) {
  draft_.vertex_count = source.vertex_count;
  draft_.positions = source.positions;
  draft_.face_starts = {0};
}

VertexId Redraft::add_vertex(std::initializer_list<VertexId> around) {
  if (!draft_.positions.empty()) {
    Point sum = {};
    for (const VertexId v : around) sum = sum + draft_.positions[v.value];
    draft_.positions.push_back((1.0 / static_cast<double>(around.size())) * sum);
  }
  return VertexId(draft_.vertex_count++);
}

void Redraft::move_vertex(VertexId vertex, const Point& by) {
  if (draft_.positions.empty()) return;
  Point& point = draft_.positions[vertex.value];
  point = point + by;
}

void Redraft::move_halfway(VertexId vertex, VertexId towards) {
  if (draft_.positions.empty()) return;
  move_vertex(vertex, 0.5 * (draft_.positions[towards.value] - draft_.positions[vertex.value]));
}

void Redraft::keep(FaceId face) { keep(face, corners_of(source_, face.value)); }

void Redraft::keep(FaceId face, std::span<const VertexId> corners) {
  truth_.push_back({face, FaceId(static_cast<std::uint32_t>(draft_.face_starts.size() - 1)), 0});
  append(corners);
}

void Redraft::append(std::span<const VertexId> corners) {
  draft_.corners.insert(draft_.corners.end(), corners.begin(), corners.end());
  draft_.face_starts.push_back(static_cast<std::uint32_t>(draft_.corners.size()));
}

Edit Redraft::finish() {
  std::vector<VertexId> new_number(draft_.vertex_count);
  for (const VertexId v : draft_.corners) new_number[v.value] = v;
  std::uint32_t used = 0;
  for (std::uint32_t v = 0; v < draft_.vertex_count; ++v) {
    if (!new_number[v].valid()) continue;
    new_number[v] = VertexId(used);
    if (!draft_.positions.empty()) draft_.positions[used] = draft_.positions[v];
    ++used;
  }
  for (VertexId& v : draft_.corners) v = new_number[v.value];
  draft_.vertex_count = used;
  if (!draft_.positions.empty()) draft_.positions.resize(used);
  bool all_quads = true;
  for (std::uint32_t f = 0; f < face_count(draft_); ++f) all_quads = all_quads && corners_of(draft_, f).size() == 4;
  if (all_quads) draft_.face_starts.clear();
  return {std::move(draft_), std::move(truth_)};
}

}  // namespace quadmatch::shapes
