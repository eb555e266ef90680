// Algorithm::Regions: what it promises beyond the paper's algorithms.

#include <algorithm>
#include <cmath>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/verify/verify.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

Match judged(const Mesh& source, const Mesh& target, const MatchOptions& options = {}) {
  Match match = quadmatch::match(source, target, options).match;
  const Verdict verdict = verify(source, target, match);
  CHECK_MESSAGE(verdict.sound(), (verdict.faults.empty() ? std::string() : verdict.faults.front().message));
  return match;
}

/// All pairs, ascending by source.
std::vector<FacePair> pairs_of(const Match& match) {
  std::vector<FacePair> pairs;
  for (const Region& region : match.regions) pairs.insert(pairs.end(), region.faces.begin(), region.faces.end());
  std::sort(pairs.begin(), pairs.end(), [](const FacePair& a, const FacePair& b) { return a.source < b.source; });
  return pairs;
}

/// The share of the truth that was found.
double recall(const Match& match, const std::vector<FacePair>& truth) {
  const std::vector<FacePair> pairs = pairs_of(match);
  const auto found = std::count_if(truth.begin(), truth.end(), [&](const FacePair& pair) {
    return std::find(pairs.begin(), pairs.end(), pair) != pairs.end();
  });
  return static_cast<double>(found) / static_cast<double>(truth.size());
}

std::uint32_t ambiguous_faces(const Match& match) {
  std::uint32_t faces = 0;
  for (const Region& region : match.regions) {
    faces += region.ambiguous ? static_cast<std::uint32_t>(region.faces.size()) : 0;
  }
  return faces;
}

/// The same connectivity, and no place for any vertex.
PolygonSoup without_positions(PolygonSoup soup) {
  soup.positions.clear();
  return soup;
}

shapes::Edit take(Expected<shapes::Edit> edit) {
  REQUIRE(edit.has_value());
  return *std::move(edit);
}

TEST_CASE("regions: every match of two meshes of the zoo is sound, whichever stage is left out") {
  const std::vector<test::NamedSoup> zoo = test::whole_zoo();
  const std::vector<Stages> choices{{},
                                    {.equal_parts = false},
                                    {.seams = false},
                                    {.ties = false, .slides = false},
                                    {.turns = false, .rows = false},
                                    {.slivers = false, .islands = false},
                                    {.ventures = false},
                                    {.equal_parts = false, .restarts = false, .acceptance = false, .doubts = false}};
  for (const auto& [name, soup] : zoo) {
    for (const auto& [other_name, other_soup] : zoo) {
      const Mesh source = test::build(soup), target = test::build(other_soup);
      for (const Stages& stages : choices) {
        CAPTURE(name);
        CAPTURE(other_name);
        judged(source, target, {.stages = stages});
      }
      judged(source, target, {.orientation = OrientationChoice::Reversing});
      judged(source, target, {.positions = false});
    }
  }
}

TEST_CASE("regions: a mesh of the zoo is matched whole with a renumbered copy of itself, positions or not") {
  for (const auto& [name, soup] : test::well_formed_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const shapes::Renumbered copy = shapes::renumbered(soup, 7);
    const Match match = judged(mesh, test::build(copy.soup));
    CHECK(match.matched_faces() == mesh.face_count());
    CHECK(match.vertices.size() == mesh.vertex_count());
    CHECK(pairs_of(match) == copy.faces);  // positions settle what connectivity cannot
    CHECK(judged(mesh, test::build(copy.soup), {.positions = false}).matched_faces() == mesh.face_count());
  }
}

TEST_CASE("regions: a Moebius strip and a Klein bottle match themselves whole") {
  for (const PolygonSoup& soup : {shapes::mobius_strip(5), shapes::klein_bottle(4, 5)}) {
    const Mesh mesh = test::build(soup);
    CHECK(judged(mesh, mesh).matched_faces() == mesh.face_count());
    CHECK(judged(mesh, mesh, {.positions = false}).matched_faces() == mesh.face_count());
  }
}

