// Particle shooting, §4.3: one tracing, two graphs.
//
// The separatrix graph comes first: every particle is followed from its extraordinary vertex to where it rests. On the
// way it counts, at each regular vertex, how many traces pass. The same traces are then cut at the vertices where two
// of them cross or one of them ran into the boundary: that is the skeleton graph.

#include <quadmatch/analysis/skeleton.hpp>

#include <algorithm>
#include <iterator>
#include <memory>
#include <span>
#include <utility>

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
  /// Room for a number at each half-edge, untouched: few will have one.
  explicit SpokeIndex(const Mesh& mesh)
      : of_halfedge_(std::make_unique_for_overwrite<std::uint32_t[]>(mesh.halfedge_count())) {}

  /// Forget the backward darts; forward ones are overwritten, since the second graph has all spokes of the first.
  void restart() { backward_.clear(); }
  /// A boundary half-edge is the start of two darts; the backward one is kept in a list of its own.
  void add(Dart dart, std::uint32_t spoke) {
    if (dart.backward) {
      backward_.emplace_back(dart.halfedge, spoke);
    } else {
      of_halfedge_[dart.halfedge.value] = spoke;
    }
  }
  void finish() { std::sort(backward_.begin(), backward_.end()); }
  /// @pre the dart was added.
  [[nodiscard]] std::uint32_t find(Dart dart) const {
    if (!dart.backward) return of_halfedge_[dart.halfedge.value];
    return std::lower_bound(backward_.begin(), backward_.end(), std::pair(dart.halfedge, 0U))->second;
  }

 private:
  std::unique_ptr<std::uint32_t[]> of_halfedge_;
  std::vector<std::pair<HalfedgeId, std::uint32_t>> backward_;
};

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

/// What the traces did at the vertices that are not extraordinary.
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

/// Every edge that a particle went along, once, particle after particle; and the traffic they made.
struct Traces {
  explicit Traces(const Mesh& mesh) : traffic(mesh) {}

  std::vector<Dart> darts;
  std::vector<std::size_t> starts = {0};  ///< where each trace begins in `darts`, and the total
  Traffic traffic;

  void go_along(Dart dart) { darts.push_back(dart); }
  void pass(FanId fan) { traffic.pass(fan); }
  void stop(FanId fan) { traffic.stop(fan); }
  void end() { starts.push_back(darts.size()); }

  [[nodiscard]] std::size_t count() const { return starts.size() - 1; }
  [[nodiscard]] std::span<const Dart> trace(std::size_t number) const {
    return std::span(darts).subspan(starts[number], starts[number + 1] - starts[number]);
  }
};

/// Where only the ends of the traces are wanted.
struct NoTraces {
  void go_along(Dart /*dart*/) {}
  void pass(FanId /*fan*/) {}
  void stop(FanId /*fan*/) {}
  void end() {}
};

/// Shoot a particle from every spoke, and join it to the spoke in which it comes to rest: both ends at once, so that
/// each trace is walked in one direction only.
template <class Recorder>
void shoot(const Mesh& mesh, const PerFan<VertexCode>& codes, ArcGraph& separatrices, const SpokeIndex& index,
           Recorder& recorder) {
  const std::vector<std::uint32_t> owner = owners(separatrices);
  for (std::uint32_t spoke = 0; spoke < separatrices.spokes.size(); ++spoke) {
    if (separatrices.spokes[spoke].length != 0) continue;  // a particle came to rest here before
    Dart here = separatrices.spokes[spoke].start;
    std::uint32_t length = 1;
    recorder.go_along(here);
    FanId ahead = fan_ahead(mesh, here);
    while (!codes[ahead].extraordinary()) {
      const Dart next = straight_ahead(mesh, here);
      if (!next.halfedge.valid()) break;
      recorder.pass(ahead);
      recorder.go_along(here = next);
      ahead = fan_ahead(mesh, here);
      ++length;
    }
    recorder.end();
    if (codes[ahead].extraordinary()) {
      const std::uint32_t to_spoke = index.find(turned_back(mesh, here));
      join(separatrices, owner[spoke], spoke, owner[to_spoke], to_spoke, length);
    } else {
      join(separatrices, owner[spoke], spoke, kNone, kNone, length);
      recorder.stop(ahead);
    }
  }
}

/// The separatrix graph, with its spokes not yet joined.
ArcGraph graph_of_extraordinary(const Mesh& mesh, const PerFan<VertexCode>& codes, SpokeIndex& index) {
  std::vector<FanId> extraordinary;
  for (std::uint32_t p = 0; p < mesh.fan_count(); ++p) {
    if (codes[FanId(p)].extraordinary()) extraordinary.push_back(FanId(p));
  }
  return graph_of_nodes(mesh, std::move(extraordinary), index, [](Dart) { return true; });
}

/// The skeleton: the same traces, cut wherever they pass a node.
ArcGraph cut_at_crossings(const Mesh& mesh, const PerFan<VertexCode>& codes, const std::vector<FanId>& extraordinary,
                          const Traces& traces, SpokeIndex& index) {
  std::vector<bool> traced(mesh.halfedge_count(), false);
  for (const Dart dart : traces.darts) traced[mesh.edge(dart.halfedge).value] = true;
  std::vector<FanId> nodes;
  const std::vector<FanId> met = traces.traffic.nodes();
  std::merge(extraordinary.begin(), extraordinary.end(), met.begin(), met.end(), std::back_inserter(nodes));
  index.restart();
  ArcGraph skeleton =
      graph_of_nodes(mesh, std::move(nodes), index, [&](Dart dart) { return traced[mesh.edge(dart.halfedge).value]; });

  const std::vector<std::uint32_t> owner = owners(skeleton);
  for (std::size_t number = 0; number < traces.count(); ++number) {
    const std::span<const Dart> trace = traces.trace(number);
    std::size_t start = 0;
    for (std::size_t step = 0; step < trace.size(); ++step) {
      const FanId ahead = fan_ahead(mesh, trace[step]);
      if (!codes[ahead].extraordinary() && !traces.traffic.is_node(ahead)) continue;
      const std::uint32_t from = index.find(trace[start]);
      const std::uint32_t to = index.find(turned_back(mesh, trace[step]));
      join(skeleton, owner[from], from, owner[to], to, static_cast<std::uint32_t>(step + 1 - start));
      start = step + 1;
    }
  }
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
  SpokeIndex index(mesh);
  Tracing tracing;
  tracing.separatrices = graph_of_extraordinary(mesh, codes, index);
  Traces traces(mesh);
  shoot(mesh, codes, tracing.separatrices, index, traces);
  tracing.skeleton = cut_at_crossings(mesh, codes, tracing.separatrices.nodes, traces, index);
  return tracing;
}

ArcGraph trace_separatrices(const Mesh& mesh, const PerFan<VertexCode>& codes) {
  SpokeIndex index(mesh);
  ArcGraph separatrices = graph_of_extraordinary(mesh, codes, index);
  NoTraces traces;
  shoot(mesh, codes, separatrices, index, traces);
  return separatrices;
}

}  // namespace quadmatch
