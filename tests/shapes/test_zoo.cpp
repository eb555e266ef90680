#include <doctest/doctest.h>

#include <string>

#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::faces_meet_properly;
using quadmatch::testing::Topology;
using quadmatch::testing::topology_of;

namespace {

using Valences = std::map<std::uint32_t, std::uint32_t>;

double signed_volume(const PolygonSoup& soup) {
  double volume = 0;
  for (const auto& face : quadmatch::testing::faces_of(soup)) {
    for (std::size_t k = 2; k < face.size(); ++k) {
      const Point &a = soup.positions[face[0]], &b = soup.positions[face[k - 1]], &c = soup.positions[face[k]];
      volume +=
          a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
  }
  return volume / 6;
}

struct Expected {
  std::string name;
  PolygonSoup soup;
  std::uint32_t vertices, edges, faces, boundary_loops;
  int genus;
  Valences inner, boundary;
};

std::vector<Expected> well_behaved() {
  using namespace shapes;
  return {
      {"grid(1, 1)", grid(1, 1), 4, 4, 1, 1, 0, {}, {{2, 4}}},
      {"grid(5, 3)", grid(5, 3), 24, 38, 15, 1, 0, {{4, 8}}, {{2, 4}, {3, 12}}},
      {"cylinder(6, 4)", cylinder(6, 4), 30, 54, 24, 2, 0, {{4, 18}}, {{3, 12}}},
      {"star(3, 1)", star(3, 1), 7, 9, 3, 1, 0, {{3, 1}}, {{2, 3}, {3, 3}}},
      {"star(5, 3)", star(5, 3), 61, 105, 45, 1, 0, {{4, 30}, {5, 1}}, {{2, 5}, {3, 25}}},
      {"torus(3, 3)", torus(3, 3), 9, 18, 9, 0, 1, {{4, 9}}, {}},
      {"torus(7, 4)", torus(7, 4), 28, 56, 28, 0, 1, {{4, 28}}, {}},
      {"cube", cube(), 8, 12, 6, 0, 0, {{3, 8}}, {}},
      {"cube_subdivided(3)", cube_subdivided(3), 56, 108, 54, 0, 0, {{3, 8}, {4, 48}}, {}},
      {"sphere(4)", sphere(4), 98, 192, 96, 0, 0, {{3, 8}, {4, 90}}, {}},
      {"prism(3)", prism(3), 6, 9, 5, 0, 0, {{3, 6}}, {}},
      {"prism(8)", prism(8), 16, 24, 10, 0, 0, {{3, 16}}, {}},
      {"grating(1, 1)", grating(1, 1), 32, 64, 32, 0, 1, {{3, 8}, {4, 16}, {5, 8}}, {}},
      {"grating(3, 2)", grating(3, 2), 96, 212, 106, 0, 6, {{3, 8}, {4, 40}, {5, 48}}, {}},
      {"dog_toy(1)", dog_toy(1), 16, 32, 16, 0, 1, {{4, 16}}, {}},
      {"dog_toy(16)", dog_toy(16), 106, 272, 136, 0, 16, {{4, 102}, {34, 4}}, {}},
      {"dog_toy(16, 6)", dog_toy(16, 6), 378, 816, 408, 0, 16, {{4, 374}, {34, 4}}, {}},
  };
}

}  // namespace

TEST_CASE("The well-behaved shapes have the counts, the genus and the valences that their names promise") {
  for (const Expected& expected : well_behaved()) {
    CAPTURE(expected.name);
    const Topology topology = topology_of(expected.soup);
    CHECK(topology.vertices == expected.vertices);
    CHECK(topology.vertices == expected.soup.vertex_count);
    CHECK(topology.edges == expected.edges);
    CHECK(topology.faces == expected.faces);
    CHECK(topology.boundary_loops == expected.boundary_loops);
    CHECK(topology.genus() == expected.genus);
    CHECK(topology.components == 1);
    CHECK(topology.inner_valences == expected.inner);
    CHECK(topology.boundary_valences == expected.boundary);
  }
}

TEST_CASE("The well-behaved shapes are simple, consistently wound, and every vertex has a position") {
  for (const Expected& expected : well_behaved()) {
    CAPTURE(expected.name);
    CHECK(topology_of(expected.soup).clean());
    CHECK(faces_meet_properly(expected.soup));
    CHECK(expected.soup.positions.size() == expected.soup.vertex_count);
    if (expected.boundary_loops == 0) CHECK(signed_volume(expected.soup) > 0);  // counter-clockwise from outside
  }
}

TEST_CASE("Every quad mesh of genus g bends by 4 (2 - 2 g - b): 4 - d inside, 3 - d on the boundary, summed") {
  for (const Expected& expected : well_behaved()) {
    CAPTURE(expected.name);
    if (!expected.soup.face_starts.empty()) continue;
    const Topology topology = topology_of(expected.soup);
    int sum = 0;
    for (const auto& [valence, count] : topology.inner_valences) sum += (4 - int(valence)) * int(count);
    for (const auto& [valence, count] : topology.boundary_valences) sum += (3 - int(valence)) * int(count);
    CHECK(sum == 4 * (2 - 2 * expected.genus - int(expected.boundary_loops)));
  }
}

TEST_CASE("Fig 2.1: the dog toy has genus 16") { CHECK(topology_of(shapes::dog_toy(16)).genus() == 16); }

TEST_CASE("Obs 2.2: four vertices can carry arbitrarily many quads") {
  for (const std::uint32_t tubes : {2U, 17U, 1000U}) {
    const PolygonSoup soup = shapes::observation_2_2(tubes);
    const Topology topology = topology_of(soup);
    CHECK(soup.vertex_count == 4);
    CHECK(topology.faces == 2 * tubes);
    // Two top vertices, two bottom ones, and top to bottom at each pole: four pairs, all of them multiple edges.
    CHECK(topology.edges == 4);
    CHECK(topology.crowded_edges == 4);
    // As the proof draws it, each pair stands for an edge per tube: 4 - 4 t + 2 t = 2 - 2 g.
    CHECK(4 - 4 * int(tubes) + 2 * int(tubes) == 2 - 2 * (int(tubes) - 1));
  }
}

TEST_CASE("A Moebius strip and a Klein bottle keep one seam where their faces cannot be wound alike") {
  const Topology strip = topology_of(shapes::mobius_strip(5));
  CHECK(strip.vertices == 10);
  CHECK(strip.edges == 15);
  CHECK(strip.faces == 5);
  CHECK(strip.boundary_loops == 1);
  CHECK(strip.miswound_edges == 1);
  CHECK(strip.extraordinary == 0);

  const Topology bottle = topology_of(shapes::klein_bottle(6, 5));
  CHECK(bottle.vertices == 30);
  CHECK(bottle.edges == 60);
  CHECK(bottle.faces == 30);
  CHECK(bottle.boundary_loops == 0);
  CHECK(bottle.miswound_edges == 6);
  CHECK(bottle.extraordinary == 0);
}

TEST_CASE("Each dirty shape is dirty in its own way") {
  CHECK(topology_of(shapes::book()).crowded_edges == 1);
  CHECK(topology_of(shapes::book()).edges == 10);
  CHECK(topology_of(shapes::wrongly_wound()).miswound_edges == 1);
  CHECK_FALSE(faces_meet_properly(shapes::self_glued_face()));
  CHECK_FALSE(faces_meet_properly(shapes::degenerate_face()));
  CHECK_FALSE(faces_meet_properly(shapes::duplicate_faces()));
  CHECK_FALSE(faces_meet_properly(shapes::overlapping_faces()));
  CHECK(topology_of(shapes::duplicate_faces()).crowded_edges == 4);

  const PolygonSoup hourglass = shapes::hourglass();
  CHECK(topology_of(hourglass).vertices == 15);
  CHECK(topology_of(hourglass).components == 1);
  CHECK(topology_of(hourglass).clean());
  CHECK(topology_of(hourglass).inner_valences == Valences{{3, 14}, {6, 1}});
  CHECK(faces_meet_properly(hourglass));
  CHECK(topology_of(shapes::bow_tie()).boundary_valences == Valences{{2, 6}, {4, 1}});

  CHECK(shapes::unused_vertices().vertex_count == 10);
  CHECK(topology_of(shapes::unused_vertices()).vertices == 4);
}

TEST_CASE("many_components(n) is n cubes, and a disjoint union keeps order and mixed polygons") {
  const PolygonSoup cubes = shapes::many_components(7);
  CHECK(topology_of(cubes).components == 7);
  CHECK(topology_of(cubes).faces == 42);
  CHECK(cubes.face_starts.empty());

  const PolygonSoup both = shapes::disjoint_union({shapes::prism(3), shapes::grid(2, 1)});
  CHECK(both.face_starts == std::vector<std::uint32_t>{0, 3, 6, 10, 14, 18, 22, 26});
  CHECK(both.corners.back() == VertexId(6 + 4));
  CHECK(topology_of(both).components == 2);
}
