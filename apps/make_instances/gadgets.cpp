// Theorem 3.1: a cycle's mesh and a cubic planar graph's.

#include <fmt/format.h>

#include <quadmatch/shapes/gadgets.hpp>

#include "instances.hpp"
#include "pair_files.hpp"

namespace quadmatch {
namespace {

using shapes::Gadgets;

Expected<void> make_one(const shapes::NamedGraph& named, const GadgetArguments& arguments) {
  const Gadgets gadgets = arguments.adjacency ? Gadgets::Adjacency : Gadgets::Corners;
  const std::uint32_t n = named.graph.vertex_count;
  const Expected<shapes::CubicGraphMesh> mesh = shapes::cubic_graph_mesh(named.graph, gadgets);
  if (!mesh) return Unexpected(mesh.error());
  const auto cycle = shapes::hamiltonian_cycle(named.graph);
  Pair pair{.source = shapes::cycle_mesh(n, gadgets), .target = mesh->soup, .region = {}};
  if (cycle && !arguments.adjacency) pair.region = shapes::match_along(*cycle, named.graph, *mesh);
  fmt::print("{{\"name\": \"{}\", \"n\": {}, \"hamiltonian\": {}, \"source\": {}, \"target\": {}, \"asked\": {}}}\n",
             named.name, n, cycle.has_value(), pair.source.corners.size() / 4, pair.target.corners.size() / 4, 7 * n);
  return write_pair(arguments.folder, named.name, pair);
}

}  // namespace

Expected<void> make_gadgets(const GadgetArguments& arguments) {
  if (arguments.graphs.empty()) {
    for (const shapes::NamedGraph& named : shapes::named_cubic_graphs()) {
      if (Expected<void> made = make_one(named, arguments); !made) return made;
    }
  }
  for (const std::string& name : arguments.graphs) {
    const Expected<shapes::CubicGraph> graph = shapes::named_cubic_graph(name);
    if (!graph) return Unexpected(graph.error());
    if (Expected<void> made = make_one({name, *graph}, arguments); !made) return made;
  }
  return {};
}

}  // namespace quadmatch
