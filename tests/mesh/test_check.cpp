// Every departure from §2.1, shown to the check as the very defect it is there to find.

#include "named_meshes.hpp"

#include <algorithm>

#include <quadmatch/mesh/check.hpp>
#include <quadmatch/shapes/renumber.hpp>

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

std::size_t count(const CheckReport& report, DepartureKind kind) {
  return report.departure_counts[static_cast<std::size_t>(kind)];
}

/// The message of the first departure of a kind.
std::string first_message(const CheckReport& report, DepartureKind kind) {
  for (const Departure& departure : report.departures) {
    if (departure.kind == kind) return departure.message;
  }
  return "none";
}

/// Departures of all other kinds.
std::size_t others(const CheckReport& report, std::initializer_list<DepartureKind> kinds) {
  std::size_t sum = 0;
  for (const std::size_t each : report.departure_counts) sum += each;
  for (const DepartureKind kind : kinds) sum -= count(report, kind);
  return sum;
}

/// A 3 by 3 grid without its middle quad and without the one beyond that one's corner.
Mesh touching_holes() {
  PolygonSoup soup = shapes::grid(4, 4);
  PolygonSoup holed{.vertex_count = soup.vertex_count};
  for (std::uint32_t f = 0; f < 16; ++f) {
    if (f == 5 || f == 10) continue;
    holed.corners.insert(holed.corners.end(), soup.corners.begin() + 4 * f, soup.corners.begin() + 4 * f + 4);
  }
  return build(holed);
}

/// `faces` quads around two poles, a fan of pages: all share the diagonal between the poles.
Mesh pages(std::uint32_t faces) {
  PolygonSoup soup{.vertex_count = 2 + 2 * faces};
  for (std::uint32_t f = 0; f < faces; ++f) {
    for (const std::uint32_t v : {0U, 2 + 2 * f, 1U, 3 + 2 * f}) soup.corners.push_back(VertexId(v));
  }
  return build(soup);
}

}  // namespace

TEST_CASE("§2.1: the simple, well-formed meshes of the zoo have no departure") {
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const CheckReport report = check(build(named.soup));
    CHECK(report.well_formed());
    CHECK(report.departures.empty());
    CHECK(report.departure_counts.size() == 10);
  }
}

TEST_CASE("every mesh of the dirty zoo departs from §2.1") {
  for (const NamedSoup& named : dirty_zoo()) {
    CAPTURE(named.name);
    CHECK_FALSE(check(build(named.soup)).well_formed());
  }
}

TEST_CASE(
    "sizes: a grid of 4 by 3 has 20 vertices, 31 edges, 12 quads, one loop and four corners out of the ordinary") {
  const CheckReport report = check(build(shapes::grid(4, 3)));
  CHECK(report.vertices == 20);
  CHECK(report.edges == 31);
  CHECK(report.faces == 12);
  CHECK(report.quads == 12);
  CHECK(report.triangles == 0);
  CHECK(report.larger == 0);
  CHECK(report.boundary_loops == 1);
  CHECK(report.extraordinary == 4);
  REQUIRE(report.components.size() == 1);
  CHECK(report.components[0].euler == 1);
  CHECK(report.components[0].genus == 0U);
}

TEST_CASE("components stand from the most faces to the fewest, equal ones by their lowest face") {
  const CheckReport report = check(
      build(shapes::disjoint_union({shapes::grid(3, 2), shapes::torus(3, 3), shapes::cube(), shapes::grid(1, 1)})));
  REQUIRE(report.components.size() == 4);
  CHECK(report.components[0].genus == 1U);
  CHECK(report.components[1].boundary_loops == 1);
  CHECK(report.components[1].faces == 6);
  CHECK(report.components[2].boundary_loops == 0);
  CHECK(report.components[2].faces == 6);
  CHECK(report.components[3].faces == 1);
  CHECK(report.boundary_loops == 2);
}

TEST_CASE("a face of other than four corners is named") {
  const CheckReport report = check(build(shapes::prism(5)));
  CHECK(count(report, DepartureKind::NotAQuad) == 2);
  CHECK(others(report, {DepartureKind::NotAQuad}) == 0);
  CHECK(report.larger == 2);
  CHECK(report.quads == 5);
  CHECK(first_message(check(build(soup_of(3, {{0, 1, 2}}))), DepartureKind::NotAQuad) == "f0 has 3 corners");
}

TEST_CASE("a face that visits a vertex twice is named") {
  const CheckReport report = check(mesh_of(3, {{0, 1, 1, 2}}));
  CHECK(count(report, DepartureKind::DegenerateFace) == 1);
  CHECK(first_message(report, DepartureKind::DegenerateFace) == "f0 visits v1 twice");
  CHECK(count(check(build(shapes::degenerate_face())), DepartureKind::DegenerateFace) == 1);
  CHECK(count(check(build(shapes::self_glued_face())), DepartureKind::DegenerateFace) == 1);
}

