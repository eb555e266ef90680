#include <quadmatch/match/matcher.hpp>

#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/verify/verify.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

/// The paper's, of one region.
constexpr Algorithm kAlgorithms[] = {Algorithm::Greedy, Algorithm::LazyGreedy};
constexpr OrientationChoice kOrientations[] = {OrientationChoice::Preserving, OrientationChoice::Reversing,
                                               OrientationChoice::Auto};

/// Match, and let the judge see it.
MatchResult judged(const Mesh& source, const Mesh& target, const MatchOptions& options) {
  MatchResult result = match(source, target, options);
  const Verdict verdict = verify(source, target, result.match);
  CHECK_MESSAGE(verdict.sound(), (verdict.faults.empty() ? std::string() : verdict.faults.front().message));
  return result;
}

TEST_CASE("every match of two meshes of the zoo is sound, by either algorithm, either way round") {
  const std::vector<test::NamedSoup> zoo = test::whole_zoo();
  for (const auto& [name, soup] : zoo) {
    for (const auto& [other_name, other_soup] : zoo) {
      for (const Algorithm algorithm : kAlgorithms) {
        for (const OrientationChoice orientation : kOrientations) {
          CAPTURE(name);
          CAPTURE(other_name);
          judged(test::build(soup), test::build(other_soup), {.algorithm = algorithm, .orientation = orientation});
        }
      }
    }
  }
}

TEST_CASE("faces that visit a vertex twice are matched only if both do so at the same corners") {
  const auto one_face = [](std::vector<VertexId> corners) {
    const auto count = static_cast<std::uint32_t>(corners.size());
    return test::build({.vertex_count = 3, .corners = std::move(corners), .face_starts = {0, count}});
  };
  const VertexId a(0), b(1), c(2);
  const Mesh flat = one_face({a, a, a}), folded = one_face({a, a, b}), whole = one_face({a, b, c});
  for (const Algorithm algorithm : kAlgorithms) {
    CHECK(judged(flat, folded, {.algorithm = algorithm}).match.matched_faces() == 0);
    CHECK(judged(whole, folded, {.algorithm = algorithm}).match.matched_faces() == 0);
    CHECK(judged(folded, folded, {.algorithm = algorithm}).match.matched_faces() == 1);
  }
}

TEST_CASE("a connected mesh of the zoo is matched whole with itself") {
  for (const auto& [name, soup] : test::well_formed_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    for (const Algorithm algorithm : kAlgorithms) {
      const MatchResult result = judged(mesh, mesh, {.algorithm = algorithm});
      CHECK(result.match.matched_faces() == mesh.face_count());
      CHECK(result.match.vertices.size() == mesh.vertex_count());
    }
  }
}

TEST_CASE("a renumbered copy is matched whole, and where an anchor is unique by the true map") {
  // A patch lifted off centre leaves nothing symmetric.
  const PolygonSoup plain = shapes::star(5, 5);
  const Expected<shapes::Edit> lifted = shapes::extrude_patch(plain, FaceId(7), 3, 0.5);
  REQUIRE(lifted.has_value());
  const PolygonSoup& soup = lifted->soup;
  const Mesh source = test::build(soup);
  for (std::uint64_t seed = 1; seed <= 25; ++seed) {
    CAPTURE(seed);
    const shapes::Renumbered copy = shapes::renumbered(soup, seed);
    const Mesh target = test::build(copy.soup);
    for (const Algorithm algorithm : kAlgorithms) {
      const MatchResult result = judged(source, target, {.algorithm = algorithm});
      CHECK(result.search.source_rarity == 1);
      REQUIRE(result.match.matched_faces() == source.face_count());
      std::vector<FacePair> pairs = result.match.regions.front().faces;
      std::sort(pairs.begin(), pairs.end(), [](const FacePair& a, const FacePair& b) { return a.source < b.source; });
      CHECK(pairs == copy.faces);
      for (const VertexPair& pair : result.match.vertices) CHECK(copy.vertices[pair.source] == pair.target);
    }
  }
}

