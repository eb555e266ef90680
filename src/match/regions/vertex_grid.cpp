#include "vertex_grid.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <span>

#include "similarity.hpp"

namespace quadmatch::regions {

VertexGrid::VertexGrid(const Mesh& mesh, double cell) : mesh_(mesh), cell_(cell) {
  const std::span<const Point> positions = mesh.positions();
  // Keys are well mixed: their first bits alone spread the vertices evenly.
  const auto bits = static_cast<int>(std::bit_width(positions.size() + 1));
  shift_ = 64 - bits;
  first_.assign((std::size_t{1} << bits) + 1, 0);
  std::vector<std::uint64_t> keys;
  keys.reserve(positions.size());
  for (const Point& p : positions) ++first_[bucket_of(keys.emplace_back(key_of(cell_of(p)))) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  vertices_.resize(positions.size());
  for (std::uint32_t v = 0; v < keys.size(); ++v) vertices_[next[bucket_of(keys[v])]++] = {keys[v], VertexId(v)};
}

VertexGrid::Cell VertexGrid::cell_of(const Point& p) const {
  Cell cell;
  constexpr double kFar = 1e15;  // beyond, all is one cell: no mesh of sense is that wide
  for (std::size_t axis = 0; axis < 3; ++axis) {
    cell[axis] = static_cast<std::int64_t>(std::clamp(std::floor(p[axis] / cell_), -kFar, kFar));
  }
  return cell;
}

/// Cells may share a key; what is found is measured anyway.
std::uint64_t VertexGrid::key_of(const Cell& cell) {
  std::uint64_t key = 0;
  for (const std::int64_t number : cell) key = (key ^ static_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15U;
  return key;
}

/// Calls visit(vertex, square of its distance) until one says no.
template <class Visit>
void VertexGrid::near(const Point& p, double distance, Visit visit) const {
  const Cell low = cell_of({p[0] - distance, p[1] - distance, p[2] - distance});
  const Cell high = cell_of({p[0] + distance, p[1] + distance, p[2] + distance});
  for (std::int64_t x = low[0]; x <= high[0]; ++x) {
    for (std::int64_t y = low[1]; y <= high[1]; ++y) {
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const std::uint64_t key = key_of({x, y, z});
        const std::size_t bucket = bucket_of(key);
        for (std::uint32_t k = first_[bucket]; k < first_[bucket + 1]; ++k) {
          const auto& [other, vertex] = vertices_[k];
          if (other != key) continue;
          const double away = squared_distance(mesh_.positions()[vertex.value], p);
          if (away <= distance * distance && !visit(vertex, away)) return;
        }
      }
    }
  }
}

VertexId VertexGrid::nearest(const Point& p, double distance) const {
  VertexId best;
  double least = 0;
  near(p, distance, [&](VertexId v, double away) {
    if (!best.valid() || away < least) {
      best = v;
      least = away;
    }
    return true;
  });
  return best;
}

bool VertexGrid::any_within(const Point& p, double distance) const {
  bool found = false;
  near(p, distance, [&](VertexId, double) {
    found = true;
    return false;
  });
  return found;
}

double mean_edge(const Mesh& mesh) {
  double sum = 0;
  // Each edge once, by the lower of its half-edges. Which that is nobody can guess, so they are first put on a list.
  std::array<HalfedgeId, 512> edges;
  for (std::uint32_t first = 0; first < mesh.halfedge_count(); first += edges.size()) {
    const std::uint32_t last = std::min<std::uint32_t>(mesh.halfedge_count(), first + edges.size());
    std::size_t count = 0;
    for (HalfedgeId h(first); h.value < last; ++h.value) {
      edges[count] = h;
      count += h < mesh.twin(h);
    }
    for (const HalfedgeId h : std::span(edges).first(count)) {
      const double squared =
          squared_distance(mesh.positions()[mesh.origin(h).value], mesh.positions()[mesh.tip(h).value]);
      sum += (mesh.twin(h).valid() ? 2 : 1) * std::sqrt(squared);
    }
  }
  return mesh.halfedge_count() == 0 ? 0 : sum / mesh.halfedge_count();
}

}  // namespace quadmatch::regions
