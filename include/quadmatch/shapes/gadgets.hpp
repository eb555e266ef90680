#pragma once
/// The meshes of Theorem 3.1, which asks of a matcher whether a cubic planar graph is Hamiltonian.
///
/// Fig. 3.1 draws the vertex gadgets and is all that says what they are; we have its caption only. What the text says
/// of them leaves room for those below. Proofs and the roads not taken: docs/design/013-hardness.md.

#include <array>
#include <cstdint>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>
#include <quadmatch/shapes/cubic_graph.hpp>

namespace quadmatch::shapes {

/// For which definition of a match the gadgets are made.
enum class Gadgets {
  /// Ours, which keeps corners as well (see verify): a vertex of the graph becomes a ring of six quads.
  Corners,
  /// §3 to the letter, which speaks of faces and adjacency only: a vertex of the graph becomes three quads around a
  /// vertex. Every claim of the proof holds of them as it is written, but no cycle is ever matched corner on corner.
  Adjacency,
};

/// M1: a cycle of n vertices, each expanded to four quads, and n edges, each to a chain of four; 8n quads.
///
/// The four quads a, x, y, b of a vertex fill a hexagon: x and y have an edge in common, whose ends are two inner
/// vertices of valence 3; about one lie a, x, y, about the other b, y, x. So a cycle may do without x, passing on one
/// side, or without y, passing on the other. Chains come to a and leave from b ("in the lower-right part", "in the
/// upper-left part"); with Gadgets::Adjacency they come to x and leave from y, and a cycle may do without a or b.
///
/// Face 8j + 0 ... 3 are a, x, y, b of vertex j, 8j + 4 ... 7 the chain to vertex j + 1. Drawn around a circle, so that
/// everything is counter-clockwise from above.
/// @pre n >= 3
[[nodiscard]] PolygonSoup cycle_mesh(std::uint32_t n, Gadgets gadgets = Gadgets::Corners);

struct CubicGraphMesh {
  PolygonSoup soup;
  /// For each vertex of the graph its edges (numbers in CubicGraph::edges), counter-clockwise as drawn.
  std::vector<std::array<std::uint32_t, 3>> turns;
};

/// M2: a cubic planar graph of n vertices, each edge expanded to a chain of four quads and each vertex to a ring of six
/// about a triangular hole: ports, one for each edge, and between every two ports a link. All rings are alike, and may
/// be turned by a third: from the chain, a port goes straight on to the link before it and turns to the one behind it.
/// 6n + 4 (3n/2) = 12n quads. With Gadgets::Adjacency three quads about a vertex instead of six: 9n.
///
/// The faces of vertex v are consecutive, ports and links in turn, in the order of `turns`; behind those of all
/// vertices the chains, each from its edge's first vertex to the second. Drawn along planar_drawing, without overlaps.
/// @par Errors  as of planar_drawing.
[[nodiscard]] Expected<CubicGraphMesh> cubic_graph_mesh(const CubicGraph& graph, Gadgets gadgets = Gadgets::Corners);

/// Theorem 3.1, "suppose that G is Hamiltonian": M1 = cycle_mesh(n) laid on M2 = mesh along a Hamiltonian cycle.
/// @param cycle  all vertices in order (see hamiltonian_cycle).
/// @return       7n pairs, one orientation-preserving region. With Gadgets::Corners it is sound (see verify). With
///               Gadgets::Adjacency adjacency is kept both ways, but corners do not fit: rotations are all 0.
/// @pre          mesh = cubic_graph_mesh(graph, gadgets), of n >= 3 vertices; the cycle is one of the graph's
[[nodiscard]] std::vector<FacePair> match_along(const std::vector<std::uint32_t>& cycle, const CubicGraph& graph,
                                                const CubicGraphMesh& mesh, Gadgets gadgets = Gadgets::Corners);

}  // namespace quadmatch::shapes
