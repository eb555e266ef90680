#pragma once
/// The same mesh in another order: what no matcher may notice.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/per_element.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

struct Renumbered {
  PolygonSoup soup;
  /// The new number of each old vertex.
  PerVertex<VertexId> vertices;
  /// The new place of each old face, ascending by `source`: the true match, orientation preserving.
  std::vector<FacePair> faces;
};

/// Permute vertices and faces, and let every face start at another corner, all at random.
/// Positions move with their vertices. The same seed gives the same soup on every machine.
/// @par Cost  O(#V + #corners).
[[nodiscard]] Renumbered renumbered(const PolygonSoup& soup, std::uint64_t seed);

}  // namespace quadmatch::shapes
