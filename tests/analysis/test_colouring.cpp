#include <quadmatch/analysis/colouring.hpp>

#include <algorithm>
#include <map>
#include <set>

#include <quadmatch/shapes/catmull_clark.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

struct Coloured {
  Mesh mesh;
  PerFan<VertexCode> codes;
  ArcGraph skeleton;
  std::vector<Colour> colours;

  Coloured(PolygonSoup soup, unsigned rounds, ColouringOptions options = {})
      : mesh(test::build(std::move(soup))),
        codes(vertex_codes(mesh)),
        skeleton(trace_skeleton(mesh, codes).skeleton),
        colours(initial_colours(skeleton, codes)) {
    for (unsigned round = 0; round < rounds; ++round) {
      colours = refine_colours(skeleton, codes, colours, options);
    }
  }

  [[nodiscard]] std::multiset<Colour> histogram() const { return {colours.begin(), colours.end()}; }
  [[nodiscard]] std::size_t classes() const { return std::set<Colour>(colours.begin(), colours.end()).size(); }
};

/// A grid with a tube standing on it, far off the middle: no symmetry.
PolygonSoup lopsided() {
  PolygonSoup soup = shapes::grid(5, 4);
  // Replace quad (1, 1) by a pyramid-like cap: an inner vertex of valence 4 joined to four quads by a smaller square.
  const std::uint32_t a = soup.vertex_count;
  soup.vertex_count += 4;
  soup.positions.clear();
  const std::size_t place = 4 * (1 * 5 + 1);
  const std::vector<VertexId> outer(soup.corners.begin() + place, soup.corners.begin() + place + 4);
  for (std::uint32_t k = 0; k < 4; ++k) soup.corners[place + k] = VertexId(a + k);
  for (std::uint32_t k = 0; k < 4; ++k) {
    for (const VertexId v : {outer[k], outer[(k + 1) % 4], VertexId(a + (k + 1) % 4), VertexId(a + k)}) {
      soup.corners.push_back(v);
    }
  }
  return soup;
}

TEST_CASE("Algorithm 1: colours do not depend on the numbering") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    for (const bool lengths : {false, true}) {
      const ColouringOptions options{.arc_lengths = lengths};
      CHECK(Coloured(soup, 3, options).histogram() ==
            Coloured(shapes::renumbered(soup, 5).soup, 3, options).histogram());
    }
  }
}

TEST_CASE("Algorithm 1: a round only ever splits colours, never joins them") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    for (unsigned round = 0; round < 4; ++round) {
      const Coloured before(soup, round);
      const Coloured after(soup, round + 1);
      std::map<Colour, Colour> came_from;
      for (std::size_t node = 0; node < before.colours.size(); ++node) {
        const auto [place, fresh] = came_from.emplace(after.colours[node], before.colours[node]);
        CHECK(place->second == before.colours[node]);
      }
    }
  }
}

TEST_CASE("Algorithm 1: the eight corners of a cube keep one colour for ever") {
  for (unsigned round = 0; round < 5; ++round) CHECK(Coloured(shapes::cube_subdivided(3), round).classes() == 1);
}

TEST_CASE("§4.1, footnote 1: arc lengths tell apart what valences cannot") {
  const PolygonSoup oblong = shapes::grid(7, 5);
  CHECK(Coloured(oblong, 2).classes() == 1);
  CHECK(Coloured(oblong, 1, {.arc_lengths = true}).classes() == 2);  // long side first, or short side first
}

TEST_CASE("without arc lengths, colours are blind to refinement where only quads meet") {
  const PolygonSoup soup = lopsided();
  CHECK(Coloured(soup, 3).histogram() == Coloured(shapes::catmull_clark(soup), 3).histogram());
}

TEST_CASE("the colours of a mirror image differ as soon as the rotation system is seen") {
  const Mesh mesh = test::build(lopsided());
  const Mesh mirror = mesh.mirrored();
  const auto colours_of = [](const Mesh& m, unsigned rounds) {
    const PerFan<VertexCode> codes = vertex_codes(m);
    const ArcGraph skeleton = trace_skeleton(m, codes).skeleton;
    std::vector<Colour> colours = initial_colours(skeleton, codes);
    for (unsigned round = 0; round < rounds; ++round) {
      colours = refine_colours(skeleton, codes, colours, {.arc_lengths = true});
    }
    std::sort(colours.begin(), colours.end());
    return colours;
  };
  CHECK(colours_of(mesh, 0) == colours_of(mirror, 0));
  CHECK(colours_of(mesh, 4) != colours_of(mirror, 4));
}

TEST_CASE("the least rotation has as many beginnings as the neighbourhood has turns onto itself") {
  const Coloured star(shapes::star(6, 3), 0);
  std::uint32_t middle = 0;
  while (star.codes[star.skeleton.nodes[middle]].valence() != 6) ++middle;
  CHECK(least_rotations(star.skeleton, star.codes, star.colours, middle) ==
        std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5});
  // On the boundary the order is linear: there is nothing to turn.
  std::uint32_t corner = 0;
  while (star.codes[star.skeleton.nodes[corner]].valence() != 2) ++corner;
  CHECK(least_rotations(star.skeleton, star.codes, star.colours, corner) == std::vector<std::uint32_t>{0});
}

}  // namespace
}  // namespace quadmatch