TEST_CASE("regions: an inserted edge loop costs only the quads it splits") {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh source = test::build(bear);
  for (const std::uint32_t crossed : {std::uint32_t{401}, std::uint32_t{2222}, std::uint32_t{7003}}) {
    CAPTURE(crossed);
    const Expected<shapes::Edit> edit = shapes::insert_edge_loop(bear, HalfedgeId(crossed));
    if (!edit) continue;  // the chord crosses itself
    const Mesh target = test::build(edit->soup);
    CHECK(recall(judged(source, target), edit->truth) == 1.0);
  }
}

TEST_CASE("regions: deleted, extruded and collapsed quads cost nothing but themselves") {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh source = test::build(bear);
  const std::vector<shapes::Edit> edits{take(shapes::delete_patch(bear, FaceId(40), 60)),
                                        take(shapes::extrude_patch(bear, FaceId(700), 25, 0.1)),
                                        take(shapes::collapse_quad(bear, source.first(FaceId(1200))))};
  for (const shapes::Edit& edit : edits) {
    const shapes::Renumbered copy = shapes::renumbered(edit.soup, 3);
    const std::vector<FacePair> truth = shapes::chained(edit.truth, copy.faces, copy.soup);
    CHECK(recall(judged(source, test::build(copy.soup)), truth) == 1.0);
    const Match blind = judged(source, test::build(without_positions(copy.soup)));
    CHECK(recall(blind, truth) >= 0.99);  // the lifted patch may lie one quad off
  }
}

TEST_CASE("regions: the bear without ears in another pose is the bear but for its ears") {
  const Mesh source = test::build(shapes::bear().soup);
  const shapes::BearOptions posed{.ears = false, .pose = {.left_arm = 0.2, .right_leg = 0.15, .head_turn = 0.1}};
  const Mesh target = test::build(shapes::bear(posed).soup);
  std::vector<FacePair> truth;
  for (std::uint32_t f = 0; f < shapes::bear_common_faces(); ++f) truth.push_back({FaceId(f), FaceId(f), 0});
  const Match match = judged(source, target);
  CHECK(recall(match, truth) >= 0.98);  // beside the ears the refined surface itself is another
  CHECK(match.matched_faces() <= shapes::bear_common_faces() + 32);
}

TEST_CASE("regions: a pose tears nothing apart where connectivity is the same all over") {
  // Reaching bends and stretches a shoulder so that edges there fit better one quad on.
  const Mesh source = test::build(shapes::bear().soup);
  const shapes::BearPose reaching{.left_arm = 0.05,
                                  .right_arm = 0.22,
                                  .left_leg = -0.05,
                                  .right_leg = 0.09,
                                  .head_turn = -0.06,
                                  .head_tilt = 0.03,
                                  .body_bend = 0.03};
  const Mesh target = test::build(shapes::bear({.pose = reaching}).soup);
  const Match match = judged(source, target);
  REQUIRE(match.regions.size() == 1);
  CHECK(match.matched_faces() == source.face_count());
  for (const FacePair& pair : match.regions.front().faces) CHECK(pair == FacePair{pair.source, pair.source, 0});
}

/// Pairs that contradict the truth, in regions that are ambiguous or in those that are not.
std::size_t wrong_pairs(const Match& match, const std::vector<FacePair>& truth, bool ambiguous) {
  std::size_t wrong = 0;
  for (const Region& region : match.regions) {
    if (region.ambiguous != ambiguous) continue;
    for (const FacePair& pair : region.faces) {
      const auto place = std::lower_bound(truth.begin(), truth.end(), pair.source,
                                          [](const FacePair& a, FaceId source) { return a.source < source; });
      wrong += place != truth.end() && place->source == pair.source && !(*place == pair);
    }
  }
  return wrong;
}

