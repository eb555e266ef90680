// Particle shooting, §4.3: one tracing, two graphs.
//
// The separatrix graph comes first: every particle is followed from its extraordinary vertex to where it rests. On the
// way it counts, at each regular vertex, how many traces pass. A second walk along the same traces then cuts them at
// the vertices where two of them cross or one of them ran into the boundary: that is the skeleton graph.

#include <quadmatch/analysis/skeleton.hpp>

#include <algorithm>

namespace quadmatch {
namespace {

constexpr std::uint32_t kNone = Spoke::kNone;

FanId fan_ahead(const Mesh& mesh, Dart dart) {
  return mesh.fan(dart.backward ? dart.halfedge : mesh.next(dart.halfedge));
}

/// The same edge, travelled the other way.
Dart turned_back(const Mesh& mesh, Dart dart) {
  const HalfedgeId other = mesh.twin(dart.halfedge);
  return other.valid() ? Dart{other, false} : Dart{dart.halfedge, !dart.backward};
}

/// All edges that leave a fan, counter-clockwise: one dart per face, and the last edge of a boundary fan.
template <class Visit>
void for_each_leaving_dart(const Mesh& mesh, FanId fan, Visit visit) {
  HalfedgeId last;
  for (const HalfedgeId h : mesh.outgoing(fan)) {
    visit(Dart{h, false});
    last = h;
  }
  if (mesh.is_boundary(fan)) visit(Dart{mesh.prev(last), true});
}

/// Finds the spoke that leaves a node along a dart.
class SpokeIndex {
 public:
  explicit SpokeIndex(const Mesh& mesh) : of_halfedge_(mesh.halfedge_count(), kNone) {}

  /// A boundary half-edge is the start of two darts; the backward one is kept in a list of its own.
  void add(Dart dart, std::uint32_t spoke) {
    if (dart.backward) {
      backward_.push_back({dart.halfedge, spoke});
    } else {
      of_halfedge_[dart.halfedge] = spoke;
    }
  }
  void finish() { std::sort(backward_.begin(), backward_.end()); }
  [[nodiscard]] std::uint32_t find(Dart dart) const {
    if (!dart.backward) return of_halfedge_[dart.halfedge];
    const auto place = std::lower_bound(backward_.begin(), backward_.end(), std::pair(dart.halfedge, 0U));
    return place != backward_.end() && place->first == dart.halfedge ? place->second : kNone;
  }

 private:
  PerHalfedge<std::uint32_t> of_halfedge_;
  std::vector<std::pair<HalfedgeId, std::uint32_t>> backward_;
};

/// Where a particle comes to rest: its last step, and how many edges it went.
struct Rest {
  Dart last;
  std::uint32_t length;
  bool at_node;
};

/// Follow a particle until `is_node` says that the vertex ahead is one, or the boundary stops it.
template <class IsNode, class Pass>
Rest follow(const Mesh& mesh, Dart dart, IsNode is_node, Pass pass) {
  for (std::uint32_t length = 1;; ++length) {
    const FanId ahead = fan_ahead(mesh, dart);
    if (is_node(ahead)) return {dart, length, true};
    const Dart next = straight_ahead(mesh, dart);
    if (!next.halfedge.valid()) return {dart, length, false};
    pass(ahead);
    dart = next;
  }
}

void join(ArcGraph& graph, std::uint32_t node, std::uint32_t spoke, std::uint32_t to_node, std::uint32_t to_spoke,
          std::uint32_t length) {
  Spoke& here = graph.spokes[spoke];
  here.to_node = to_node;
  here.to_spoke = to_spoke;
  here.length = length;
  if (to_spoke == kNone) return;
  Spoke& there = graph.spokes[to_spoke];
  there.to_node = node;
  there.to_spoke = spoke;
  there.length = length;
}

/// A graph of nodes with their spokes, not yet joined. `leaves(dart)` says which edges are traced.
template <class Leaves>
ArcGraph graph_of_nodes(const Mesh& mesh, std::vector<FanId> nodes, SpokeIndex& index, Leaves leaves) {
  ArcGraph graph;
  graph.nodes = std::move(nodes);
  graph.first_spoke.reserve(graph.nodes.size() + 1);
  graph.first_spoke.push_back(0);
  for (const FanId node : graph.nodes) {
    for_each_leaving_dart(mesh, node, [&](Dart dart) {
      if (!leaves(dart)) return;
      index.add(dart, static_cast<std::uint32_t>(graph.spokes.size()));
      graph.spokes.push_back({.start = dart});
    });
    graph.first_spoke.push_back(static_cast<std::uint32_t>(graph.spokes.size()));
  }
  index.finish();
  return graph;
}

/// The node that owns each spoke.
std::vector<std::uint32_t> owners(const ArcGraph& graph) {
  std::vector<std::uint32_t> owner(graph.spokes.size());
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    std::fill(owner.begin() + graph.first_spoke[node], owner.begin() + graph.first_spoke[node + 1], node);
  }
  return owner;
}

/// Join every spoke to the one in which its particle comes to rest; both ends at once, so each arc is walked once.
template <class IsNode, class Pass, class Stop>
void shoot(const Mesh& mesh, ArcGraph& graph, const SpokeIndex& index, IsNode is_node, Pass pass, Stop stop) {
  const std::vector<std::uint32_t> owner = owners(graph);
  for (std::uint32_t spoke = 0; spoke < graph.spokes.size(); ++spoke) {
    if (graph.spokes[spoke].length != 0) continue;
    const Rest rest = follow(mesh, graph.spokes[spoke].start, is_node, pass);
    if (rest.at_node) {
      const std::uint32_t to_spoke = index.find(turned_back(mesh, rest.last));
      join(graph, owner[spoke], spoke, owner[to_spoke], to_spoke, rest.length);
    } else {
      join(graph, owner[spoke], spoke, kNone, kNone, rest.length);
      stop(fan_ahead(mesh, rest.last));
    }
  }
}

/// What the traces did at a vertex that is not extraordinary.
class Traffic {
 public:
  explicit Traffic(const Mesh& mesh) : passes_(mesh.fan_count(), 0), stopped_(mesh.fan_count(), false) {}

