#pragma once
/// The edges of a soup as pairs of vertices, whatever the faces do there.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

struct UndirectedEdge {
  VertexId lower, upper;   ///< lower <= upper
  std::uint32_t uses = 0;  ///< sides of faces along it
};

struct EdgeTable {
  /// Ordered by the lower, then the upper end.
  std::vector<UndirectedEdge> edges;
  /// The edge of the side that leaves each corner.
  std::vector<std::uint32_t> of_corner;
};

/// @par Cost  O(#V + #corners), O(d log d) at a vertex of d edges.
[[nodiscard]] EdgeTable build_edge_table(const PolygonSoup& soup);

}  // namespace quadmatch::shapes