TEST_CASE("regions: where a row of quads came or went, what may lie wrong is said to be ambiguous") {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh source = test::build(bear);
  std::size_t wrong = 0, wrong_and_sure = 0;
  for (const std::uint32_t crossed : {1500U, 2222U, 5001U, 7003U, 9000U}) {
    for (const auto& edit :
         {shapes::insert_edge_loop(bear, HalfedgeId(crossed)), shapes::remove_edge_loop(bear, HalfedgeId(crossed))}) {
      CAPTURE(crossed);
      if (!edit) continue;  // the chord crosses itself
      const Mesh target = test::build(edit->soup);
      const Match match = judged(source, target, {.positions = false});
      CHECK(ambiguous_faces(match) > 0);
      CHECK(4 * ambiguous_faces(match) < 3 * source.face_count());
      wrong += wrong_pairs(match, edit->truth, true);
      wrong_and_sure += wrong_pairs(match, edit->truth, false);
      CHECK(ambiguous_faces(judged(source, target, {.positions = false, .stages = {.doubts = false}})) == 0);
      CHECK(10 * ambiguous_faces(judged(source, target)) < source.face_count());  // lengths know
    }
  }
  CHECK(wrong > 0);
  CHECK(10 * wrong_and_sure <= wrong);
}

TEST_CASE("regions: of several equal parts positions say which is which, and without them the match says it cannot") {
  const PolygonSoup row = shapes::many_components(5);
  const shapes::Renumbered copy = shapes::renumbered(row, 11);
  const Mesh source = test::build(row);
  const Match placed = judged(source, test::build(copy.soup));
  CHECK(pairs_of(placed) == copy.faces);
  CHECK(ambiguous_faces(placed) == 0);
  const Match blind = judged(source, test::build(copy.soup), {.positions = false});
  CHECK(blind.matched_faces() == source.face_count());
  CHECK(ambiguous_faces(blind) == source.face_count());
  for (const Region& region : blind.regions) CHECK(region.ways == 5 * 24);  // five cubes, and 24 turns of each
}

TEST_CASE("regions: a symmetric mesh is matched by one map, with the number of all maps") {
  const Mesh cube = test::build(without_positions(shapes::cube_subdivided(3)));
  const Match match = judged(cube, cube, {.orientation = OrientationChoice::Preserving});
  REQUIRE(match.regions.size() == 1);
  CHECK(match.regions.front().faces.size() == 54);
  CHECK(match.regions.front().ways == 24);
  CHECK(match.regions.front().ambiguous);
  const Mesh bear = test::build(without_positions(shapes::bear().soup));
  CHECK(judged(bear, bear).regions.front().ways == 1);
}

TEST_CASE("regions: ten thousand equal parts are matched, and said to be ambiguous") {
  const Mesh cubes = test::build(without_positions(shapes::many_components(10000)));
  const Match match = judged(cubes, cubes);
  CHECK(match.matched_faces() == 60000);
  CHECK(ambiguous_faces(match) == 60000);
}

TEST_CASE("regions: models that have nothing in common do not match") {
  const Mesh bear = test::build(shapes::bear().soup);
  const Mesh shirt = test::build(shapes::shirt(shapes::Sleeves::Long).soup);
  for (const bool positions : {true, false}) {
    CHECK(judged(bear, shirt, {.positions = positions}).matched_faces() <= 9);  // half a percent
    CHECK(judged(shirt, bear, {.positions = positions}).matched_faces() <= 9);
  }
}

TEST_CASE("regions: the shirt with short sleeves is found in the one with long sleeves") {
  const Mesh source = test::build(shapes::shirt(shapes::Sleeves::Short).soup);
  const shapes::Renumbered copy = shapes::renumbered(shapes::shirt(shapes::Sleeves::Long).soup, 5);
  const std::vector<FacePair> truth(copy.faces.begin(), copy.faces.begin() + source.face_count());
  CHECK(recall(judged(source, test::build(copy.soup)), truth) == 1.0);
}

