#pragma once
/// Particle shooting (§4.3): one tracing that yields the skeleton graph and the separatrix graph.

#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// A half-edge with a direction of travel; `backward` (tip to origin) occurs on boundary half-edges only, whose
/// other direction has no half-edge of its own.
struct Dart {
  HalfedgeId halfedge;
  bool backward = false;

  bool operator==(const Dart&) const = default;
};

/// One end of an arc, as seen from the node it leaves.
struct Spoke {
  static constexpr std::uint32_t kNone = 0xffffffff;

  Dart start;  ///< first edge of the arc, leaving the node
  /// Node at the other end; kNone where the particle ran into the boundary, which is in the separatrix graph only.
  std::uint32_t to_node = kNone;
  std::uint32_t to_spoke = kNone;  ///< the spoke there that leads back
  std::uint32_t length = 0;        ///< edges, at least 1
};

/// Nodes at fans of a mesh, joined by arcs that run along its edges. The spokes of a node stand in counter-clockwise
/// order: cyclic at an inner node, from the clockwise-most on at a boundary one (the rotation system).
struct ArcGraph {
  std::vector<FanId> nodes;
  std::vector<std::uint32_t> first_spoke;  ///< #nodes + 1 offsets into `spokes`
  std::vector<Spoke> spokes;

  [[nodiscard]] std::uint32_t node_count() const { return static_cast<std::uint32_t>(nodes.size()); }
  /// Arcs; one that ran into the boundary counts as well.
  [[nodiscard]] std::uint32_t arc_count() const;
  [[nodiscard]] std::span<const Spoke> spokes_of(std::uint32_t node) const {
    return std::span(spokes).subspan(first_spoke[node], first_spoke[node + 1] - first_spoke[node]);
  }
};

/// Both graphs of one tracing.
struct Tracing {
  /// Nodes: extraordinary vertices, crossings of two traces, and where a particle ran into the boundary. The paper's.
  ArcGraph skeleton;
  /// Nodes: extraordinary vertices only; arcs pass straight through crossings. The better graph for anchors, since a
  /// new extraordinary vertex puts no crossings into far-away neighbourhoods of it.
  ArcGraph separatrices;
};

/// Trace a mesh by particle shooting (§4.3).
/// From each extraordinary vertex a particle leaves along every edge, goes straight through regular vertices, and
/// rests at an extraordinary vertex or where it runs into the boundary.
///
/// @param mesh   V vertices, E edges, F faces; any genus, any number of components.
/// @param codes  vertex_codes(mesh).
/// @return       both graphs, empty when no vertex is extraordinary, e.g. on a regular torus.
/// @par Cost     O(E) time and memory: an edge is walked at most once in each direction, and once for each graph.
/// @par Reading  §4.3 does not say what a crossing of two traces is; we make it a node, as Table 5.1's sizes ask.
[[nodiscard]] Tracing trace_skeleton(const Mesh& mesh, const PerFan<VertexCode>& codes);

/// The separatrix graph alone: the same as trace_skeleton(mesh, codes).separatrices, in half the time.
[[nodiscard]] ArcGraph trace_separatrices(const Mesh& mesh, const PerFan<VertexCode>& codes);

/// The next edge straight ahead through a regular vertex; not valid where the boundary stops the particle.
/// @pre the vertex ahead is regular.
[[nodiscard]] Dart straight_ahead(const Mesh& mesh, Dart dart);

/// The vertex a dart leaves, and the one it arrives at.
[[nodiscard]] VertexId tail_of(const Mesh& mesh, Dart dart);
[[nodiscard]] VertexId head_of(const Mesh& mesh, Dart dart);

}  // namespace quadmatch
