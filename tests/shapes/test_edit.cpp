#include <doctest/doctest.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <string>

#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::Face;
using quadmatch::testing::faces_meet_properly;
using quadmatch::testing::faces_of;
using quadmatch::testing::Topology;
using quadmatch::testing::topology_of;

namespace {

/// Lays surviving faces on each other corner by corner, and gathers which vertices meet.
struct VertexRelation {
  std::map<std::uint32_t, std::set<std::uint32_t>> images, origins;

  VertexRelation(const PolygonSoup& source, const PolygonSoup& target, const std::vector<FacePair>& truth) {
    const std::vector<Face> before = faces_of(source), after = faces_of(target);
    std::set<FaceId> sources, targets;
    for (const FacePair& pair : truth) {
      REQUIRE(pair.source.value < before.size());
      REQUIRE(pair.target.value < after.size());
      CHECK(sources.insert(pair.source).second);
      CHECK(targets.insert(pair.target).second);
      const Face &face = before[pair.source.value], &image = after[pair.target.value];
      REQUIRE(face.size() == image.size());
      const auto size = static_cast<std::uint32_t>(face.size());
      for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t w = image[image_corner(Orientation::Preserving, pair.rotation, i, size)];
        images[face[i]].insert(w);
        origins[w].insert(face[i]);
      }
    }
  }

  [[nodiscard]] static long several(const std::map<std::uint32_t, std::set<std::uint32_t>>& relation) {
    return std::count_if(relation.begin(), relation.end(), [](const auto& entry) { return entry.second.size() > 1; });
  }
  [[nodiscard]] bool one_to_one() const { return several(images) == 0 && several(origins) == 0; }
};

std::string refusal(const quadmatch::Expected<shapes::Edit>& edit) { return edit ? "" : edit.error().message; }

/// The face of a grid of m columns at column i, row j.
FaceId grid_face(std::uint32_t m, std::uint32_t i, std::uint32_t j) { return FaceId(j * m + i); }

}  // namespace

TEST_CASE("delete_patch: what is left survives where it was, and a hole is left") {
  const PolygonSoup soup = shapes::grid(9, 9);
  const auto edit = shapes::delete_patch(soup, grid_face(9, 4, 4), 5);
  REQUIRE(edit);
  const Topology topology = topology_of(edit->soup);
  CHECK(topology.faces == 76);
  CHECK(topology.boundary_loops == 2);
  CHECK(topology.genus() == 0);
  CHECK(edit->soup.vertex_count == topology.vertices);
  CHECK(edit->soup.positions.size() == topology.vertices);
  CHECK(edit->truth.size() == 76);
  CHECK(VertexRelation(soup, edit->soup, edit->truth).one_to_one());
}

TEST_CASE("delete_patch drops the vertices that only the patch used, and keeps mixed polygons") {
  const PolygonSoup prism = shapes::prism(5);
  const auto edit = shapes::delete_patch(prism, FaceId(0), 1);
  REQUIRE(edit);
  CHECK(topology_of(edit->soup).faces == 6);
  CHECK(edit->soup.vertex_count == 10);
  CHECK(VertexRelation(prism, edit->soup, edit->truth).one_to_one());

  const auto corner = shapes::delete_patch(shapes::grid(2, 2), FaceId(0), 1);
  REQUIRE(corner);
  CHECK(corner->soup.vertex_count == 8);
  CHECK(corner->soup.positions.front() == Point{1, 0, 0});
}

TEST_CASE("extrude_patch: a wall of quads as long as the rim, the lifted faces survive on new vertices") {
  const PolygonSoup soup = shapes::grid(9, 9);
  const auto edit = shapes::extrude_patch(soup, grid_face(9, 4, 4), 5, 2.0);
  REQUIRE(edit);
  const Topology topology = topology_of(edit->soup);
  CHECK(topology.faces == 81 + 12);
  CHECK(topology.vertices == 100 + 12);
  CHECK(topology.boundary_loops == 1);
  CHECK(topology.genus() == 0);
  CHECK(topology.clean());
  CHECK(faces_meet_properly(edit->soup));
  CHECK(edit->truth.size() == 81);
  const VertexRelation relation(soup, edit->soup, edit->truth);
  CHECK(VertexRelation::several(relation.images) == 12);  // the rim, below and above
  CHECK(VertexRelation::several(relation.origins) == 0);
  for (std::uint32_t v = 100; v < 112; ++v) CHECK(edit->soup.positions[v][2] == doctest::Approx(2));
}

