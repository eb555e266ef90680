#include <quadmatch/analysis/spoke_colours.hpp>

#include <algorithm>

#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

struct Coloured {
  ArcGraph separatrices;
  SpokeColours colours;
};

Coloured colour(const Mesh& mesh, bool arc_lengths, std::uint32_t rounds = 6) {
  const PerFan<VertexCode> codes = vertex_codes(mesh);
  Coloured result{trace_separatrices(mesh, codes), {}};
  result.colours = colour_spokes(result.separatrices, codes, rounds, {.arc_lengths = arc_lengths});
  return result;
}

std::vector<Colour> sorted(std::vector<Colour> colours) {
  std::sort(colours.begin(), colours.end());
  return colours;
}

TEST_CASE("spoke colours are the same for a renumbered copy, round by round") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Coloured one = colour(test::build(soup), true);
    const Coloured other = colour(test::build(shapes::renumbered(soup, 13).soup), true);
    REQUIRE(one.colours.rounds.size() == 7);
    for (std::size_t round = 0; round < one.colours.rounds.size(); ++round) {
      CHECK(sorted(one.colours.rounds[round]) == sorted(other.colours.rounds[round]));
    }
  }
}

TEST_CASE("a round tells apart what earlier rounds did, and never forgets it") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const SpokeColours colours = colour(test::build(soup), true).colours;
    for (std::size_t round = 1; round < colours.rounds.size(); ++round) {
      for (std::size_t a = 0; a < colours.rounds[round].size(); ++a) {
        for (std::size_t b = a + 1; b < colours.rounds[round].size(); ++b) {
          if (colours.rounds[round][a] != colours.rounds[round][b]) continue;
          CHECK(colours.rounds[round - 1][a] == colours.rounds[round - 1][b]);
        }
      }
    }
  }
}

TEST_CASE("colours without arc lengths do not notice an inserted edge loop, those with them do") {
  const PolygonSoup soup = shapes::cube_subdivided(4);
  const Expected<shapes::Edit> edit = shapes::insert_edge_loop(soup, HalfedgeId(1));
  REQUIRE(edit.has_value());
  const Mesh plain = test::build(soup), looped = test::build(edit->soup);
  CHECK(sorted(colour(plain, false).colours.rounds.back()) == sorted(colour(looped, false).colours.rounds.back()));
  CHECK(sorted(colour(plain, true).colours.rounds.back()) != sorted(colour(looped, true).colours.rounds.back()));
}

TEST_CASE("a mirror image has other colours, unless it is the same mesh") {
  const Expected<shapes::Edit> lifted = shapes::extrude_patch(shapes::star(5, 5), FaceId(7), 3, 0.5);
  REQUIRE(lifted.has_value());
  const Mesh mesh = test::build(lifted->soup);
  CHECK(sorted(colour(mesh, true).colours.rounds.back()) !=
        sorted(colour(mesh.mirrored(), true).colours.rounds.back()));
  const Mesh cube = test::build(shapes::cube_subdivided(3));
  CHECK(sorted(colour(cube, true).colours.rounds.back()) ==
        sorted(colour(cube.mirrored(), true).colours.rounds.back()));
}

TEST_CASE("the separatrix graph alone is that of the whole tracing") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const PerFan<VertexCode> codes = vertex_codes(mesh);
    const ArcGraph alone = trace_separatrices(mesh, codes);
    const ArcGraph both = trace_skeleton(mesh, codes).separatrices;
    CHECK(alone.nodes == both.nodes);
    CHECK(alone.first_spoke == both.first_spoke);
    REQUIRE(alone.spokes.size() == both.spokes.size());
    for (std::size_t spoke = 0; spoke < alone.spokes.size(); ++spoke) {
      CHECK(alone.spokes[spoke].start == both.spokes[spoke].start);
      CHECK(alone.spokes[spoke].to_spoke == both.spokes[spoke].to_spoke);
      CHECK(alone.spokes[spoke].length == both.spokes[spoke].length);
    }
  }
}

}  // namespace
}  // namespace quadmatch
