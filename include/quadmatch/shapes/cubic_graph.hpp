#pragma once
/// Cubic planar graphs, from which §3 makes meshes: named ones, Hamiltonian cycles, and drawings on the integer grid.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::shapes {

struct CubicGraph {
  /// Vertices are 0 ... vertex_count - 1.
  std::uint32_t vertex_count = 0;
  /// 3/2 vertex_count of them, each between two different vertices, no two between the same.
  std::vector<std::array<std::uint32_t, 2>> edges = {};
};

struct NamedGraph {
  std::string name;
  CubicGraph graph;
};

/// From the smallest. Hamiltonian: k4, prism (3-sided), cube, truncated-tetrahedron, dodecahedron. Not: bridged (10
/// vertices, two halves joined by one edge), three-branches (14, no bridge: two vertices joined by three branches, of
/// which a cycle can take two), tutte (46, 3-connected).
[[nodiscard]] std::vector<NamedGraph> named_cubic_graphs();

/// The graph of that name. @par Errors  BadArgument where there is none, listing those there are.
[[nodiscard]] Expected<CubicGraph> named_cubic_graph(const std::string& name);

/// Is it simple, connected, and has every vertex three edges? @par Errors  BadArgument, naming what is not so.
[[nodiscard]] Expected<void> check_cubic(const CubicGraph& graph);

/// A cycle that visits every vertex once, as vertices in order, the first being 0; none where there is none.
/// @pre      check_cubic(graph)
/// @par Cost exponential: the problem is NP-complete. Paths are given up where a vertex can no longer be passed
/// through;
///           Tutte's graph of 46 vertices takes a fraction of a second.
[[nodiscard]] std::optional<std::vector<std::uint32_t>> hamiltonian_cycle(const CubicGraph& graph);

/// A point of the integer grid.
using GridPoint = std::array<std::int64_t, 2>;

/// Draw the graph with straight edges that do not cross, every vertex at a point of a (2n - 4) by (n - 2) grid: the
/// paper's "any existing polynomial-time method". Ours is Boost.Graph's: planarity by Boyer and Myrvold, drawing by
/// Chrobak and Payne (after de Fraysseix, Pach and Pollack, the paper's reference 12).
/// @return      a point for each vertex.
/// @par Errors  BadArgument where the graph is not cubic (see check_cubic), or not planar.
[[nodiscard]] Expected<std::vector<GridPoint>> planar_drawing(const CubicGraph& graph);

}  // namespace quadmatch::shapes