TEST_CASE("extrude_patch without positions changes the connectivity alone") {
  PolygonSoup soup = shapes::sphere(4);
  const auto with = shapes::extrude_patch(soup, FaceId(20), 7, 0.5);
  soup.positions.clear();
  const auto without = shapes::extrude_patch(soup, FaceId(20), 7, 0.5);
  REQUIRE(with);
  REQUIRE(without);
  CHECK(with->soup.corners == without->soup.corners);
  CHECK(without->soup.positions.empty());
}

TEST_CASE("insert_edge_loop: the split quads do not survive, every other face does") {
  SUBCASE("from border to border") {
    const PolygonSoup soup = shapes::grid(6, 4);
    const auto edit = shapes::insert_edge_loop(soup, HalfedgeId(4 * grid_face(6, 2, 1).value));  // a lower side
    REQUIRE(edit);
    CHECK(topology_of(edit->soup).faces == 28);
    CHECK(topology_of(edit->soup).vertices == 35 + 5);
    CHECK(topology_of(edit->soup).extraordinary == 4);
    CHECK(topology_of(edit->soup).clean());
    CHECK(edit->truth.size() == 20);
    CHECK(VertexRelation(soup, edit->soup, edit->truth).one_to_one());
  }
  SUBCASE("from a border edge inwards, and from the other side of an edge") {
    const PolygonSoup soup = shapes::grid(6, 4);
    for (const std::uint32_t side : {0U, 1U, 2U, 3U}) {
      const auto edit = shapes::insert_edge_loop(soup, HalfedgeId(side));
      REQUIRE(edit);
      CHECK(topology_of(edit->soup).faces == 24 + (side % 2 == 0 ? 4 : 6));
      CHECK(topology_of(edit->soup).clean());
    }
  }
  SUBCASE("all the way round") {
    const PolygonSoup soup = shapes::torus(7, 5);
    const auto edit = shapes::insert_edge_loop(soup, HalfedgeId(1));
    REQUIRE(edit);
    CHECK(topology_of(edit->soup).faces == 42);
    CHECK(topology_of(edit->soup).vertices == 42);
    CHECK(topology_of(edit->soup).genus() == 1);
    CHECK(topology_of(edit->soup).extraordinary == 0);
    CHECK(edit->truth.size() == 28);
    CHECK(VertexRelation(soup, edit->soup, edit->truth).one_to_one());
  }
}

TEST_CASE("collapse_quad: one quad becomes two edges, two vertices one") {
  const PolygonSoup soup = shapes::torus(6, 6);
  const auto edit = shapes::collapse_quad(soup, HalfedgeId(41));
  REQUIRE(edit);
  const Topology topology = topology_of(edit->soup);
  CHECK(topology.faces == 35);
  CHECK(topology.vertices == 35);
  CHECK(topology.genus() == 1);
  CHECK(topology.clean());
  CHECK(topology.inner_valences == std::map<std::uint32_t, std::uint32_t>{{3, 2}, {4, 32}, {6, 1}});
  CHECK(faces_meet_properly(edit->soup));
  CHECK(edit->truth.size() == 35);
  const VertexRelation relation(soup, edit->soup, edit->truth);
  CHECK(VertexRelation::several(relation.images) == 0);
  CHECK(VertexRelation::several(relation.origins) == 1);
}

TEST_CASE("remove_edge_loop: a row of quads less, and what was beside it is joined") {
  SUBCASE("from border to border") {
    const PolygonSoup soup = shapes::grid(6, 4);
    const auto edit = shapes::remove_edge_loop(soup, HalfedgeId(4 * grid_face(6, 2, 1).value));
    REQUIRE(edit);
    CHECK(topology_of(edit->soup).faces == 20);
    CHECK(topology_of(edit->soup).vertices == 35 - 5);
    CHECK(topology_of(edit->soup).extraordinary == 4);
    CHECK(topology_of(edit->soup).clean());
    CHECK(edit->truth.size() == 20);
    const VertexRelation relation(soup, edit->soup, edit->truth);
    CHECK(VertexRelation::several(relation.images) == 0);
    CHECK(VertexRelation::several(relation.origins) == 5);
    CHECK(edit->soup.positions[2] == Point{2.5, 0, 0});  // midway
  }
  SUBCASE("all the way round") {
    const PolygonSoup soup = shapes::torus(7, 5);
    const auto edit = shapes::remove_edge_loop(soup, HalfedgeId(1));
    REQUIRE(edit);
    CHECK(topology_of(edit->soup).faces == 28);
    CHECK(topology_of(edit->soup).genus() == 1);
    CHECK(topology_of(edit->soup).extraordinary == 0);
    CHECK(edit->truth.size() == 28);
  }
  SUBCASE("what an inserted loop added is gone again") {
    const PolygonSoup soup = shapes::sphere(4);
    const auto more = shapes::insert_edge_loop(soup, HalfedgeId(17));
    REQUIRE(more);
    const auto less = shapes::remove_edge_loop(more->soup, HalfedgeId(4 * (topology_of(more->soup).faces - 1)));
    REQUIRE(less);
    CHECK(topology_of(less->soup).faces == topology_of(soup).faces);
    CHECK(topology_of(less->soup).inner_valences == topology_of(soup).inner_valences);
  }
}

