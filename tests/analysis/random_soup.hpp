#pragma once
/// Small soups that nobody would model: faces of any corners over few vertices, so that seams, pinched vertices and
/// pieces tied by them are the rule.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>
#include <quadmatch/shapes/random.hpp>

namespace quadmatch::test {

/// 1 to `most_faces` faces of three to five corners over 3 to `most_vertices` vertices. Half of the soups repeat a
/// pattern of faces on other vertices, which makes them symmetric.
inline PolygonSoup random_soup(std::uint64_t seed, std::uint32_t most_vertices, std::uint32_t most_faces) {
  shapes::Random random(seed);
  PolygonSoup soup;
  soup.vertex_count = 3 + random.below(most_vertices - 2);
  const std::uint32_t faces = 1 + random.below(most_faces);
  const bool repeats = random.below(2) == 0;
  const std::uint32_t step = 1 + random.below(soup.vertex_count);
  std::vector<std::uint32_t> corners;
  for (std::uint32_t f = 0; f < faces; ++f) {
    soup.face_starts.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    if (f == 0 || !repeats || random.below(8) == 0) {
      corners = random.permutation(soup.vertex_count);
      corners.resize(std::min<std::size_t>(corners.size(), 3 + random.below(3)));
      if (random.below(10) == 0) corners.back() = corners.front();  // an edge from a vertex to itself
    } else {
      for (std::uint32_t& v : corners) v = (v + step) % soup.vertex_count;
    }
    for (const std::uint32_t v : corners) soup.corners.push_back(VertexId(v));
  }
  soup.face_starts.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  return soup;
}

}  // namespace quadmatch::test