TEST_CASE("regions: neither renumbering nor exchanging the meshes changes what is matched") {
  const PolygonSoup bear = shapes::bear().soup;
  const shapes::Edit edit = take(shapes::delete_patch(bear, FaceId(900), 40));
  const Mesh source = test::build(bear), target = test::build(edit.soup);
  const MatchOptions options{.positions = false};
  const std::vector<FacePair> pairs = pairs_of(judged(source, target, options));
  const shapes::Renumbered copy = shapes::renumbered(edit.soup, 21);
  CHECK(pairs_of(judged(source, test::build(copy.soup), options)) == shapes::chained(pairs, copy.faces, copy.soup));
  std::vector<FacePair> back;
  for (const FacePair& pair : pairs_of(judged(target, source, options))) {
    back.push_back({pair.target, pair.source, (4 - pair.rotation) % 4});
  }
  std::sort(back.begin(), back.end(), [](const FacePair& a, const FacePair& b) { return a.source < b.source; });
  CHECK(back == pairs);
}

TEST_CASE("regions: with positions switched off they are never looked at") {
  const PolygonSoup bear = shapes::bear().soup;
  const shapes::Edit edit = take(shapes::insert_edge_loop(bear, HalfedgeId(401)));
  PolygonSoup scrambled = edit.soup;
  for (std::size_t v = 0; v < scrambled.positions.size(); ++v) {
    scrambled.positions[v] = {static_cast<double>(v * 7919 % 101), static_cast<double>(v * 104729 % 97), 0.0};
  }
  const Mesh source = test::build(bear);
  const MatchOptions options{.positions = false};
  const Match plain = judged(source, test::build(edit.soup), options);
  const Match other = judged(source, test::build(scrambled), options);
  REQUIRE(plain.regions.size() == other.regions.size());
  for (std::size_t k = 0; k < plain.regions.size(); ++k) CHECK(plain.regions[k].faces == other.regions[k].faces);
}

TEST_CASE("regions: with positions off, bent, turned and scrambled copies of an edit are matched alike") {
  // A bear with a dozen edits, so that much is left to the stages that mend.
  const PolygonSoup bear = shapes::bear().soup;
  shapes::Edit edit = take(shapes::insert_edge_loop(bear, HalfedgeId(401)));
  for (std::uint32_t k = 1; k <= 12; ++k) {
    const FaceId centre(k * 7919 % static_cast<std::uint32_t>(edit.soup.corners.size() / 4));
    auto next =
        k % 2 == 0 ? shapes::delete_patch(edit.soup, centre, 4) : shapes::extrude_patch(edit.soup, centre, 4, 1.0);
    if (next.has_value()) edit = *std::move(next);
  }
  using Move = Point (*)(const Point&);
  const Move bent = [](const Point& p) { return Point{p[0] + 0.1 * p[1] * p[1], p[1], p[2] - 0.2 * p[0] * p[0]}; };
  const Move turned = [](const Point& p) { return Point{p[2] + 3, p[0], 2 * p[1]}; };
  const Move scrambled = [](const Point& p) { return Point{std::sin(91 * p[0]), std::sin(97 * p[1]), std::cos(p[2])}; };
  const Mesh source = test::build(bear);
  const MatchOptions options{.positions = false};
  const Match plain = judged(source, test::build(edit.soup), options);
  CHECK(2 * plain.matched_faces() > source.face_count());
  for (const Move move : {bent, turned, scrambled}) {
    PolygonSoup moved = edit.soup;
    for (Point& p : moved.positions) p = move(p);
    const Match other = judged(source, test::build(moved), options);
    REQUIRE(plain.regions.size() == other.regions.size());
    for (std::size_t k = 0; k < plain.regions.size(); ++k) CHECK(plain.regions[k].faces == other.regions[k].faces);
  }
}

TEST_CASE("regions: a mirror image is matched the way its shape says, even where either way would do") {
  // The plate is its own mirror image, but not with these sides.
  PolygonSoup plate = shapes::grid(4, 4);
  for (Point& p : plate.positions) p = {p[0] * (1 + 0.2 * p[0]), p[1] * (1 + 0.35 * p[1]) + 0.3 * p[0], 0.0};
  const Mesh source = test::build(plate);
  PolygonSoup turned = plate;
  for (std::size_t corner = 0; corner < turned.corners.size(); corner += 4) {
    std::swap(turned.corners[corner + 1], turned.corners[corner + 3]);
  }
  const Match match = judged(source, test::build(turned));
  REQUIRE(match.regions.size() == 1);
  CHECK(match.regions.front().orientation == Orientation::Reversing);
  for (const FacePair& pair : match.regions.front().faces) CHECK(pair.source == pair.target);
}

