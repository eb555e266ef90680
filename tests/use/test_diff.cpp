#include <quadmatch/use/diff.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/random_edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>

#include "mesh/named_meshes.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

Difference compared(const Mesh& source, const Mesh& target, const Match& match, const DiffOptions& options = {}) {
  Expected<Difference> difference = diff(source, target, match, options);
  REQUIRE(difference.has_value());
  return *std::move(difference);
}

Difference compared(const PolygonSoup& source, const PolygonSoup& target, const DiffOptions& options = {}) {
  const Mesh a = build(source), b = build(target);
  return compared(a, b, match(a, b).match, options);
}

/// From target to source.
Match inverse_of(const Mesh& source, Match match) {
  for (Region& region : match.regions) {
    for (FacePair& pair : region.faces) {
      const std::uint32_t size = source.size(pair.source);
      if (region.orientation == Orientation::Preserving) pair.rotation = (size - pair.rotation) % size;
      std::swap(pair.source, pair.target);
    }
  }
  for (VertexPair& pair : match.vertices) std::swap(pair.source, pair.target);
  std::sort(match.vertices.begin(), match.vertices.end(),
            [](const VertexPair& a, const VertexPair& b) { return a.source < b.source; });
  return match;
}

std::vector<ChangeKind> kinds_of(const Difference& difference) {
  std::vector<ChangeKind> kinds;
  for (const Change& change : difference.changes) kinds.push_back(change.kind);
  return kinds;
}

/// A match that says: faces of the same number are the same, corner on corner, as are vertices.
Match same_numbers(std::uint32_t faces, std::uint32_t vertices) {
  Match match;
  Region region;
  for (std::uint32_t f = 0; f < faces; ++f) region.faces.push_back({FaceId(f), FaceId(f), 0});
  for (std::uint32_t v = 0; v < vertices; ++v) match.vertices.push_back({VertexId(v), VertexId(v)});
  match.regions.push_back(std::move(region));
  return match;
}

PolygonSoup edited(const PolygonSoup& soup, const std::string& text, std::uint64_t seed) {
  const auto edit = shapes::parse_random_edit(text);
  REQUIRE(edit);
  shapes::Random random(seed);
  Expected<shapes::Edit> result = shapes::edit_at_random(soup, *edit, random);
  REQUIRE(result.has_value());
  return shapes::renumbered(result->soup, seed + 100).soup;
}

const std::map<std::string, ChangeKind> kNames{
    {"delete:20", ChangeKind::Deletion},   {"extrude:12", ChangeKind::Extrusion},
    {"collapse:1", ChangeKind::Collapse},  {"rip:6", ChangeKind::Rip},
    {"refine:9", ChangeKind::Refinement},  {"loop:1", ChangeKind::InsertedLoop},
    {"unloop:1", ChangeKind::RemovedLoop}, {"twist:1", ChangeKind::Reattachment},
    {"handle:1", ChangeKind::Bridge}};

template <class Move>
PolygonSoup moved(PolygonSoup soup, Move&& move) {
  for (Point& p : soup.positions) p = move(p);
  return soup;
}

/// Two quads that meet in a vertex, or do not.
PolygonSoup two_quads(bool meet) {
  return meet ? soup_of(7, {{0, 1, 2, 3}, {2, 4, 5, 6}}) : soup_of(8, {{0, 1, 2, 3}, {7, 4, 5, 6}});
}

}  // namespace

TEST_CASE(
    "a single edit of a bear or a shirt is one change, named for what it is, and has the inverse name from the other "
    "end") {
  const PolygonSoup models[] = {shapes::bear().soup, shapes::shirt(shapes::Sleeves::Short).soup};
  for (const PolygonSoup& soup : models) {
    const Mesh source = build(soup);
    for (const auto& [edit, kind] : kNames) {
      for (const std::uint64_t seed : {1, 2}) {
        CAPTURE(source.face_count());
        CAPTURE(edit);
        CAPTURE(seed);
        const Mesh target = build(edited(soup, edit, seed));
        const Match found = match(source, target).match;
        const Difference difference = compared(source, target, found);
        CHECK(kinds_of(difference) == std::vector<ChangeKind>{kind});
        CHECK_FALSE(difference.none());
        const Difference back = compared(target, source, inverse_of(source, found));
        REQUIRE(back.changes.size() == 1);
        CHECK(back.changes[0].kind == inverse(kind));
        CHECK(back.changes[0].source_faces == difference.changes[0].target_faces);
        CHECK(back.changes[0].target_faces == difference.changes[0].source_faces);
        CHECK(back.changes[0].rejoined.size() == difference.changes[0].rejoined.size());
      }
    }
  }
}

