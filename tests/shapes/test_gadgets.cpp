// Theorem 3.1: the meshes that a cubic planar graph becomes, before anything is matched.

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <quadmatch/mesh/check.hpp>
#include <quadmatch/shapes/gadgets.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::faces_of;
using quadmatch::testing::Topology;
using quadmatch::testing::topology_of;
using shapes::CubicGraph;
using shapes::Gadgets;

namespace {

double area_twice(const Point& a, const Point& b, const Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return area_twice(a, b, c) * area_twice(a, b, d) < 0 && area_twice(c, d, a) * area_twice(c, d, b) < 0;
}

/// Edges of the mesh that cross another as it is drawn, and faces that are not drawn counter-clockwise.
std::size_t overlaps(const PolygonSoup& soup) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::size_t wrong = 0;
  for (const auto& face : faces_of(soup)) {
    double area = 0;
    for (std::size_t k = 0; k < face.size(); ++k) {
      edges.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
      area += area_twice({0, 0, 0}, soup.positions[face[k]], soup.positions[face[(k + 1) % face.size()]]);
    }
    wrong += area <= 0;
  }
  for (const auto& e : edges) {
    for (const auto& f : edges) {
      const auto& p = soup.positions;
      wrong += e < f && cross(p[e.first], p[e.second], p[f.first], p[f.second]);
    }
  }
  return wrong;
}

bool well_formed(const PolygonSoup& soup) {
  const Expected<Mesh> mesh = Mesh::build(soup);
  return mesh.has_value() && check(*mesh).well_formed() && check(*mesh).components.size() == 1;
}

}  // namespace

TEST_CASE("every named graph is cubic and drawn on the integer grid without crossings") {
  for (const auto& [name, graph] : shapes::named_cubic_graphs()) {
    INFO(name);
    CHECK(shapes::check_cubic(graph).has_value());
    const Expected<std::vector<shapes::GridPoint>> drawing = shapes::planar_drawing(graph);
    REQUIRE(drawing.has_value());
    const auto n = static_cast<std::int64_t>(graph.vertex_count);
    const auto at = [&](std::uint32_t v) {
      return Point{static_cast<double>((*drawing)[v][0]), static_cast<double>((*drawing)[v][1]), 0};
    };
    std::set<shapes::GridPoint> places(drawing->begin(), drawing->end());
    CHECK(places.size() == graph.vertex_count);
    for (const shapes::GridPoint& place : places) {
      CHECK(std::min(place[0], place[1]) >= 0);
      CHECK(place[0] <= 2 * n - 4);
      CHECK(place[1] <= n - 2);
    }
    for (const auto& e : graph.edges) {
      for (const auto& f : graph.edges) CHECK_FALSE(cross(at(e[0]), at(e[1]), at(f[0]), at(f[1])));
    }
  }
}

TEST_CASE("a Hamiltonian cycle is found in those named graphs that have one, and in no other") {
  const std::set<std::string> without = {"bridged", "three-branches", "tutte"};
  for (const auto& [name, graph] : shapes::named_cubic_graphs()) {
    INFO(name);
    const auto cycle = shapes::hamiltonian_cycle(graph);
    CHECK(cycle.has_value() == (without.count(name) == 0));
    if (!cycle) continue;
    CHECK(std::set<std::uint32_t>(cycle->begin(), cycle->end()).size() == graph.vertex_count);
    for (std::size_t k = 0; k < cycle->size(); ++k) {
      const auto ends = std::minmax((*cycle)[k], (*cycle)[(k + 1) % cycle->size()]);
      CHECK(std::any_of(graph.edges.begin(), graph.edges.end(),
                        [&](const auto& e) { return std::minmax(e[0], e[1]) == ends; }));
    }
  }
}

TEST_CASE("what is not a simple, connected, cubic, planar graph is refused, and the message says why") {
  const auto reason = [](const CubicGraph& graph) {
    const auto mesh = shapes::cubic_graph_mesh(graph);
    return mesh ? std::string() : mesh.error().message;
  };
  CubicGraph graph = *shapes::named_cubic_graph("k4");
  CHECK(reason(graph).empty());
  graph.edges.pop_back();
  CHECK(reason(graph).find("has 2 edges, not three") != std::string::npos);
  graph.edges.push_back(graph.edges.front());
  CHECK(reason(graph).find("is there twice") != std::string::npos);
  graph.edges.back() = {1, 1};
  CHECK(reason(graph) == "the edge between 1 and 1 is a loop");
  graph.edges.back() = {1, 7};
  CHECK(reason(graph) == "the edge between 1 and 7 names a vertex that does not exist");

  CubicGraph twice = *shapes::named_cubic_graph("k4");
  for (std::size_t e = 0; e < 6; ++e) twice.edges.push_back({twice.edges[e][0] + 4, twice.edges[e][1] + 4});
  twice.vertex_count = 8;
  CHECK(reason(twice) == "the graph is not connected");

  CubicGraph utilities{.vertex_count = 6};
  for (std::uint32_t a = 0; a < 3; ++a) {
    for (std::uint32_t b = 3; b < 6; ++b) utilities.edges.push_back({a, b});
  }
  CHECK(reason(utilities) == "the graph is not planar: it cannot be drawn without crossings");
  CHECK(shapes::named_cubic_graph("petersen").error().message.find("there are k4, prism") != std::string::npos);
}

TEST_CASE("Theorem 3.1: M1 has 8n quads, is a simple and well-formed ring, and is drawn without overlaps") {
  for (const Gadgets gadgets : {Gadgets::Corners, Gadgets::Adjacency}) {
    for (const std::uint32_t n : {3U, 4U, 10U, 46U}) {
      const PolygonSoup soup = shapes::cycle_mesh(n, gadgets);
      const Topology topology = topology_of(soup);
      CHECK(topology.faces == 8 * n);
      CHECK(topology.boundary_loops == 2);
      CHECK(topology.genus() == 0);
      CHECK(topology.inner_valences == std::map<std::uint32_t, std::uint32_t>{{3, 2 * n}});
      CHECK(well_formed(soup));
      CHECK(overlaps(soup) == 0);
    }
  }
}

TEST_CASE("Theorem 3.1: M2 is simple and well-formed, and is drawn without overlaps") {
  for (const auto& [name, graph] : shapes::named_cubic_graphs()) {
    INFO(name);
    const std::uint32_t n = graph.vertex_count;
    const auto corners = shapes::cubic_graph_mesh(graph, Gadgets::Corners);
    REQUIRE(corners.has_value());
    CHECK(topology_of(corners->soup).faces == 12 * n);
    // A hole in each ring, and one in each of the n / 2 + 2 faces of the graph.
    CHECK(topology_of(corners->soup).boundary_loops == n + n / 2 + 2);
    CHECK(topology_of(corners->soup).inner_valences.empty());
    CHECK(well_formed(corners->soup));
    CHECK(overlaps(corners->soup) == 0);

    const auto adjacency = shapes::cubic_graph_mesh(graph, Gadgets::Adjacency);
    REQUIRE(adjacency.has_value());
    CHECK(topology_of(adjacency->soup).faces == 9 * n);
    CHECK(topology_of(adjacency->soup).boundary_loops == n / 2 + 2);
    CHECK(topology_of(adjacency->soup).inner_valences == std::map<std::uint32_t, std::uint32_t>{{3, n}});
    CHECK(well_formed(adjacency->soup));
    CHECK(overlaps(adjacency->soup) == 0);
  }
}