/// Twisted about its upright axis, by a radian from bottom to top.
PolygonSoup twisted(PolygonSoup soup) {
  double low = soup.positions.front()[1], high = low;
  for (const Point& p : soup.positions) {
    low = std::min(low, p[1]);
    high = std::max(high, p[1]);
  }
  for (Point& p : soup.positions) {
    const double angle = (p[1] - low) / (high - low);
    p = {std::cos(angle) * p[0] - std::sin(angle) * p[2], p[1], std::sin(angle) * p[0] + std::cos(angle) * p[2]};
  }
  return soup;
}

/// Swollen here and shrunk there, by a fifth.
PolygonSoup sculpted(PolygonSoup soup) {
  for (Point& p : soup.positions) {
    const double swell = 1 + 0.2 * std::sin(3 * p[0] + 1) * std::sin(2 * p[1] + 2) * std::cos(3 * p[2]);
    for (double& x : p) x *= swell;
  }
  return soup;
}

TEST_CASE(
    "regions: edge loops inserted into a model that is posed or sculpted cost hardly more than the quads they split") {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh source = test::build(bear);
  for (const std::uint32_t crossed : {std::uint32_t{401}, std::uint32_t{2222}, std::uint32_t{7003}}) {
    CAPTURE(crossed);
    const Expected<shapes::Edit> edit = shapes::insert_edge_loop(bear, HalfedgeId(crossed));
    if (!edit) continue;  // the chord crosses itself
    CHECK(recall(judged(source, test::build(twisted(edit->soup))), edit->truth) >= 0.99);
    CHECK(recall(judged(source, test::build(sculpted(edit->soup))), edit->truth) >= 0.99);
  }
}

TEST_CASE("regions: what hangs on a ring that was turned by a quad is found where it lies, posed or not") {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh source = test::build(bear);
  int rings = 0;
  for (std::uint32_t crossed = 5; crossed < bear.corners.size() && rings < 6; crossed += 977) {
    const auto edit = shapes::twist_ring(bear, HalfedgeId(crossed), 1);
    if (!edit) continue;  // no ring
    ++rings;
    CAPTURE(crossed);
    for (const PolygonSoup& target : {edit->soup, twisted(edit->soup), sculpted(edit->soup)}) {
      CHECK(recall(judged(source, test::build(target)), edit->truth) >= 0.98);
    }
  }
  CHECK(rings == 6);
}

TEST_CASE("regions: a removed row of quads is left out from end to end, beside extraordinary vertices too") {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh source = test::build(bear);
  int rows = 0;
  for (std::uint32_t crossed = 3; crossed < bear.corners.size() && rows < 8; crossed += 1201) {
    const auto edit = shapes::remove_edge_loop(bear, HalfedgeId(crossed));
    if (!edit) continue;
    ++rows;
    CAPTURE(crossed);
    const Match match = judged(source, test::build(edit->soup));
    std::vector<FacePair> pairs = pairs_of(match);
    CHECK(pairs.size() == edit->truth.size());
    // Face by face the row that is free is entered from the one before it: every face has two that are free beside it.
    std::vector<bool> free(source.face_count(), true);
    for (const FacePair& pair : pairs) free[pair.source.value] = false;
    for (std::uint32_t f = 0; f < source.face_count(); ++f) {
      if (!free[f]) continue;
      const HalfedgeId first = source.first(FaceId(f));
      const auto goes_on = [&](std::uint32_t k) {
        const HalfedgeId beyond = source.twin(HalfedgeId(first.value + k));
        return !beyond.valid() || free[source.face(beyond).value];
      };
      CHECK(((goes_on(0) && goes_on(2)) || (goes_on(1) && goes_on(3))));
    }
  }
  CHECK(rows == 8);
}