TEST_CASE("a vertex of no face is named, and counts nowhere else") {
  const CheckReport report = check(build(shapes::unused_vertices()));
  CHECK(count(report, DepartureKind::UnusedVertex) == 6);
  CHECK(others(report, {DepartureKind::UnusedVertex}) == 0);
  CHECK(first_message(report, DepartureKind::UnusedVertex) == "v0 belongs to no face");
  CHECK(report.vertices == 4);
}

TEST_CASE("condition 1: a vertex whose faces form two fans is named, and joins its cubes into one component") {
  const Mesh mesh = build(shapes::hourglass());
  const CheckReport report = check(mesh);
  CHECK(count(report, DepartureKind::DisconnectedVertex) == 1);
  CHECK(others(report, {DepartureKind::DisconnectedVertex}) == 0);
  CHECK(first_message(report, DepartureKind::DisconnectedVertex) ==
        "the faces around " + to_string(mesh.split_vertices()[0]) + " form 2 fans that share no edge");
  REQUIRE(report.components.size() == 1);
  CHECK_FALSE(report.components[0].manifold);
  CHECK_FALSE(report.components[0].genus.has_value());
}

TEST_CASE("condition 2: a hole that passes a vertex twice is named") {
  const CheckReport report = check(touching_holes());
  CHECK(count(report, DepartureKind::PinchedHole) == 1);
  CHECK(count(report, DepartureKind::DisconnectedVertex) == 1);
  CHECK(others(report, {DepartureKind::PinchedHole, DepartureKind::DisconnectedVertex}) == 0);
  CHECK(first_message(report, DepartureKind::PinchedHole) == "a hole passes v12 twice, so no disk closes it");
  CHECK(report.boundary_loops == 2);
}

TEST_CASE("condition 2: two quads that share a vertex have a simple loop each, so nothing is pinched") {
  const CheckReport report = check(build(shapes::bow_tie()));
  CHECK(count(report, DepartureKind::PinchedHole) == 0);
  CHECK(count(report, DepartureKind::DisconnectedVertex) == 1);
  CHECK(report.boundary_loops == 2);
}

TEST_CASE("condition 3: an edge of three faces is named, and none of them hangs together at its ends") {
  const CheckReport report = check(build(shapes::book()));
  CHECK(count(report, DepartureKind::NonManifoldEdge) == 1);
  CHECK(count(report, DepartureKind::DisconnectedVertex) == 2);
  CHECK(first_message(report, DepartureKind::NonManifoldEdge).find(" has 3 faces") != std::string::npos);
  CHECK(report.edges == 10);
  REQUIRE(report.components.size() == 1);
  CHECK_FALSE(report.components[0].manifold);
}

TEST_CASE("two faces that run along their edge the same way are named, and the surface still goes on there") {
  const CheckReport report = check(build(shapes::wrongly_wound()));
  CHECK(count(report, DepartureKind::InconsistentWinding) == 1);
  CHECK(others(report, {DepartureKind::InconsistentWinding}) == 0);
  REQUIRE(report.components.size() == 1);
  CHECK(report.components[0].orientable);
  CHECK(report.components[0].genus == 0U);
  CHECK(report.boundary_loops == 1);
}

TEST_CASE("a component that no turning of faces makes two-sided is named by its first face") {
  for (const std::uint32_t length : {3U, 4U, 7U}) {
    const CheckReport strip = check(build(shapes::mobius_strip(length)));
    CHECK(count(strip, DepartureKind::NotOrientable) == 1);
    CHECK(count(strip, DepartureKind::InconsistentWinding) == 1);
    CHECK_FALSE(strip.components[0].orientable);
    CHECK(strip.components[0].genus == 1U);
    CHECK(strip.boundary_loops == 1);
  }
  const CheckReport bottle = check(build(shapes::klein_bottle(4, 5)));
  CHECK(count(bottle, DepartureKind::NotOrientable) == 1);
  CHECK(bottle.components[0].genus == 2U);
  CHECK(bottle.boundary_loops == 0);
  CHECK(first_message(bottle, DepartureKind::NotOrientable).find("the component of f0 ") == 0);
}

TEST_CASE("faces that can be turned to agree are orientable, however many are turned") {
  PolygonSoup soup = shapes::torus(5, 4);
  for (std::uint32_t f = 0; f < 20; f += 3)
    std::reverse(soup.corners.begin() + 4 * f, soup.corners.begin() + 4 * f + 4);
  const CheckReport report = check(build(soup));
  CHECK(count(report, DepartureKind::InconsistentWinding) > 0);
  CHECK(count(report, DepartureKind::NotOrientable) == 0);
  CHECK(count(report, DepartureKind::DisconnectedVertex) == 0);
  CHECK(report.components[0].genus == 1U);
}

TEST_CASE("condition 4: two quads that share two edges are named") {
  const CheckReport report = check(build(shapes::overlapping_faces()));
  CHECK(count(report, DepartureKind::OverlappingFaces) == 1);
  CHECK(others(report, {DepartureKind::OverlappingFaces}) == 0);
  CHECK(first_message(report, DepartureKind::OverlappingFaces) ==
        "f0 and f1 share 3 vertices and 2 edges, not just one or the other");
}

