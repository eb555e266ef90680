#include "in_place.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace quadmatch::use {
namespace {

/// Of the shortest side of a face: what files lose to rounding.
constexpr double kTolerance = 1e-3;

double squared_distance(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
  return sum;
}

PerVertex<std::uint8_t> vertices_that_share_a_place(const Mesh& mesh) {
  const auto positions = mesh.positions();
  PerVertex<std::uint8_t> shares(mesh.vertex_count(), 0);
  std::vector<std::uint32_t> order(mesh.vertex_count());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::uint32_t v, std::uint32_t w) { return positions[v] < positions[w]; });
  for (std::size_t k = 1; k < order.size(); ++k) {
    if (positions[order[k]] != positions[order[k - 1]]) continue;
    shares[VertexId(order[k])] = shares[VertexId(order[k - 1])] = 1;
  }
  return shares;
}

}  // namespace

InPlace::InPlace(const Mesh& source, const Mesh& target) : source_(source), target_(target) {
  if (source.positions().empty() || target.positions().empty()) return;
  shares_its_place_ = vertices_that_share_a_place(source);
}

bool InPlace::holds(const FacePair& pair, Orientation orientation) const {
  if (shares_its_place_.size() == 0) return false;
  const std::uint32_t size = source_.size(pair.source);
  double shortest = std::numeric_limits<double>::infinity(), farthest = 0;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const HalfedgeId there(source_.first(pair.source).value + corner);
    const HalfedgeId here(target_.first(pair.target).value + image_corner(orientation, pair.rotation, corner, size));
    const VertexId v = source_.origin(there);
    if (shares_its_place_[v] != 0) return false;
    const Point& from = source_.positions()[v.value];
    shortest =
        std::min(shortest, squared_distance(from, source_.positions()[source_.origin(source_.next(there)).value]));
    farthest = std::max(farthest, squared_distance(from, target_.positions()[target_.origin(here).value]));
  }
  return farthest <= kTolerance * kTolerance * shortest;
}

}  // namespace quadmatch::use
