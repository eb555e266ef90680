#pragma once
/// What a reader makes and a `Mesh` is built from: positions and polygons, with no promise about how they meet.

#include <array>
#include <cstdint>
#include <vector>

#include <quadmatch/mesh/ids.hpp>

namespace quadmatch {

/// x, y, z in the units of the file.
using Point = std::array<double, 3>;

struct PolygonSoup {
  /// How many vertices there are; faces may name 0 ... vertex_count - 1.
  std::uint32_t vertex_count = 0;
  /// One per vertex, or empty where only connectivity is known.
  std::vector<Point> positions = {};
  /// The vertex of each corner, face after face, counter-clockwise seen from outside.
  std::vector<VertexId> corners = {};
  /// Where each face starts in `corners`, with the total at the end (#F + 1 numbers).
  /// Empty means that every face has four corners.
  std::vector<std::uint32_t> face_starts = {};
};

}  // namespace quadmatch