TEST_CASE("twist_ring: the ring is new, every other face is where it was, and corners meet others") {
  const PolygonSoup soup = shapes::cylinder(8, 5);
  const auto edit = shapes::twist_ring(soup, HalfedgeId(4 * 19 + 1), 3);
  REQUIRE(edit);
  const Topology topology = topology_of(edit->soup);
  CHECK(topology.faces == 40);
  CHECK(topology.vertices == topology_of(soup).vertices);
  CHECK(topology.boundary_loops == 2);
  CHECK(topology.extraordinary == 0);
  CHECK(topology.clean());
  CHECK(faces_meet_properly(edit->soup));
  CHECK(edit->truth.size() == 32);
  CHECK(VertexRelation(soup, edit->soup, edit->truth).one_to_one());
  CHECK(edit->soup.corners != soup.corners);
  std::vector<Face> before = faces_of(soup), after = faces_of(edit->soup);
  for (std::vector<Face>* faces : {&before, &after}) {
    for (Face& face : *faces) std::sort(face.begin(), face.end());
    std::sort(faces->begin(), faces->end());
  }
  std::vector<Face> common;
  std::set_intersection(before.begin(), before.end(), after.begin(), after.end(), std::back_inserter(common));
  CHECK(common.size() == 32);  // none of the ring's quads joins what it joined
}

TEST_CASE("rip_edges: a hole without a face lost, and copies of the vertices inside the slit") {
  const PolygonSoup soup = shapes::grid(9, 9);
  const auto edit = shapes::rip_edges(soup, HalfedgeId(4 * grid_face(9, 2, 4).value), 4);
  REQUIRE(edit);
  const Topology topology = topology_of(edit->soup);
  CHECK(topology.faces == 81);
  CHECK(topology.vertices == 100 + 3);
  CHECK(topology.boundary_loops == 2);
  CHECK(topology.genus() == 0);
  CHECK(topology.clean());
  CHECK(edit->truth.size() == 81);
  const VertexRelation relation(soup, edit->soup, edit->truth);
  CHECK(VertexRelation::several(relation.images) == 3);
  CHECK(VertexRelation::several(relation.origins) == 0);
}

TEST_CASE("refine_patch: four for one, and larger neighbours") {
  const PolygonSoup soup = shapes::grid(9, 9);
  const auto edit = shapes::refine_patch(soup, grid_face(9, 4, 4), 5);
  REQUIRE(edit);
  const Topology topology = topology_of(edit->soup);
  CHECK(topology.faces == 81 - 5 + 20);
  CHECK(topology.boundary_loops == 1);
  CHECK(topology.genus() == 0);
  CHECK(topology.clean());
  CHECK(edit->truth.size() == 81 - 5 - 8);
  CHECK(VertexRelation(soup, edit->soup, edit->truth).one_to_one());
  const std::vector<Face> faces = faces_of(edit->soup);
  CHECK(std::count_if(faces.begin(), faces.end(), [](const Face& face) { return face.size() == 5; }) == 4);
  CHECK(std::count_if(faces.begin(), faces.end(), [](const Face& face) { return face.size() == 6; }) == 4);
}

TEST_CASE("add_handle: two quads less, a tube of four more, and one more genus") {
  const PolygonSoup soup = shapes::sphere(4);
  const auto edit = shapes::add_handle(soup, FaceId(3), FaceId(77));
  REQUIRE(edit);
  CHECK(topology_of(edit->soup).faces == 98);
  CHECK(topology_of(edit->soup).genus() == 1);
  CHECK(topology_of(edit->soup).clean());
  CHECK(faces_meet_properly(edit->soup));
  CHECK(edit->truth.size() == 94);
  CHECK(VertexRelation(soup, edit->soup, edit->truth).one_to_one());
}