TEST_CASE("the same input gives the same match, pair by pair in the same order") {
  const Mesh source = test::build(shapes::sphere(6));
  const Mesh target = test::build(shapes::renumbered(shapes::sphere(6), 4).soup);
  for (const Algorithm algorithm : kAlgorithms) {
    const MatchOptions options{.algorithm = algorithm, .waves = true};
    const Match one = match(source, target, options).match;
    const Match two = match(source, target, options).match;
    CHECK(one.regions.front().faces == two.regions.front().faces);
    CHECK(one.regions.front().waves == two.regions.front().waves);
    CHECK(one.vertices == two.vertices);
  }
}

TEST_CASE("from a given seed, growth does not depend on the numbering") {
  const PolygonSoup soup = shapes::grid(9, 7);
  const Mesh source = test::build(soup);
  const Expected<shapes::Edit> edit = shapes::collapse_quad(soup, source.first(FaceId(30)));
  REQUIRE(edit.has_value());
  const Mesh target = test::build(edit->soup);
  const shapes::Renumbered copy = shapes::renumbered(edit->soup, 9);
  const Mesh shuffled = test::build(copy.soup);
  const auto renamed = [&](HalfedgeId h) {
    const FacePair& place = copy.faces[target.face(h).value];
    return HalfedgeId(shuffled.first(place.target).value +
                      (target.corner(h) + place.rotation) % target.size(place.source));
  };
  for (const Algorithm algorithm : kAlgorithms) {
    const Anchor anchor{source.first(FaceId(0)), target.first(FaceId(0))};
    const MatchResult plain = judged(source, target, {.algorithm = algorithm, .anchors = {anchor}});
    const MatchResult other =
        judged(source, shuffled, {.algorithm = algorithm, .anchors = {{anchor.source, renamed(anchor.target)}}});
    REQUIRE(plain.match.matched_faces() == other.match.matched_faces());
    for (std::size_t k = 0; k < plain.match.regions.front().faces.size(); ++k) {
      const FacePair& left = plain.match.regions.front().faces[k];
      const FacePair& right = other.match.regions.front().faces[k];
      CHECK(left.source == right.source);
      CHECK(copy.faces[left.target.value].target == right.target);
    }
  }
}

TEST_CASE("a mirror image is matched whole when asked for reversing, or when preserving leaves most unmatched") {
  const PolygonSoup plain = shapes::star(5, 5);
  const Expected<shapes::Edit> lifted = shapes::extrude_patch(plain, FaceId(7), 3, 0.5);
  REQUIRE(lifted.has_value());
  const Mesh source = test::build(lifted->soup);
  const Mesh mirror = source.mirrored();
  const MatchResult reversing = judged(source, mirror, {.orientation = OrientationChoice::Reversing});
  REQUIRE(reversing.match.matched_faces() == source.face_count());
  CHECK(reversing.match.regions.front().orientation == Orientation::Reversing);
  for (const FacePair& pair : reversing.match.regions.front().faces) {
    CHECK(pair.source == pair.target);
    CHECK(pair.rotation == source.size(pair.source) - 1);  // corner i lies on corner n - 1 - i
  }
  // A Klein bottle's quads cannot be told from their mirror images, so there `auto` has nothing to turn over.
  const Mesh bottle = test::build(shapes::klein_bottle(4, 5));
  CHECK(judged(bottle, bottle, {}).match.regions.front().orientation == Orientation::Preserving);
}

TEST_CASE("a user's anchor is where growth starts, whatever the colours say") {
  const Mesh torus = test::build(shapes::torus(6, 5));
  const UserAnchor anchor{torus.first(FaceId(3)), HalfedgeId(torus.first(FaceId(11)).value + 2)};
  for (const Algorithm algorithm : {Algorithm::Greedy, Algorithm::LazyGreedy, Algorithm::Regions}) {
    const MatchResult result = judged(torus, torus, {.algorithm = algorithm, .anchors = {anchor}});
    CHECK(result.seed == anchor);
    CHECK(result.match.matched_faces() == torus.face_count());
    CHECK(result.match.regions.front().faces.front() == FacePair{FaceId(3), FaceId(11), 2});
  }
}

