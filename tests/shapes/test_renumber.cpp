#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include <quadmatch/shapes/random.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::Face;
using quadmatch::testing::faces_of;

TEST_CASE("A renumbered soup is the same soup: its faces, turned and renamed as the truth says") {
  for (const PolygonSoup& soup : {shapes::grid(5, 4), shapes::prism(6), shapes::torus(4, 5)}) {
    const shapes::Renumbered moved = shapes::renumbered(soup, 7);
    const std::vector<Face> before = faces_of(soup), after = faces_of(moved.soup);
    REQUIRE(after.size() == before.size());
    REQUIRE(moved.faces.size() == before.size());
    std::vector<bool> hit(after.size(), false);
    for (std::uint32_t f = 0; f < before.size(); ++f) {
      const FacePair& pair = moved.faces[f];
      CHECK(pair.source == FaceId(f));
      CHECK_FALSE(hit[pair.target.value]);
      hit[pair.target.value] = true;
      const auto size = static_cast<std::uint32_t>(before[f].size());
      REQUIRE(after[pair.target.value].size() == size);
      for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t corner = image_corner(Orientation::Preserving, pair.rotation, i, size);
        CHECK(after[pair.target.value][corner] == moved.vertices[VertexId(before[f][i])].value);
      }
    }
    for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
      CHECK(moved.soup.positions[moved.vertices[VertexId(v)].value] == soup.positions[v]);
    }
  }
}

TEST_CASE("Renumbering moves nearly everything, and differently with each seed") {
  const PolygonSoup soup = shapes::torus(20, 20);
  const shapes::Renumbered one = shapes::renumbered(soup, 1), two = shapes::renumbered(soup, 2);
  const auto stay = std::count_if(one.faces.begin(), one.faces.end(),
                                  [](const FacePair& pair) { return pair.source.value == pair.target.value; });
  CHECK(stay < 10);
  CHECK(one.soup.corners != two.soup.corners);
  CHECK(one.soup.corners == shapes::renumbered(soup, 1).soup.corners);
}

TEST_CASE("Renumbering a soup without positions leaves it without positions") {
  PolygonSoup soup = shapes::cube();
  soup.positions.clear();
  CHECK(shapes::renumbered(soup, 3).soup.positions.empty());
}

TEST_CASE("Random numbers are the same on every machine") {
  // The standard requires the 10,000th number of a default std::mt19937_64 to be 9981545732273789042.
  std::mt19937_64 engine;
  engine.discard(9999);
  CHECK(engine() == 9981545732273789042ULL);
  CHECK(shapes::Random(42).permutation(8) == std::vector<std::uint32_t>{7, 0, 5, 1, 2, 4, 3, 6});
}

TEST_CASE("Random numbers below a bound stay below it and reach all of them") {
  shapes::Random random(5);
  std::vector<int> seen(7, 0);
  for (int i = 0; i < 700; ++i) ++seen[random.below(7)];
  for (const int count : seen) CHECK(count > 50);
}
