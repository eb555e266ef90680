#include <doctest/doctest.h>

#include <quadmatch/shapes/catmull_clark.hpp>
#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::Topology;
using quadmatch::testing::topology_of;
using shapes::catmull_clark;

namespace {

std::vector<PolygonSoup> some_shapes() {
  using namespace shapes;
  return {grid(4, 3),
          cylinder(5, 2),
          star(5, 2),
          torus(4, 3),
          cube(),
          prism(7),
          grating(2, 1),
          dog_toy(16),
          many_components(3),
          mobius_strip(5),
          klein_bottle(4, 3),
          book(),
          hourglass(),
          bow_tie(),
          wrongly_wound(),
          self_glued_face(),
          degenerate_face(),
          duplicate_faces(),
          overlapping_faces(),
          unused_vertices(),
          observation_2_2(5)};
}

}  // namespace

TEST_CASE("Catmull-Clark makes V + E + F vertices and a quad of every corner, of any polygons, dirty ones too") {
  for (const PolygonSoup& soup : some_shapes()) {
    const Topology before = topology_of(soup);
    const PolygonSoup refined = catmull_clark(soup);
    CHECK(refined.vertex_count == soup.vertex_count + before.edges + before.faces);
    CHECK(refined.positions.size() == refined.vertex_count);
    CHECK(refined.face_starts.empty());
    CHECK(refined.corners.size() == 4 * soup.corners.size());
  }
}

TEST_CASE("Catmull-Clark keeps genus, boundary loops and components, and all new edge points are regular") {
  for (const PolygonSoup& soup : {shapes::grid(4, 3), shapes::cylinder(5, 2), shapes::star(5, 2), shapes::torus(4, 3),
                                  shapes::prism(7), shapes::grating(2, 1), shapes::dog_toy(16)}) {
    const Topology before = topology_of(soup), after = topology_of(catmull_clark(soup));
    CHECK(after.genus() == before.genus());
    CHECK(after.boundary_loops == before.boundary_loops);
    CHECK(after.components == 1);
    CHECK(after.clean());
    if (soup.face_starts.empty()) CHECK(after.extraordinary == before.extraordinary);
  }
}

TEST_CASE("Catmull-Clark: the quads of a face are consecutive and begin at its corners, in order") {
  const PolygonSoup soup = shapes::prism(5);
  const PolygonSoup refined = catmull_clark(soup);
  for (std::size_t c = 0; c < soup.corners.size(); ++c) CHECK(refined.corners[4 * c] == soup.corners[c]);
  for (std::uint32_t f = 0; f < 7; ++f) {
    for (std::uint32_t c = soup.face_starts[f]; c < soup.face_starts[f + 1]; ++c) {
      CHECK(refined.corners[4 * c + 2] == VertexId(10 + 15 + f));
    }
  }
}

TEST_CASE("Catmull-Clark keeps a non-manifold edge one edge: the book of three pages stays bound") {
  const Topology refined = topology_of(catmull_clark(shapes::book()));
  CHECK(refined.crowded_edges == 2);
  CHECK(refined.components == 1);
}

TEST_CASE("Catmull-Clark moves a cube's vertices to 5/9 of their distance from the centre") {
  const PolygonSoup cube = shapes::cube();
  const PolygonSoup refined = catmull_clark(cube);
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      CHECK(refined.positions[v][axis] - 0.5 == doctest::Approx(5.0 / 9.0 * (cube.positions[v][axis] - 0.5)));
    }
  }
  // An edge point is the mean of the edge's ends and the two face points, a face point that of the corners.
  CHECK(refined.positions[8][0] + refined.positions[8][1] + refined.positions[8][2] == doctest::Approx(0.75));
}

TEST_CASE("Catmull-Clark: a flat grid stays flat and keeps straight borders, its corners are rounded") {
  const PolygonSoup refined = catmull_clark(shapes::grid(4, 4));
  for (const Point& point : refined.positions) CHECK(point[2] == 0);
  CHECK(refined.positions[0] == Point{0.125, 0.125, 0});
  CHECK(refined.positions[1] == Point{1, 0, 0});
  CHECK(refined.positions[6] == Point{1, 1, 0});
}

TEST_CASE("Catmull-Clark without positions refines the connectivity alone") {
  PolygonSoup bare = shapes::torus(5, 4);
  bare.positions.clear();
  const PolygonSoup refined = catmull_clark(bare);
  CHECK(refined.positions.empty());
  CHECK(refined.corners == catmull_clark(shapes::torus(5, 4)).corners);
}

TEST_CASE("Catmull-Clark: several steps are one step several times") {
  const PolygonSoup once = catmull_clark(catmull_clark(shapes::prism(3)));
  CHECK(catmull_clark(shapes::prism(3), 2).corners == once.corners);
  CHECK(catmull_clark(shapes::prism(3), 2).positions == once.positions);
  CHECK(catmull_clark(shapes::prism(3), 0).corners == shapes::prism(3).corners);
}

TEST_CASE("Texture coordinates are refined within each face, so that seams stay seams") {
  const PolygonSoup soup = shapes::grid(2, 1);
  // Two tiles that do not touch, although the quads do.
  const std::vector<shapes::TextureCoordinate> tiles = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {2, 0}, {3, 0}, {3, 1}, {2, 1}};
  const auto refined = shapes::refine_coordinates(soup, tiles);
  REQUIRE(refined.size() == 32);
  CHECK(refined[0] == shapes::TextureCoordinate{0, 0});
  CHECK(refined[1] == shapes::TextureCoordinate{0.5, 0});
  CHECK(refined[2] == shapes::TextureCoordinate{0.5, 0.5});
  CHECK(refined[3] == shapes::TextureCoordinate{0, 0.5});
  CHECK(refined[4] == shapes::TextureCoordinate{1, 0});
  CHECK(refined[18] == shapes::TextureCoordinate{2.5, 0.5});
}