TEST_CASE("the inverse of the inverse of every kind is that kind") {
  for (std::uint8_t k = 0; k <= static_cast<std::uint8_t>(ChangeKind::Reconnection); ++k) {
    CHECK(inverse(inverse(ChangeKind(k))) == ChangeKind(k));
  }
  CHECK(inverse(ChangeKind::Rip) == ChangeKind::Weld);
  CHECK(inverse(ChangeKind::Reconnection) == ChangeKind::Reconnection);
}

TEST_CASE("every unmatched face is in one change, and changes count as many as the totals say") {
  const PolygonSoup bear = shapes::bear().soup;
  const PolygonSoup other = edited(edited(edited(bear, "refine:5", 3), "delete:30", 4), "extrude:20", 5);
  const Difference difference = compared(bear, other);
  REQUIRE(difference.changes.size() >= 3);
  std::set<FaceId> removed, added;
  std::size_t named = 0, smaller = difference.changes.front().size();
  for (const Change& change : difference.changes) {
    CHECK(change.size() <= smaller);
    smaller = change.size();
    named += change.source_faces.size() + change.target_faces.size();
    removed.insert(change.source_faces.begin(), change.source_faces.end());
    added.insert(change.target_faces.begin(), change.target_faces.end());
  }
  CHECK(removed.size() == difference.totals.removed_faces());
  CHECK(added.size() == difference.totals.added_faces());
  CHECK(named == removed.size() + added.size());
}

TEST_CASE("a renumbered copy has no differences, whatever the mesh") {
  for (const NamedSoup& mesh : well_formed_zoo()) {
    CAPTURE(mesh.name);
    const Difference difference = compared(mesh.soup, shapes::renumbered(mesh.soup, 7).soup);
    CHECK(difference.none());
    CHECK(difference.totals.matched_faces == difference.totals.source_faces);
  }
  const PolygonSoup bear = shapes::bear().soup;
  CHECK(compared(bear, shapes::renumbered(bear, 8).soup).none());
}

TEST_CASE("posing moves vertices and changes nothing else") {
  const PolygonSoup bear = shapes::bear().soup;
  const PolygonSoup posed =
      shapes::renumbered(shapes::bear({.pose = {.left_arm = 0.2, .head_turn = 0.1}}).soup, 5).soup;
  const Difference difference = compared(bear, posed);
  CHECK(difference.changes.empty());
  CHECK_FALSE(difference.none());
  CHECK(difference.moved.size() > 100);
  CHECK(difference.moved.size() < bear.vertex_count);
  CHECK_FALSE(difference.whole_motion);
  const Difference ignored = compared(bear, posed, {.ignore_positions = true});
  CHECK(ignored.none());
}

TEST_CASE("what six decimals round away is no motion, and a larger tolerance passes over more") {
  const PolygonSoup bear = shapes::bear().soup;
  const auto rounded = [](double x) { return std::round(x * 1e6) / 1e6; };
  CHECK(compared(bear, moved(bear,
                             [&](const Point& p) {
                               return Point{rounded(p[0]), rounded(p[1]), rounded(p[2])};
                             }))
            .none());
  PolygonSoup nudged = bear;
  nudged.positions[100][1] += 0.01;
  const Difference difference = compared(bear, nudged);
  REQUIRE(difference.moved.size() == 1);
  CHECK(difference.moved[0] == VertexPair{VertexId(100), VertexId(100)});
  CHECK(compared(bear, nudged, {.tolerance = 0.1}).none());
}

TEST_CASE("a whole that was turned, scaled and shifted is told to have moved as one body") {
  const PolygonSoup bear = shapes::bear().soup;
  const Difference turned = compared(bear, moved(bear, [](const Point& p) {
                                       return Point{2 * p[0] + 1, -2 * p[2], 2 * p[1]};
                                     }));
  CHECK(turned.changes.empty());
  CHECK(turned.moved.size() == bear.vertex_count);
  REQUIRE(turned.whole_motion.has_value());
  CHECK(turned.whole_motion->degrees == doctest::Approx(90));
  CHECK(turned.whole_motion->scale == doctest::Approx(2));
  CHECK_FALSE(turned.whole_motion->mirrored);
  const Difference mirrored = compared(bear, moved(bear, [](const Point& p) { return Point{-p[0], p[1], p[2]}; }));
  REQUIRE(mirrored.whole_motion.has_value());
  CHECK(mirrored.whole_motion->mirrored);
}