  void pass(FanId fan) {
    if (passes_[fan]++ == 1) crossings_.push_back(fan);
  }
  void stop(FanId fan) {
    if (!stopped_[fan]) stops_.push_back(fan);
    stopped_[fan] = true;
  }
  [[nodiscard]] bool is_node(FanId fan) const { return passes_[fan] > 1 || stopped_[fan]; }
  /// Crossings and stops, ascending.
  [[nodiscard]] std::vector<FanId> nodes() const {
    std::vector<FanId> all = stops_;
    for (const FanId fan : crossings_) {
      if (!stopped_[fan]) all.push_back(fan);
    }
    std::sort(all.begin(), all.end());
    return all;
  }

 private:
  PerFan<std::uint8_t> passes_;  // a regular vertex lets at most two straight lines through
  PerFan<bool> stopped_;
  std::vector<FanId> crossings_, stops_;
};

/// The edges along which particles went.
class TracedEdges {
 public:
  explicit TracedEdges(const Mesh& mesh) : mesh_(&mesh), traced_(mesh.halfedge_count(), false) {}

  void add_run(const Spoke& spoke) {
    Dart dart = spoke.start;
    for (std::uint32_t step = 1;; ++step) {
      traced_[HalfedgeId(mesh_->edge(dart.halfedge).value)] = true;
      if (step == spoke.length) return;
      dart = straight_ahead(*mesh_, dart);
    }
  }
  [[nodiscard]] bool contains(Dart dart) const { return traced_[HalfedgeId(mesh_->edge(dart.halfedge).value)]; }

 private:
  const Mesh* mesh_;
  PerHalfedge<bool> traced_;
};

ArcGraph cut_at_crossings(const Mesh& mesh, const PerFan<VertexCode>& codes, const ArcGraph& separatrices,
                          const Traffic& traffic) {
  TracedEdges traced(mesh);
  for (std::uint32_t spoke = 0; spoke < separatrices.spokes.size(); ++spoke) {
    const Spoke& run = separatrices.spokes[spoke];
    if (run.to_spoke == kNone || spoke <= run.to_spoke) traced.add_run(run);
  }
  std::vector<FanId> nodes;
  const std::vector<FanId> met = traffic.nodes();
  std::merge(separatrices.nodes.begin(), separatrices.nodes.end(), met.begin(), met.end(), std::back_inserter(nodes));

  SpokeIndex index(mesh);
  ArcGraph skeleton = graph_of_nodes(mesh, std::move(nodes), index, [&](Dart dart) { return traced.contains(dart); });
  const auto is_node = [&](FanId fan) { return codes[fan].extraordinary() || traffic.is_node(fan); };
  shoot(
      mesh, skeleton, index, is_node, [](FanId) {}, [](FanId) {});
  return skeleton;
}

}  // namespace

std::uint32_t ArcGraph::arc_count() const {
  std::uint32_t arcs = 0;
  for (std::uint32_t spoke = 0; spoke < spokes.size(); ++spoke) {
    // An arc from a spoke to itself cannot be: it would have to turn back on the way.
    if (spokes[spoke].to_spoke == kNone || spoke < spokes[spoke].to_spoke) ++arcs;
  }
  return arcs;
}

Dart straight_ahead(const Mesh& mesh, Dart dart) {
  // Two edges on about the vertex: clockwise from an edge we came along with its face on the left, counter-clockwise
  // from a boundary edge we came back along. At a boundary vertex of valence 3 the inner edge has none opposite.
  const HalfedgeId beside = mesh.twin(dart.backward ? mesh.prev(dart.halfedge) : mesh.next(dart.halfedge));
  if (!beside.valid()) return {};
  return dart.backward ? Dart{mesh.prev(beside), true} : Dart{mesh.next(beside), false};
}

VertexId tail_of(const Mesh& mesh, Dart dart) {
  return dart.backward ? mesh.tip(dart.halfedge) : mesh.origin(dart.halfedge);
}

VertexId head_of(const Mesh& mesh, Dart dart) {
  return dart.backward ? mesh.origin(dart.halfedge) : mesh.tip(dart.halfedge);
}

Tracing trace_skeleton(const Mesh& mesh, const PerFan<VertexCode>& codes) {
  std::vector<FanId> extraordinary;
  for (std::uint32_t p = 0; p < mesh.fan_count(); ++p) {
    if (codes[FanId(p)].extraordinary()) extraordinary.push_back(FanId(p));
  }
  Tracing tracing;
  if (extraordinary.empty()) {
    tracing.skeleton.first_spoke = tracing.separatrices.first_spoke = {0};
    return tracing;
  }
  SpokeIndex index(mesh);
  tracing.separatrices = graph_of_nodes(mesh, std::move(extraordinary), index, [](Dart) { return true; });
  Traffic traffic(mesh);
  shoot(
      mesh, tracing.separatrices, index, [&](FanId fan) { return codes[fan].extraordinary(); },
      [&](FanId fan) { traffic.pass(fan); }, [&](FanId fan) { traffic.stop(fan); });
  tracing.skeleton = cut_at_crossings(mesh, codes, tracing.separatrices, traffic);
  return tracing;
}

}  // namespace quadmatch
