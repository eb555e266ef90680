#pragma once
/// The faces of a soup, whether or not all are quads.

#include <cstdint>
#include <span>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

[[nodiscard]] inline std::uint32_t face_count(const PolygonSoup& soup) {
  const std::size_t count = soup.face_starts.empty() ? soup.corners.size() / 4 : soup.face_starts.size() - 1;
  return static_cast<std::uint32_t>(count);
}
[[nodiscard]] inline std::uint32_t first_corner(const PolygonSoup& soup, std::uint32_t face) {
  return soup.face_starts.empty() ? 4 * face : soup.face_starts[face];
}
[[nodiscard]] inline std::span<const VertexId> corners_of(const PolygonSoup& soup, std::uint32_t face) {
  const std::uint32_t first = first_corner(soup, face);
  return std::span(soup.corners).subspan(first, first_corner(soup, face + 1) - first);
}

}  // namespace quadmatch::shapes