TEST_CASE("Edits that do not fit are refused with a sentence, and so are elements that do not exist") {
  const PolygonSoup cube = shapes::cube(), grid = shapes::grid(4, 4), prism = shapes::prism(6);
  CHECK(refusal(shapes::delete_patch(cube, FaceId(0), 6)) == "no face would be left");
  CHECK(refusal(shapes::delete_patch(cube, FaceId(6), 1)) == "there is no face f6");
  CHECK(refusal(shapes::extrude_patch(cube, FaceId(0), 6, 1)) == "the patch is a whole component and has no rim");
  CHECK(refusal(shapes::extrude_patch(shapes::grating(1, 1), FaceId(0), 9, 1)) ==
        "the rim of the patch passes v5 twice");
  CHECK(refusal(shapes::insert_edge_loop(prism, HalfedgeId(12))) == "the loop runs into f1, which is not a quad");
  CHECK(refusal(shapes::insert_edge_loop(grid, HalfedgeId(64))) == "there is no half-edge h64");
  CHECK(refusal(shapes::collapse_quad(grid, HalfedgeId(0))) == "v0 is not inside the surface");
  CHECK(refusal(shapes::collapse_quad(cube, HalfedgeId(0))).find("two faces") != std::string::npos);
  CHECK(refusal(shapes::collapse_quad(prism, HalfedgeId(0))) == "f0 is not a quad");
  const auto crowded = shapes::collapse_quad(shapes::torus(3, 3), HalfedgeId(0));
  REQUIRE(crowded);
  CHECK(refusal(shapes::collapse_quad(crowded->soup, HalfedgeId(12))) == "v0 and v7 meet elsewhere too");
  CHECK(refusal(shapes::remove_edge_loop(shapes::grid(1, 4), HalfedgeId(1))) == "");
  CHECK(refusal(shapes::remove_edge_loop(shapes::grid(4, 1), HalfedgeId(1))) == "no face would be left");
  CHECK(refusal(shapes::remove_edge_loop(cube, HalfedgeId(0))) ==
        "the result would not be well-formed: duplicate-face");
  CHECK(refusal(shapes::twist_ring(grid, HalfedgeId(0), 1)) == "the row of quads is no ring");
  CHECK(refusal(shapes::twist_ring(cube, HalfedgeId(0), 1)) == "a ring of 4 quads cannot be turned without folding");
  CHECK(refusal(shapes::rip_edges(grid, HalfedgeId(0), 2)) == "v0 is not inside the surface");
  CHECK(refusal(shapes::rip_edges(cube, HalfedgeId(0), 1)) == "a slit of one edge opens nothing");
  CHECK(refusal(shapes::rip_edges(cube, HalfedgeId(0), 9)).find("the slit meets v") == 0);
  CHECK(refusal(shapes::refine_patch(prism, FaceId(0), 1)) == "f0 is not a quad");
  CHECK(refusal(shapes::add_handle(grid, FaceId(0), FaceId(1))) == "f0 and f1 share a vertex");
  CHECK(refusal(shapes::add_handle(grid, FaceId(0), FaceId(16))) == "there is no face f16");
  CHECK(shapes::delete_patch(cube, FaceId(6), 1).error().code == ErrorCode::BadArgument);

  PolygonSoup broken = cube;
  broken.corners[5] = VertexId(99);
  CHECK(shapes::delete_patch(broken, FaceId(0), 1).error().code == ErrorCode::BadIndex);
}

TEST_CASE("chained: edits after one another keep their truth, a renumbering included") {
  const PolygonSoup soup = shapes::sphere(6);
  const auto first = shapes::delete_patch(soup, FaceId(100), 9);
  REQUIRE(first);
  const auto second = shapes::extrude_patch(first->soup, FaceId(20), 4, 0.2);
  REQUIRE(second);
  const shapes::Renumbered third = shapes::renumbered(second->soup, 11);
  const auto edited = shapes::chained(first->truth, second->truth, second->soup);
  const auto all = shapes::chained(edited, third.faces, third.soup);
  CHECK(all.size() == 216 - 9);
  const VertexRelation relation(soup, third.soup, all);
  CHECK(VertexRelation::several(relation.origins) == 0);
  CHECK(VertexRelation::several(relation.images) == 10);
}
