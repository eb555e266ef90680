#pragma once
/// The topology of a soup counted by hand, from its faces alone: an oracle that shares no code with the mesh.

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::testing {

using Face = std::vector<std::uint32_t>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

inline std::vector<Face> faces_of(const PolygonSoup& soup) {
  std::vector<Face> faces;
  const std::size_t count = soup.face_starts.empty() ? soup.corners.size() / 4 : soup.face_starts.size() - 1;
  for (std::size_t f = 0; f < count; ++f) {
    const std::size_t begin = soup.face_starts.empty() ? 4 * f : soup.face_starts[f];
    const std::size_t end = soup.face_starts.empty() ? 4 * f + 4 : soup.face_starts[f + 1];
    Face& face = faces.emplace_back();
    for (std::size_t c = begin; c < end; ++c) face.push_back(soup.corners[c].value);
  }
  return faces;
}

struct Topology {
  std::uint32_t vertices = 0;  ///< those that a face uses
  std::uint32_t edges = 0;     ///< pairs of vertices
  std::uint32_t faces = 0;
  std::uint32_t components = 0;                              ///< across shared vertices
  std::uint32_t boundary_loops = 0;                          ///< where every vertex has no or two edges of one face
  std::uint32_t crowded_edges = 0;                           ///< of more than two faces
  std::uint32_t miswound_edges = 0;                          ///< of two faces that run along it the same way
  std::uint32_t extraordinary = 0;                           ///< valence other than 4 inside, 3 on the boundary
  std::map<std::uint32_t, std::uint32_t> inner_valences;     ///< valence -> how many inner vertices
  std::map<std::uint32_t, std::uint32_t> boundary_valences;  ///< likewise on the boundary

  /// n - m + q + b = 2 - 2 g for one component (Obs. 2.3, with each hole closed by a disk); -1 where that is odd.
  [[nodiscard]] int genus() const {
    const int twice = 2 - (static_cast<int>(vertices) - static_cast<int>(edges) + static_cast<int>(faces) +
                           static_cast<int>(boundary_loops));
    return twice % 2 == 0 ? twice / 2 : -1;
  }
  [[nodiscard]] bool clean() const { return crowded_edges == 0 && miswound_edges == 0; }
};

/// Sets that are united one pair at a time; their number.
class UnitedSets {
 public:
  explicit UnitedSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t root(std::uint32_t x) {
    while (parent_[x] != x) x = parent_[x] = parent_[parent_[x]];
    return x;
  }
  void unite(std::uint32_t x, std::uint32_t y) { parent_[root(x)] = root(y); }
  [[nodiscard]] std::uint32_t count(const std::set<std::uint32_t>& members) {
    std::set<std::uint32_t> roots;
    for (const std::uint32_t x : members) roots.insert(root(x));
    return static_cast<std::uint32_t>(roots.size());
  }

 private:
  std::vector<std::uint32_t> parent_;
};

inline Topology topology_of(const PolygonSoup& soup) {
  const std::vector<Face> faces = faces_of(soup);
  std::map<Edge, std::pair<int, int>> uses;  // how often a face runs up, and down, each edge
  std::set<std::uint32_t> used;
  UnitedSets pieces(soup.vertex_count), loops(soup.vertex_count);
  for (const Face& face : faces) {
    for (std::size_t k = 0; k < face.size(); ++k) {
      const std::uint32_t from = face[k], to = face[(k + 1) % face.size()];
      auto& [up, down] = uses[std::minmax(from, to)];
      ++(from < to ? up : down);
      used.insert(from);
      pieces.unite(from, to);
    }
  }
  Topology topology;
  std::map<std::uint32_t, std::uint32_t> valence;
  std::set<std::uint32_t> rim;
  for (const auto& [edge, count] : uses) {
    const auto [up, down] = count;
    ++valence[edge.first];
    ++valence[edge.second];
    if (up + down > 2) ++topology.crowded_edges;
    if (up + down == 2 && up != down) ++topology.miswound_edges;
    if (up + down != 1) continue;
    loops.unite(edge.first, edge.second);
    rim.insert({edge.first, edge.second});
  }
  for (const auto& [vertex, count] : valence) {
    const bool boundary = rim.count(vertex) > 0;
    ++(boundary ? topology.boundary_valences : topology.inner_valences)[count];
    if (count != (boundary ? 3U : 4U)) ++topology.extraordinary;
  }
  topology.vertices = static_cast<std::uint32_t>(used.size());
  topology.edges = static_cast<std::uint32_t>(uses.size());
  topology.faces = static_cast<std::uint32_t>(faces.size());
  topology.components = pieces.count(used);
  topology.boundary_loops = loops.count(rim);
  return topology;
}

/// Simple and, as far as pairs of quads go, well-formed (§2.1): no vertex twice in a face, and any two faces meet in
/// one edge, one vertex, or not at all.
inline bool faces_meet_properly(const PolygonSoup& soup) {
  const std::vector<Face> faces = faces_of(soup);
  std::map<std::uint32_t, std::vector<std::size_t>> faces_at;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    if (std::set(faces[f].begin(), faces[f].end()).size() != faces[f].size()) return false;
    for (const std::uint32_t v : faces[f]) faces_at[v].push_back(f);
  }
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::uint32_t>> shared;
  for (const auto& [v, around] : faces_at) {
    for (const std::size_t f : around) {
      for (const std::size_t g : around) {
        if (f < g) shared[{f, g}].push_back(v);
      }
    }
  }
  return std::all_of(shared.begin(), shared.end(), [&](const auto& entry) {
    const auto& [pair, vertices] = entry;
    if (vertices.size() == 1) return true;
    if (vertices.size() > 2) return false;
    const Face& face = faces[pair.first];
    const auto at = [&](std::uint32_t v) { return std::find(face.begin(), face.end(), v) - face.begin(); };
    const auto apart = static_cast<std::size_t>(std::abs(at(vertices[0]) - at(vertices[1])));
    return apart == 1 || apart == face.size() - 1;
  });
}

}  // namespace quadmatch::testing