TEST_CASE("condition 4: two quads that share two vertices but no edge are named") {
  const CheckReport diagonals = check(mesh_of(6, {{0, 1, 2, 3}, {0, 4, 2, 5}}));
  CHECK(count(diagonals, DepartureKind::OverlappingFaces) == 1);
  CHECK(first_message(diagonals, DepartureKind::OverlappingFaces).find("2 vertices and 0 edges") != std::string::npos);
  const CheckReport mixed = check(mesh_of(6, {{0, 1, 2, 3}, {0, 2, 4, 5}}));
  CHECK(count(mixed, DepartureKind::OverlappingFaces) == 1);
}

TEST_CASE("condition 4: two quads may share one edge, or one vertex") {
  CHECK(count(check(mesh_of(6, {{0, 1, 2, 3}, {1, 0, 4, 5}})), DepartureKind::OverlappingFaces) == 0);
  CHECK(count(check(mesh_of(7, {{0, 1, 2, 3}, {0, 4, 5, 6}})), DepartureKind::OverlappingFaces) == 0);
}

TEST_CASE("condition 4: a tube two quads around meets itself in two edges") {
  const CheckReport report = check(mesh_of(4, {{0, 1, 3, 2}, {1, 0, 2, 3}}));
  CHECK(count(report, DepartureKind::DuplicateFace) == 1);
  const CheckReport ring = check(mesh_of(6, {{0, 1, 3, 2}, {1, 0, 2, 3}, {2, 3, 5, 4}, {3, 2, 4, 5}}));
  CHECK(count(ring, DepartureKind::DuplicateFace) == 2);
}

TEST_CASE("condition 4: every two of 32 quads with a common diagonal are named, beyond that each with the first") {
  CHECK(count(check(pages(32)), DepartureKind::OverlappingFaces) == 32 * 31 / 2);
  CHECK(count(check(pages(33)), DepartureKind::OverlappingFaces) == 32);
  CHECK(count(check(pages(100'000)), DepartureKind::OverlappingFaces) == 99'999);
}

TEST_CASE("a face with the vertices of an earlier one is named, wherever it starts and whichever way it runs") {
  for (const std::vector<std::uint32_t>& copy :
       {std::vector<std::uint32_t>{0, 1, 2, 3}, {2, 3, 0, 1}, {3, 2, 1, 0}, {0, 2, 1, 3}}) {
    const CheckReport report = check(mesh_of(4, {{0, 1, 2, 3}, copy}));
    CHECK(count(report, DepartureKind::DuplicateFace) == 1);
    CHECK(count(report, DepartureKind::OverlappingFaces) == 0);
    CHECK(first_message(report, DepartureKind::DuplicateFace) == "f1 has the same vertices as f0");
  }
  CHECK(count(check(mesh_of(3, {{0, 1, 2}, {0, 1, 2}, {1, 2, 0}})), DepartureKind::DuplicateFace) == 2);
  CHECK(count(check(build(shapes::duplicate_faces())), DepartureKind::DuplicateFace) == 1);
}

TEST_CASE("all departures are counted, and as many of each kind are described as were asked for") {
  const Mesh mesh = mesh_of(9, {{0, 1, 2}, {3, 4, 5}, {0, 1, 1}});
  const CheckReport report = check(mesh, 2);
  CHECK(count(report, DepartureKind::NotAQuad) == 3);
  CHECK(count(report, DepartureKind::UnusedVertex) == 3);
  CHECK(std::count_if(report.departures.begin(), report.departures.end(),
                      [](const Departure& d) { return d.kind == DepartureKind::NotAQuad; }) == 2);
  CHECK(std::is_sorted(report.departures.begin(), report.departures.end(),
                       [](const Departure& a, const Departure& b) { return a.kind < b.kind; }));
  CHECK(check(mesh, 0).departures.empty());
  CHECK_FALSE(check(mesh, 0).well_formed());
}

TEST_CASE("the counts of a check do not depend on the numbering") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const CheckReport report = check(build(named.soup));
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const CheckReport copy = check(build(shapes::renumbered(named.soup, seed).soup));
      CHECK(copy.departure_counts == report.departure_counts);
      CHECK(copy.vertices == report.vertices);
      CHECK(copy.edges == report.edges);
      CHECK(copy.boundary_loops == report.boundary_loops);
      CHECK(copy.extraordinary == report.extraordinary);
      CHECK(copy.components.size() == report.components.size());
    }
  }
}

TEST_CASE("a mesh without faces is well-formed but for its unused vertices") {
  CHECK(check(build(PolygonSoup{})).well_formed());
  const CheckReport report = check(build(PolygonSoup{.vertex_count = 2}));
  CHECK(count(report, DepartureKind::UnusedVertex) == 2);
  CHECK(report.components.empty());
}

TEST_CASE("every kind of departure has a name of its own") {
  std::vector<std::string> names;
  for (int kind = 0; kind < 10; ++kind) names.emplace_back(to_string(static_cast<DepartureKind>(kind)));
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
  CHECK(std::string(to_string(DepartureKind::DuplicateFace)) == "duplicate-face");
  CHECK(std::string(to_string(DepartureKind::NonManifoldEdge)) == "non-manifold-edge");
}
