#include "edge_table.hpp"

#include <algorithm>
#include <utility>

#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

/// A side of a face, kept in the bucket of its lower end.
struct Side {
  VertexId upper;
  std::uint32_t corner;

  auto operator<=>(const Side&) const = default;
};

template <class Visit>
void for_each_side(const PolygonSoup& soup, Visit visit) {
  for (std::uint32_t f = 0, count = face_count(soup); f < count; ++f) {
    const auto corners = corners_of(soup, f);
    const std::uint32_t first = first_corner(soup, f);
    for (std::uint32_t k = 0; k < corners.size(); ++k) {
      const auto ends = std::minmax(corners[k], corners[k + 1 < corners.size() ? k + 1 : 0]);
      visit(first + k, VertexId(ends.first), VertexId(ends.second));
    }
  }
}

}  // namespace

EdgeTable build_edge_table(const PolygonSoup& soup) {
  std::vector<std::uint32_t> bucket_end(soup.vertex_count + 1, 0);
  for_each_side(soup, [&](std::uint32_t, VertexId lower, VertexId) { ++bucket_end[lower.value + 1]; });
  for (std::uint32_t v = 0; v < soup.vertex_count; ++v) bucket_end[v + 1] += bucket_end[v];

  // While the buckets are filled, bucket_end[v] runs from where v's begins to where it ends.
  std::vector<Side> sides(soup.corners.size());
  for_each_side(soup, [&](std::uint32_t corner, VertexId lower, VertexId upper) {
    sides[bucket_end[lower.value]++] = {upper, corner};
  });

  EdgeTable table;
  table.of_corner.resize(soup.corners.size());
  table.edges.reserve(soup.corners.size() / 2 + 1);
  auto begin = sides.begin();
  for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
    const auto end = sides.begin() + bucket_end[v];
    std::sort(begin, end);
    for (auto side = begin; side != end; ++side) {
      if (side == begin || side->upper != (side - 1)->upper) table.edges.push_back({VertexId(v), side->upper});
      ++table.edges.back().uses;
      table.of_corner[side->corner] = static_cast<std::uint32_t>(table.edges.size() - 1);
    }
    begin = end;
  }
  return table;
}

}  // namespace quadmatch::shapes
