#include <quadmatch/analysis/skeleton.hpp>

#include <algorithm>
#include <set>

#include <quadmatch/shapes/renumber.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

Tracing trace(const Mesh& mesh) { return trace_skeleton(mesh, vertex_codes(mesh)); }

/// The edges of an arc, from its spoke on.
std::vector<Dart> run_of(const Mesh& mesh, const Spoke& spoke) {
  std::vector<Dart> run{spoke.start};
  while (run.size() < spoke.length) run.push_back(straight_ahead(mesh, run.back()));
  return run;
}

/// Every arc can be walked from either end, and leads where it says.
void check_arcs(const Mesh& mesh, const ArcGraph& graph) {
  REQUIRE(graph.first_spoke.size() == graph.nodes.size() + 1);
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    for (std::uint32_t number = graph.first_spoke[node]; number < graph.first_spoke[node + 1]; ++number) {
      const Spoke& spoke = graph.spokes[number];
      CAPTURE(node);
      CAPTURE(number);
      REQUIRE(spoke.length >= 1);
      CHECK(tail_of(mesh, spoke.start) == mesh.vertex(graph.nodes[node]));
      const std::vector<Dart> run = run_of(mesh, spoke);
      if (spoke.to_node == Spoke::kNone) {
        CHECK(spoke.to_spoke == Spoke::kNone);
        CHECK_FALSE(straight_ahead(mesh, run.back()).halfedge.valid());
        continue;
      }
      CHECK(head_of(mesh, run.back()) == mesh.vertex(graph.nodes[spoke.to_node]));
      const Spoke& back = graph.spokes[spoke.to_spoke];
      CHECK(back.to_node == node);
      CHECK(back.to_spoke == number);
      CHECK(back.length == spoke.length);
      CHECK(mesh.edge(back.start.halfedge) == mesh.edge(run.back().halfedge));
    }
  }
}

TEST_CASE("§4.3: every arc of both graphs leads straight from node to node, and back again") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const Tracing tracing = trace(mesh);
    check_arcs(mesh, tracing.skeleton);
    check_arcs(mesh, tracing.separatrices);
  }
}

TEST_CASE("§4.3: the skeleton is made of exactly the edges that a particle from an extraordinary vertex goes along") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const Tracing tracing = trace(mesh);
    std::multiset<EdgeId> skeleton, separatrices;
    for (const Spoke& spoke : tracing.skeleton.spokes) {
      for (const Dart dart : run_of(mesh, spoke)) skeleton.insert(mesh.edge(dart.halfedge));
    }
    for (const Spoke& spoke : tracing.separatrices.spokes) {
      for (const Dart dart : run_of(mesh, spoke)) {
        separatrices.insert(mesh.edge(dart.halfedge));
        // A trace that ends at the boundary has one end only.
        if (spoke.to_node == Spoke::kNone) separatrices.insert(mesh.edge(dart.halfedge));
      }
    }
    CHECK(skeleton == separatrices);
    for (const EdgeId edge : skeleton) CHECK(skeleton.count(edge) == 2);  // once from either end
  }
}

TEST_CASE("§4.3: in the skeleton every particle rests at a node, in the separatrix graph only at extraordinary ones") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const PerFan<VertexCode> codes = vertex_codes(mesh);
    const Tracing tracing = trace_skeleton(mesh, codes);
    for (const Spoke& spoke : tracing.skeleton.spokes) CHECK(spoke.to_node != Spoke::kNone);
    for (const FanId node : tracing.separatrices.nodes) CHECK(codes[node].extraordinary());
    const auto extraordinary =
        std::count_if(codes.begin(), codes.end(), [](VertexCode code) { return code.extraordinary(); });
    CHECK(tracing.separatrices.node_count() == extraordinary);
  }
}

TEST_CASE("the skeleton of a grid is its four corners and four sides") {
  const Mesh grid = test::build(shapes::grid(7, 5));
  const Tracing tracing = trace(grid);
  CHECK(tracing.skeleton.node_count() == 4);
  CHECK(tracing.skeleton.arc_count() == 4);
  std::multiset<std::uint32_t> lengths;
  for (const Spoke& spoke : tracing.skeleton.spokes) lengths.insert(spoke.length);
  CHECK(lengths == std::multiset<std::uint32_t>{5, 5, 5, 5, 7, 7, 7, 7});
}

TEST_CASE("§5: refinement does not change the skeleton of a cube, only its lengths") {
  for (const std::uint32_t k : {1U, 2U, 7U}) {
    const Mesh cube = test::build(shapes::cube_subdivided(k));
    const Tracing tracing = trace(cube);
    CHECK(tracing.skeleton.node_count() == 8);
    CHECK(tracing.skeleton.arc_count() == 12);
    for (const Spoke& spoke : tracing.skeleton.spokes) CHECK(spoke.length == k);
  }
}

TEST_CASE("§4.1: a regular torus or tube has no extraordinary vertex, and so no skeleton") {
  for (const PolygonSoup& soup : {shapes::torus(6, 5), shapes::cylinder(6, 4)}) {
    const Tracing tracing = trace(test::build(soup));
    CHECK(tracing.skeleton.node_count() == 0);
    CHECK(tracing.skeleton.arc_count() == 0);
    CHECK(tracing.skeleton.first_spoke == std::vector<std::uint32_t>{0});
  }
}

TEST_CASE(
    "a crossing is a node of the skeleton and not of the separatrix graph; so is where the boundary stops a particle") {
  // Six petals of 3 by 3: vertex 0 has valence 6, and its particles run into the boundary.
  const Mesh star = test::build(shapes::star(6, 3));
  const Tracing tracing = trace(star);
  CHECK(tracing.separatrices.node_count() == 1 + 6);  // the middle, and a corner of each petal
  const std::span<const Spoke> middle = tracing.separatrices.spokes_of(0);
  CHECK(middle.size() == 6);
  for (const Spoke& spoke : middle) {
    CHECK(spoke.to_node == Spoke::kNone);
    CHECK(spoke.length == 3);
  }
  CHECK(tracing.skeleton.node_count() == 1 + 6 + 6);  // and where the six particles hit the rim
}

TEST_CASE("Table 5.1: the sizes of both graphs do not depend on the numbering") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Tracing tracing = trace(test::build(soup));
    const Tracing shuffled = trace(test::build(shapes::renumbered(soup, 11).soup));
    CHECK(tracing.skeleton.node_count() == shuffled.skeleton.node_count());
    CHECK(tracing.skeleton.arc_count() == shuffled.skeleton.arc_count());
    CHECK(tracing.separatrices.node_count() == shuffled.separatrices.node_count());
    CHECK(tracing.separatrices.arc_count() == shuffled.separatrices.arc_count());
  }
}

}  // namespace
}  // namespace quadmatch
