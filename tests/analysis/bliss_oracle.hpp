#pragma once
/// What bliss says of a mesh: a graph canoniser that knows nothing of half-edges, told of a mesh in vertices and edges.

#include <cstdint>
#include <memory>

#include <bliss/graph.hh>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::test {

/// A graph whose automorphisms are those of the mesh. Every corner is two nodes, one for each way round: `a` looks back
/// along its face and `b` ahead. All `a` hang together at one hub and all `b` at another. If the hubs may change
/// places, either all faces are turned over or none.
inline bliss::Graph graph_of(const Mesh& mesh, bool hubs_are_alike) {
  enum Kind : unsigned { kCorner, kVertex, kHub, kOtherHub };
  bliss::Graph graph;
  graph.set_component_recursion(false);  // it leaks
  const unsigned corners = mesh.halfedge_count();
  for (unsigned node = 0; node < 2 * corners; ++node) graph.add_vertex(kCorner);
  const unsigned hub = graph.add_vertex(kHub);
  const unsigned other_hub = graph.add_vertex(hubs_are_alike ? kHub : kOtherHub);
  PerVertex<unsigned> node_of(mesh.vertex_count(), VertexId::kNone);
  for (unsigned h = 0; h < corners; ++h) {
    const unsigned a = 2 * h, b = 2 * h + 1;
    unsigned& vertex = node_of[mesh.origin(HalfedgeId(h))];
    if (vertex == VertexId::kNone) vertex = graph.add_vertex(kVertex);
    graph.add_edge(a, b);
    graph.add_edge(b, 2 * mesh.next(HalfedgeId(h)).value);
    graph.add_edge(a, vertex);
    graph.add_edge(b, vertex);
    graph.add_edge(a, hub);
    graph.add_edge(b, other_hub);
  }
  return graph;
}

/// @pre the mesh has a face.
inline long double automorphisms_by_bliss(const Mesh& mesh, bool with_reversing) {
  bliss::Graph graph = graph_of(mesh, with_reversing);
  bliss::Stats stats;
  graph.find_automorphisms(stats, nullptr, nullptr);
  return stats.get_group_size_approx();
}

/// Unused vertices are no nodes; they are equally many where all vertices are, and the nodes.
inline bool same_by_bliss(const Mesh& one, const Mesh& other, bool or_reversing) {
  if (one.vertex_count() != other.vertex_count()) return false;
  bliss::Graph left = graph_of(one, or_reversing), right = graph_of(other, or_reversing);
  if (left.get_nof_vertices() != right.get_nof_vertices()) return false;
  bliss::Stats stats;
  const std::unique_ptr<bliss::Graph> first(left.permute(left.canonical_form(stats, nullptr, nullptr)));
  const std::unique_ptr<bliss::Graph> second(right.permute(right.canonical_form(stats, nullptr, nullptr)));
  return first->cmp(*second) == 0;
}

}  // namespace quadmatch::test