TEST_CASE("regions: a piece cut out of a regular sheet is found by its lengths, posed or not") {
  constexpr std::uint32_t kSheet = 24, kPiece = 14, kFrom = 6;
  const auto place = [](std::uint32_t i, std::uint32_t j, double bent) {
    const double x = i + 0.7 * std::sin(1.3 * i) * std::cos(0.4 * j), y = j + 0.7 * std::sin(0.9 * j + 0.5 * i);
    return bent > 0 ? Point{std::sin(bent * x) / bent, y, (1 - std::cos(bent * x)) / bent} : Point{x, y, 0};
  };
  PolygonSoup sheet = shapes::grid(kSheet, kSheet), piece = shapes::grid(kPiece, kPiece);
  for (std::uint32_t v = 0; v < sheet.positions.size(); ++v) {
    sheet.positions[v] = place(v % (kSheet + 1), v / (kSheet + 1), 0.05);
  }
  for (std::uint32_t v = 0; v < piece.positions.size(); ++v) {
    piece.positions[v] = place(v % (kPiece + 1) + kFrom, v / (kPiece + 1) + kFrom, 0);
  }
  // Lengths are learnt from a bear, which is posed as well: neither lies as it did.
  const PolygonSoup bear = shapes::bear().soup;
  const auto bears = static_cast<std::uint32_t>(test::build(bear).face_count());
  std::vector<FacePair> truth;
  for (std::uint32_t f = 0; f < kPiece * kPiece; ++f) {
    truth.push_back({FaceId(bears + f), FaceId(bears + (f / kPiece + kFrom) * kSheet + f % kPiece + kFrom), 0});
  }
  const Mesh source = test::build(shapes::disjoint_union({bear, piece}));
  const Mesh target = test::build(shapes::disjoint_union({twisted(bear), sheet}));
  CHECK(recall(judged(source, target), truth) == 1.0);
}

TEST_CASE("regions: what the user leaves out is left out") {
  const PolygonSoup pieces = shapes::disjoint_union({shapes::sphere(4), shapes::prism(3), shapes::grid(2, 2)});
  const Mesh mesh = test::build(pieces);
  CHECK(judged(mesh, mesh).regions.size() == 3);
  const Match large = judged(mesh, mesh, {.least_region = 6});
  REQUIRE(large.regions.size() == 1);
  CHECK(large.regions.front().faces.size() == 96);
  CHECK(large.vertices.size() == 98);
  for (const Region& region : judged(mesh, mesh, {.least_confidence = 1.0}).regions) {
    CHECK(region.evidence.confidence() == 1.0);
  }
}

TEST_CASE("regions: progress is told, and saying stop leaves a sound part of the match") {
  const PolygonSoup bear = shapes::bear().soup;
  const Mesh source = test::build(bear);
  const Mesh target = test::build(take(shapes::delete_patch(bear, FaceId(900), 40)).soup);
  std::size_t told = 0;
  MatchOptions options{.progress = [&](std::size_t matched, std::size_t most) {
    ++told;
    CHECK(matched <= most);
    CHECK(most == 2904);
    return true;
  }};
  CHECK(judged(source, target, options).complete);
  CHECK(told >= 2);
  options.progress = [](std::size_t, std::size_t) { return false; };
  CHECK_FALSE(judged(source, target, options).complete);
}

TEST_CASE("regions: waves say how far each region had grown, and end with all of it") {
  const Mesh bear = test::build(shapes::bear().soup);
  const Match match = judged(bear, bear, {.waves = true});
  for (const Region& region : match.regions) {
    REQUIRE_FALSE(region.waves.empty());
    CHECK(region.waves.front() == 1);
    CHECK(std::is_sorted(region.waves.begin(), region.waves.end()));
    CHECK(region.waves.back() == region.faces.size());
  }
}

}  // namespace
}  // namespace quadmatch
