// §2.1 and §2.2: how many vertices, edges and quads a mesh can have.

#include "named_meshes.hpp"

#include <cmath>

#include <quadmatch/mesh/check.hpp>

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

/// The paper's letters: n vertices, m edges, q quads, b boundary loops, genus g.
struct Sizes {
  std::int64_t n, m, q, b, g;
};

Sizes sizes_of(const PolygonSoup& soup) {
  const CheckReport report = check(build(soup));
  REQUIRE(report.components.size() == 1);
  REQUIRE(report.components[0].genus.has_value());
  return {report.vertices, report.edges, report.faces, report.boundary_loops, *report.components[0].genus};
}

}  // namespace

TEST_CASE("Obs 2.1: a quad mesh has at least 2q and at most 4q edges") {
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Sizes s = sizes_of(named.soup);
    CHECK(2 * s.q <= s.m);
    CHECK(s.m <= 4 * s.q);
  }
}

TEST_CASE("Obs 2.1: a single quad reaches the upper bound, every closed mesh the lower one") {
  const Sizes quad = sizes_of(shapes::grid(1, 1));
  CHECK(quad.m == 4 * quad.q);
  for (const PolygonSoup& soup : {shapes::cube(), shapes::torus(4, 5), shapes::dog_toy(16)}) {
    const Sizes closed = sizes_of(soup);
    CHECK(closed.m == 2 * closed.q);
  }
}

TEST_CASE("Obs 2.2: four vertices can carry any number of faces and edges") {
  for (const std::uint32_t tubes : {2U, 10U, 1000U}) {
    CAPTURE(tubes);
    const Mesh mesh = build(shapes::observation_2_2(tubes));
    CHECK(mesh.vertex_count() == 4);
    CHECK(mesh.face_count() == 2 * tubes);
    CHECK(mesh.edge_count() >= 4 * tubes);
  }
}

TEST_CASE("Obs 2.2 needs multiple edges: the file's four vertices span four pairs, each an edge of many faces") {
  const CheckReport report = check(build(shapes::observation_2_2(10)));
  CHECK(report.edges == 4);
  CHECK(report.departure_counts[static_cast<std::size_t>(DepartureKind::NonManifoldEdge)] == 4);
}

TEST_CASE("Obs 2.3: m <= 2n + 4g - 4 in a simple, connected, well-formed mesh, with equality where it is closed") {
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Sizes s = sizes_of(named.soup);
    if (s.b == 0) CHECK(s.m == 2 * s.n + 4 * s.g - 4);
  }
}

TEST_CASE("Obs 2.3 forgets the holes: a tube three quads around has an edge more, and m <= 2n + 4g - 4 + 2b holds") {
  const Sizes tube = sizes_of(shapes::cylinder(3, 1));
  CHECK(check(build(shapes::cylinder(3, 1))).well_formed());
  CHECK(tube.m == 9);
  CHECK(2 * tube.n + 4 * tube.g - 4 == 8);
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Sizes s = sizes_of(named.soup);
    CHECK(s.m <= 2 * s.n + 4 * s.g - 4 + 2 * s.b);
  }
}

TEST_CASE("Lemma 2.1: m <= (sqrt(4g/3) + 2) n - 4 in a simple, connected, well-formed mesh without holes") {
  for (std::uint32_t genus = 1; genus <= 40; ++genus) {
    CAPTURE(genus);
    const Sizes s = sizes_of(shapes::dog_toy(genus));
    CHECK(s.g == genus);
    CHECK(static_cast<double>(s.m) <=
          (std::sqrt(4.0 / 3.0 * static_cast<double>(s.g)) + 2) * static_cast<double>(s.n) - 4);
  }
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Sizes s = sizes_of(named.soup);
    const double bound = (std::sqrt(4.0 / 3.0 * static_cast<double>(s.g)) + 2) * static_cast<double>(s.n) - 4;
    CHECK(static_cast<double>(s.m) <= bound + 2 * static_cast<double>(s.b));
  }
}

TEST_CASE("Euler's formula: n - m + q + b = 2 - 2g in every component") {
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Sizes s = sizes_of(named.soup);
    CHECK(s.n - s.m + s.q + s.b == 2 - 2 * s.g);
  }
  const CheckReport report =
      check(build(shapes::disjoint_union({shapes::torus(4, 4), shapes::grid(3, 3), shapes::cube()})));
  REQUIRE(report.components.size() == 3);
  for (const ComponentReport& component : report.components) {
    REQUIRE(component.genus.has_value());
    CHECK(component.euler + component.boundary_loops == 2 - 2 * std::int64_t{*component.genus});
  }
}

TEST_CASE("the genus of every mesh of the zoo is what it was made with") {
  CHECK(sizes_of(shapes::grid(4, 3)).g == 0);
  CHECK(sizes_of(shapes::cylinder(5, 3)).g == 0);
  CHECK(sizes_of(shapes::torus(5, 4)).g == 1);
  CHECK(sizes_of(shapes::sphere(3)).g == 0);
  CHECK(sizes_of(shapes::grating(2, 3)).g == 6);
  CHECK(sizes_of(shapes::dog_toy(16)).g == 16);
}