TEST_CASE("a user's anchor names corners, in a reversing match too") {
  const Mesh mesh = test::build(shapes::grid(4, 3));
  const UserAnchor anchor{mesh.first(FaceId(0)), HalfedgeId(mesh.first(FaceId(3)).value + 1)};
  const MatchResult result = judged(mesh, mesh, {.orientation = OrientationChoice::Reversing, .anchors = {anchor}});
  CHECK(result.match.matched_faces() == mesh.face_count());
  CHECK(result.match.regions.front().faces.front() == FacePair{FaceId(0), FaceId(3), 1});
  CHECK(result.seed == anchor);
}

TEST_CASE("an anchor that names no corner, or faces that cannot lie on each other, is refused by name") {
  const Mesh prism = test::build(shapes::prism(5));
  const auto message = [&](UserAnchor anchor) {
    const Expected<void> fine = check_anchor(prism, prism, anchor);
    return fine ? std::string() : fine.error().message;
  };
  HalfedgeId pentagon, quad;
  for (std::uint32_t f = 0; f < prism.face_count(); ++f) {
    (prism.size(FaceId(f)) == 5 ? pentagon : quad) = prism.first(FaceId(f));
  }
  CHECK(message({quad, quad}).empty());
  CHECK(message({HalfedgeId(1000), quad}) == "the anchor names no face corner of the source");
  CHECK(message({quad, HalfedgeId(1000)}) == "the anchor names no face corner of the target");
  CHECK(message({quad, pentagon}).find("of 4 corners on face") != std::string::npos);
}

TEST_CASE("evidence: extraordinary vertices that are touched, and those of them that agree") {
  const Mesh cube = test::build(shapes::cube_subdivided(3));
  const Evidence same = judged(cube, cube, {}).match.regions.front().evidence;
  CHECK(same == Evidence{8, 8, 8});
  // Laid askew on a grid, the corner of a cube agrees with nothing.
  const Mesh grid = test::build(shapes::grid(3, 3));
  const Evidence askew =
      judged(cube, grid,
             {.algorithm = Algorithm::LazyGreedy, .anchors = {{cube.first(FaceId(0)), grid.first(FaceId(4))}}})
          .match.regions.front()
          .evidence;
  CHECK(askew.agreeing == 0);
  CHECK(askew.source_extraordinary > 0);
}

TEST_CASE("nothing can be matched where no two faces have equally many corners") {
  const Mesh triangle = test::mesh_of(3, {{0, 1, 2}});
  const Mesh quad = test::mesh_of(4, {{0, 1, 2, 3}});
  const MatchResult result = judged(triangle, quad, {});
  CHECK(result.match.regions.empty());
  CHECK(result.match.complete);
}

TEST_CASE("progress is told, and saying stop leaves a sound part of the match") {
  const Mesh grid = test::build(shapes::grid(600, 400));
  for (const Algorithm algorithm : kAlgorithms) {
    std::vector<std::size_t> told;
    MatchOptions options{.algorithm = algorithm, .progress = [&](std::size_t matched, std::size_t most) {
                           told.push_back(matched);
                           CHECK(most == 240000);
                           return true;
                         }};
    CHECK(match(grid, grid, options).match.complete);
    CHECK(told.size() >= 2);
    CHECK(std::is_sorted(told.begin(), told.end()));
    options.progress = [](std::size_t, std::size_t) { return false; };
    const MatchResult stopped = judged(grid, grid, options);
    CHECK_FALSE(stopped.match.complete);
    CHECK(stopped.match.matched_faces() > 0);
    CHECK(stopped.match.matched_faces() < 240000);
  }
}

}  // namespace
}  // namespace quadmatch
