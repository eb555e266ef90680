// check, skeleton and connectivity_hash: reports as plain values, graphs as arrays.

#include <cstdint>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <quadmatch/analysis/connectivity_hash.hpp>
#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/mesh/check.hpp>

#include "arrays.hpp"
#include "bindings.hpp"

namespace quadmatch::python {
namespace {

py::dict as_dict(const ComponentReport& component) {
  return py::dict(py::arg("vertices") = component.vertices, py::arg("edges") = component.edges,
                  py::arg("faces") = component.faces, py::arg("boundary_loops") = component.boundary_loops,
                  py::arg("extraordinary") = component.extraordinary, py::arg("manifold") = component.manifold,
                  py::arg("orientable") = component.orientable, py::arg("euler") = component.euler,
                  py::arg("genus") = component.genus);
}

py::dict checked(const MeshHandle& mesh, std::size_t kept) {
  CheckReport report;
  {
    const py::gil_scoped_release released;
    report = check(mesh->mesh, kept);
  }
  py::list components, departures;
  for (const ComponentReport& component : report.components) components.append(as_dict(component));
  for (const Departure& departure : report.departures) {
    departures.append(py::make_tuple(to_string(departure.kind), departure.message));
  }
  py::dict counts;
  for (std::size_t kind = 0; kind < report.departure_counts.size(); ++kind) {
    const std::size_t count = report.departure_counts[kind];
    if (count > 0) counts[to_string(static_cast<DepartureKind>(kind))] = count;
  }
  return py::dict(py::arg("well_formed") = report.well_formed(), py::arg("vertices") = report.vertices,
                  py::arg("edges") = report.edges, py::arg("faces") = report.faces,
                  py::arg("triangles") = report.triangles, py::arg("quads") = report.quads,
                  py::arg("larger") = report.larger, py::arg("boundary_loops") = report.boundary_loops,
                  py::arg("extraordinary") = report.extraordinary, py::arg("components") = components,
                  py::arg("departure_counts") = counts, py::arg("departures") = departures);
}

/// Walk from a spoke to where its arc ends.
void follow(const Mesh& mesh, const Spoke& spoke, std::vector<std::int32_t>& vertices) {
  Dart dart = spoke.start;
  vertices.push_back(static_cast<std::int32_t>(tail_of(mesh, dart).value));
  for (std::uint32_t step = 0; step < spoke.length; ++step) {
    if (step > 0) dart = straight_ahead(mesh, dart);
    vertices.push_back(static_cast<std::int32_t>(head_of(mesh, dart).value));
  }
}

/// An arc with two ends is told from the lower of its spokes.
bool is_told_here(const ArcGraph& graph, std::uint32_t spoke) {
  const std::uint32_t back = graph.spokes[spoke].to_spoke;
  return back == Spoke::kNone || spoke <= back;
}

/// Nodes by vertex; arcs as pairs of nodes (-1: the boundary); and the vertices along each arc.
py::dict traced(const MeshHandle& mesh, bool separatrices) {
  std::vector<std::int32_t> nodes, arcs, path_offsets{0}, path;
  {
    const py::gil_scoped_release released;
    const Tracing tracing = trace_skeleton(mesh->mesh, vertex_codes(mesh->mesh));
    const ArcGraph& graph = separatrices ? tracing.separatrices : tracing.skeleton;
    for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
      nodes.push_back(static_cast<std::int32_t>(mesh->mesh.vertex(graph.nodes[node]).value));
      for (std::uint32_t spoke = graph.first_spoke[node]; spoke < graph.first_spoke[node + 1]; ++spoke) {
        if (!is_told_here(graph, spoke)) continue;
        const Spoke& here = graph.spokes[spoke];
        arcs.push_back(static_cast<std::int32_t>(node));
        arcs.push_back(static_cast<std::int32_t>(here.to_node));
        follow(mesh->mesh, here, path);
        path_offsets.push_back(static_cast<std::int32_t>(path.size()));
      }
    }
  }
  return py::dict(py::arg("nodes") = owned(std::move(nodes)),
                  py::arg("arcs") = owned(std::move(arcs)).attr("reshape")(-1, 2),
                  py::arg("path_offsets") = owned(std::move(path_offsets)), py::arg("paths") = owned(std::move(path)));
}

std::pair<std::string, std::string> hashed(const MeshHandle& mesh) {
  const py::gil_scoped_release released;
  const ConnectivityHash hash = connectivity_hash(mesh->mesh);
  return {hash.oriented.hex(), hash.unoriented().hex()};
}

}  // namespace

void bind_analysis(py::module_& module) {
  module.def("check", &checked, py::arg("mesh"), py::arg("kept"));
  module.def("skeleton", &traced, py::arg("mesh"), py::arg("separatrices"));
  module.def("connectivity_hash", &hashed, py::arg("mesh"));
}

}  // namespace quadmatch::python
