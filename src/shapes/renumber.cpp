#include <quadmatch/shapes/renumber.hpp>

#include <quadmatch/shapes/random.hpp>

#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

void move_vertices(const PolygonSoup& soup, Random& random, Renumbered& result) {
  const std::vector<std::uint32_t> order = random.permutation(soup.vertex_count);
  result.soup.vertex_count = soup.vertex_count;
  result.soup.positions.resize(soup.positions.size());
  result.vertices = PerVertex<VertexId>(soup.vertex_count);
  for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
    result.vertices[VertexId(v)] = VertexId(order[v]);
    if (!soup.positions.empty()) result.soup.positions[order[v]] = soup.positions[v];
  }
}

void move_faces(const PolygonSoup& soup, Random& random, Renumbered& result) {
  const std::uint32_t count = face_count(soup);
  const std::vector<std::uint32_t> old_face_at = random.permutation(count);
  result.faces.resize(count);
  result.soup.corners.reserve(soup.corners.size());
  for (std::uint32_t g = 0; g < count; ++g) {
    const std::uint32_t f = old_face_at[g];
    const auto corners = corners_of(soup, f);
    const auto size = static_cast<std::uint32_t>(corners.size());
    const std::uint32_t rotation = size > 0 ? random.below(size) : 0;
    result.faces[f] = {FaceId(f), FaceId(g), rotation};
    if (!soup.face_starts.empty()) {
      result.soup.face_starts.push_back(static_cast<std::uint32_t>(result.soup.corners.size()));
    }
    for (std::uint32_t i = 0; i < size; ++i) {
      result.soup.corners.push_back(result.vertices[corners[(i + size - rotation) % size]]);
    }
  }
  if (!soup.face_starts.empty()) {
    result.soup.face_starts.push_back(static_cast<std::uint32_t>(result.soup.corners.size()));
  }
}

}  // namespace

Renumbered renumbered(const PolygonSoup& soup, std::uint64_t seed) {
  Renumbered result;
  Random random(seed);
  move_vertices(soup, random, result);
  move_faces(soup, random, result);
  return result;
}

}  // namespace quadmatch::shapes