TEST_CASE("a mirror image is told by the faces that are turned over") {
  const PolygonSoup bear = shapes::bear().soup;
  PolygonSoup mirrored = moved(bear, [](const Point& p) { return Point{-p[0], p[1], p[2]}; });
  for (std::size_t f = 0; f < mirrored.corners.size(); f += 4) {
    std::reverse(mirrored.corners.begin() + static_cast<std::ptrdiff_t>(f),
                 mirrored.corners.begin() + static_cast<std::ptrdiff_t>(f) + 4);
  }
  const Mesh a = build(bear), b = build(mirrored);
  MatchOptions options;
  options.orientation = OrientationChoice::Reversing;
  const Difference difference = compared(a, b, match(a, b, options).match, {.ignore_positions = true});
  CHECK(difference.changes.empty());
  CHECK(difference.totals.turned_faces == 2944);
  CHECK_FALSE(difference.none());
}

TEST_CASE("long sleeves cut short are two deletions, and components come and go by name") {
  const Difference cut =
      compared(shapes::shirt(shapes::Sleeves::Long).soup, shapes::shirt(shapes::Sleeves::Short).soup);
  CHECK(kinds_of(cut) == std::vector<ChangeKind>{ChangeKind::Deletion, ChangeKind::Deletion});
  CHECK(cut.totals.removed_faces() == 512);
  CHECK(cut.totals.rejoined_faces == 0);

  const PolygonSoup star = shapes::star(5, 3);
  const PolygonSoup more = shapes::disjoint_union({star, shapes::cube()});
  const Difference grown = compared(star, more);
  REQUIRE(grown.changes.size() == 1);
  CHECK(grown.changes[0].kind == ChangeKind::NewComponent);
  CHECK(grown.changes[0].target_faces.size() == 6);
  CHECK(grown.changes[0].target_vertices.size() == 8);
  CHECK(kinds_of(compared(more, star)) == std::vector<ChangeKind>{ChangeKind::RemovedComponent});
}

TEST_CASE("a face taken out of a grid is a deletion of just that face") {
  const PolygonSoup grid = shapes::grid(4, 3);
  PolygonSoup holed = grid;
  holed.corners.erase(holed.corners.begin() + 44, holed.corners.end());  // the last face
  Match match = same_numbers(11, 19);
  const Difference difference = compared(build(grid), build(holed), match);
  REQUIRE(difference.changes.size() == 1);
  const Change& change = difference.changes[0];
  CHECK(change.kind == ChangeKind::Deletion);
  CHECK(change.source_faces == std::vector<FaceId>{FaceId(11)});
  CHECK(change.target_faces.empty());
  CHECK(change.rejoined.empty());
  CHECK(change.edges == 0);
  CHECK(change.source_vertices == std::vector<VertexId>{VertexId(19)});
  CHECK(difference.totals.removed_vertices() == 1);
  CHECK(difference.totals.added_vertices() == 0);
}

TEST_CASE("pieces that met in a vertex and do not any more are ripped there, without any edge that tells of it") {
  const Mesh met = build(two_quads(true)), apart = build(two_quads(false));
  Match match;
  match.regions = {{.faces = {{FaceId(0), FaceId(0), 0}}}, {.faces = {{FaceId(1), FaceId(1), 0}}}};
  for (std::uint32_t v = 0; v < 7; ++v) match.vertices.push_back({VertexId(v), VertexId(v)});
  const Difference difference = compared(met, apart, match);
  REQUIRE(difference.changes.size() == 1);
  CHECK(difference.changes[0].kind == ChangeKind::Rip);
  CHECK(difference.changes[0].rejoined == std::vector<FaceId>{FaceId(0), FaceId(1)});
  CHECK(difference.changes[0].edges == 0);
  const Difference back = compared(apart, met, inverse_of(met, match));
  CHECK(kinds_of(back) == std::vector<ChangeKind>{ChangeKind::Weld});
}

TEST_CASE("a row at a boundary was split off where the old boundary still is, and put on where it is not") {
  const PolygonSoup grid = shapes::grid(6, 4);
  const PolygonSoup longer = shapes::grid(6, 5);
  PolygonSoup split = longer;
  for (std::uint32_t i = 0; i <= 6; ++i) {
    split.positions[4 * 7 + i] = {double(i), 3.5, 0};
    split.positions[5 * 7 + i] = {double(i), 4, 0};
  }
  const Match match = same_numbers(24, 35);
  const Mesh source = build(grid);
  CHECK(kinds_of(compared(source, build(longer), match)) == std::vector<ChangeKind>{ChangeKind::Addition});
  CHECK(kinds_of(compared(source, build(split), match)) == std::vector<ChangeKind>{ChangeKind::InsertedLoop});
  CHECK(kinds_of(compared(source, build(split), match, {.ignore_positions = true})) ==
        std::vector<ChangeKind>{ChangeKind::Addition});
}

TEST_CASE("rows side by side are counted, and seen from the other end they were removed") {
  const Mesh source = build(shapes::grid(6, 4)), target = build(shapes::grid(6, 7));
  Match match;
  match.regions.resize(2);
  for (std::uint32_t f = 0; f < 24; ++f) {
    const bool above = f >= 12;  // three rows farther up
    match.regions[above ? 1 : 0].faces.push_back({FaceId(f), FaceId(above ? f + 18 : f), 0});
  }
  for (std::uint32_t v = 0; v < 35; ++v) match.vertices.push_back({VertexId(v), VertexId(v < 21 ? v : v + 21)});
  const Difference difference = compared(source, target, match);
  REQUIRE(difference.changes.size() == 1);
  CHECK(difference.changes[0].kind == ChangeKind::InsertedLoop);
  CHECK(difference.changes[0].rows == 3);
  CHECK(difference.changes[0].target_faces.size() == 18);
  CHECK(difference.changes[0].edges == 6);
  const Difference back = compared(target, source, inverse_of(source, match));
  REQUIRE(back.changes.size() == 1);
  CHECK(back.changes[0].kind == ChangeKind::RemovedLoop);
  CHECK(back.changes[0].rows == 3);
}

TEST_CASE("a patch that was lifted twice has two rows of walls and is an extrusion, no inserted loops") {
  const PolygonSoup bear = shapes::bear().soup;
  for (const std::uint32_t patch : {5, 13}) {
    CAPTURE(patch);
    const Expected<shapes::Edit> once = shapes::extrude_patch(bear, FaceId(1000), patch, 0.05);
    REQUIRE(once.has_value());
    const Expected<shapes::Edit> twice = shapes::extrude_patch(once->soup, FaceId(1000), patch, 0.05);
    REQUIRE(twice.has_value());
    const Difference difference = compared(bear, shapes::renumbered(twice->soup, 3).soup);
    CHECK(kinds_of(difference) == std::vector<ChangeKind>{ChangeKind::Extrusion});
    CHECK(difference.totals.added_faces() - difference.totals.removed_faces() ==
          twice->soup.corners.size() / 4 - bear.corners.size() / 4);
  }
}

TEST_CASE("a slit names the edges along which faces parted, and joins up again as a weld") {
  const PolygonSoup bear = shapes::bear().soup;
  const Difference difference = compared(bear, edited(bear, "rip:6", 3));
  REQUIRE(difference.changes.size() == 1);
  CHECK(difference.changes[0].edges == 6);
  CHECK(difference.changes[0].source_faces.empty());
  CHECK(difference.changes[0].target_vertices.size() == 5);  // the copies
  CHECK(difference.totals.added_vertices() == 5);
  CHECK(difference.totals.rejoined_faces == 12);
}

TEST_CASE("an unsound match is refused, and regions of low confidence count as unmatched and are named") {
  const PolygonSoup grid = shapes::grid(4, 3);
  const Mesh mesh = build(grid);
  Match match = same_numbers(12, 20);
  match.regions[0].faces[3].rotation = 1;
  const Expected<Difference> refused = diff(mesh, mesh, match);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().code == ErrorCode::MatchDoesNotFit);

  Match doubtful = same_numbers(12, 20);
  doubtful.regions[0].evidence = {1, 4, 4};
  const Difference difference = compared(mesh, mesh, doubtful, {.least_confidence = 0.5});
  CHECK(difference.totals.matched_faces == 0);
  CHECK(difference.totals.matched_vertices == 0);
  CHECK(kinds_of(difference) == std::vector<ChangeKind>{ChangeKind::RemovedComponent, ChangeKind::NewComponent});
  REQUIRE(difference.doubtful.size() == 1);
  CHECK(difference.doubtful[0].left_out);
  CHECK(difference.doubtful[0].confidence == doctest::Approx(0.25));
}

TEST_CASE("without positions nothing has moved") {
  PolygonSoup bare = shapes::star(5, 3);
  bare.positions.clear();
  CHECK(compared(bare, shapes::star(5, 3)).none());
}
