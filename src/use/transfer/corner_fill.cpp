#include "corner_fill.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "../data/harmonic.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNoIndex = IndexedAttribute::kNoIndex;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// The unmatched part: which edges lie inside of it, and what its rim says.
class OpenPart {
 public:
  OpenPart(const Mesh& whole, const PerFace<FaceId>& matched, const IndexedAttribute& attribute)
      : mesh(whole), matched_(matched), attribute_(attribute), cut_(whole.halfedge_count(), 0) {}

  [[nodiscard]] bool open(HalfedgeId h) const { return !matched_[mesh.face(h)].valid(); }
  /// Between two unmatched faces, and not cut.
  [[nodiscard]] bool inner(HalfedgeId h) const {
    return open(h) && mesh.twin(h).valid() && open(mesh.twin(h)) && cut_[h] == 0;
  }
  void cut(HalfedgeId h) { cut_[h] = cut_[mesh.twin(h)] = 1; }

  /// What the matched face across a half-edge says at its origin, and at its tip.
  [[nodiscard]] std::uint32_t rim_at_origin(HalfedgeId h) const { return rim(h, true); }
  [[nodiscard]] std::uint32_t rim_at_tip(HalfedgeId h) const { return rim(h, false); }

  [[nodiscard]] bool same(std::uint32_t one, std::uint32_t other) const {
    if (one == other) return true;
    const auto tuple = attribute_.values.begin();
    const std::ptrdiff_t size = attribute_.components;
    return std::equal(tuple + one * size, tuple + (one + 1) * size, tuple + other * size);
  }

  const Mesh& mesh;

 private:
  [[nodiscard]] std::uint32_t rim(HalfedgeId h, bool at_origin) const {
    const HalfedgeId across = mesh.twin(h);
    if (!across.valid() || open(across)) return kNoIndex;
    return attribute_.corner_index[(at_origin ? mesh.next(across) : across).value];
  }

  const PerFace<FaceId>& matched_;
  const IndexedAttribute& attribute_;
  PerHalfedge<std::uint8_t> cut_;
};

/// A seam of the matched part that ends at the unmatched one.
struct SeamEnd {
  VertexId vertex;
  /// The half-edges into the vertex that lie inside the fan, counter-clockwise; at least one.
  std::vector<HalfedgeId> ways;
};

std::vector<SeamEnd> find_seam_ends(const OpenPart& part) {
  std::vector<SeamEnd> ends;
  for (std::uint32_t i = 0; i < part.mesh.halfedge_count(); ++i) {
    const HalfedgeId first(i);
    if (!part.open(first) || part.rim_at_origin(first) == kNoIndex) continue;
    SeamEnd end{part.mesh.origin(first), {}};
    HalfedgeId last = first;
    for (; part.inner(part.mesh.prev(last)); last = part.mesh.rotate_ccw(last)) {
      end.ways.push_back(part.mesh.prev(last));
    }
    const std::uint32_t other = part.rim_at_tip(part.mesh.prev(last));
    if (other == kNoIndex || end.ways.empty() || part.same(part.rim_at_origin(first), other)) continue;
    ends.push_back(std::move(end));
  }
  return ends;
}

/// Finds the shortest ways between seam ends through the inside of the unmatched part: all ends look for each other at
/// the same time, ring by ring.
class SeamPaths {
 public:
  SeamPaths(const OpenPart& part, const std::vector<SeamEnd>& ends)
      : part_(part), ends_(ends), reached_(part.mesh.vertex_count()) {
    for (std::uint32_t e = 0; e < ends.size(); ++e) {
      Reached& start = reached_[ends[e].vertex];
      if (start.by != kNone) continue;
      start.by = e;
      order_.push_back(ends[e].vertex);
    }
    for (std::size_t k = 0; k < order_.size(); ++k) spread(order_[k]);
  }

  /// The edges between each pair of ends; ends that found no other stay out, and are not in `paired`.
  [[nodiscard]] std::vector<HalfedgeId> take(std::vector<std::uint8_t>& paired) {
    std::sort(meetings_.begin(), meetings_.end(), [](const Meeting& a, const Meeting& b) {
      return std::tie(a.length, a.edge) < std::tie(b.length, b.edge);
    });
    std::vector<HalfedgeId> path;
    for (const Meeting& meeting : meetings_) {
      const std::uint32_t one = reached_[part_.mesh.origin(meeting.edge)].by;
      const std::uint32_t other = reached_[part_.mesh.tip(meeting.edge)].by;
      if (paired[one] != 0 || paired[other] != 0) continue;
      paired[one] = paired[other] = 1;
      path.push_back(meeting.edge);
      for (VertexId v : {part_.mesh.origin(meeting.edge), part_.mesh.tip(meeting.edge)}) {
        for (; reached_[v].along.valid(); v = part_.mesh.origin(reached_[v].along)) path.push_back(reached_[v].along);
      }
    }
    return path;
  }

 private:
  struct Reached {
    std::uint32_t by = kNone;
    std::uint32_t distance = 0;
    HalfedgeId along;  // into the vertex
  };
  struct Meeting {
    std::uint32_t length;
    HalfedgeId edge;
  };

  void spread(VertexId v) {
    if (reached_[v].distance == 0) {
      for (const HalfedgeId way : ends_[reached_[v].by].ways) go(v, part_.mesh.twin(way));
      return;
    }
    const HalfedgeId start = part_.mesh.twin(reached_[v].along);
    HalfedgeId h = start;
    do {
      go(v, h);
      h = part_.mesh.rotate_ccw(h);
    } while (h != start);
  }

  void go(VertexId from, HalfedgeId way) {
    const VertexId to = part_.mesh.tip(way);
    if (reached_[to].by == kNone) {
      if (!inside(way)) return;
      reached_[to] = {reached_[from].by, reached_[from].distance + 1, way};
      order_.push_back(to);
    } else if (reached_[to].by != reached_[from].by) {
      meetings_.push_back({reached_[from].distance + reached_[to].distance + 1, way});
    }
  }

  /// Is the tip of an inner half-edge surrounded by unmatched faces?
  [[nodiscard]] bool inside(HalfedgeId way) const {
    const HalfedgeId start = part_.mesh.twin(way);
    HalfedgeId h = start;
    do {
      if (!h.valid() || !part_.inner(h)) return false;
      h = part_.mesh.rotate_ccw(h);
    } while (h != start);
    return true;
  }

  const OpenPart& part_;
  const std::vector<SeamEnd>& ends_;
  PerVertex<Reached> reached_;
  std::vector<VertexId> order_;
  std::vector<Meeting> meetings_;
};

/// @return  the edges that lead from one end to another
std::vector<HalfedgeId> cut_seams(OpenPart& part) {
  const std::vector<SeamEnd> ends = find_seam_ends(part);
  std::vector<std::uint8_t> paired(ends.size(), 0);
  std::vector<HalfedgeId> paths = SeamPaths(part, ends).take(paired);
  for (const HalfedgeId h : paths) part.cut(h);
  for (std::size_t e = 0; e < ends.size(); ++e) {
    if (paired[e] == 0) part.cut(ends[e].ways[ends[e].ways.size() / 2]);
  }
  return paths;
}

/// The node of every unmatched corner, numbered by their first corners; kNone for matched ones.
std::uint32_t number_nodes(const OpenPart& part, std::vector<std::uint32_t>& node_of) {
  const Mesh& mesh = part.mesh;
  std::uint32_t count = 0;
  std::vector<HalfedgeId> to_visit;
  const auto visit = [&](HalfedgeId corner) {
    if (node_of[corner.value] != kNone) return;
    node_of[corner.value] = count;
    to_visit.push_back(corner);
  };
  for (std::uint32_t i = 0; i < mesh.halfedge_count(); ++i) {
    if (!part.open(HalfedgeId(i)) || node_of[i] != kNone) continue;
    visit(HalfedgeId(i));
    while (!to_visit.empty()) {
      const HalfedgeId corner = to_visit.back();
      to_visit.pop_back();
      if (part.inner(corner)) visit(mesh.next(mesh.twin(corner)));
      if (part.inner(mesh.prev(corner))) visit(mesh.twin(mesh.prev(corner)));
    }
    ++count;
  }
  return count;
}

}  // namespace

void fill_corners(const Mesh& mesh, const PerFace<FaceId>& matched, IndexedAttribute& attribute) {
  OpenPart part(mesh, matched, attribute);
  const std::vector<HalfedgeId> seams = cut_seams(part);
  std::vector<std::uint32_t> node_of(mesh.halfedge_count(), kNone);
  const std::uint32_t count = number_nodes(part, node_of);

  // What the rim says; where it says two things at a single corner, the first.
  std::vector<std::uint32_t> index_of(count, kNoIndex);
  const auto tell = [&](HalfedgeId corner, std::uint32_t index) {
    std::uint32_t& told = index_of[node_of[corner.value]];
    if (told == kNoIndex) told = index;
  };
  const std::vector<double> weights = edge_weights(mesh);
  std::vector<WeightedEdge> edges;
  for (std::uint32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    if (!part.open(h)) continue;
    tell(h, part.rim_at_origin(h));
    tell(mesh.next(h), part.rim_at_tip(h));
    edges.push_back({node_of[i], node_of[mesh.next(h).value], weights[i]});
  }

  GraphValues graph{attribute.components, std::vector<std::uint8_t>(count, 0),
                    std::vector<double>(std::size_t{count} * attribute.components, 0.0)};
  const std::ptrdiff_t size = attribute.components;
  for (std::uint32_t node = 0; node < count; ++node) {
    if (index_of[node] == kNoIndex) continue;
    graph.known[node] = 1;
    std::copy_n(attribute.values.begin() + index_of[node] * size, size, graph.values.begin() + node * size);
  }
  // Seams first, each side along its own, so that they run straight; then what lies between.
  std::vector<WeightedEdge> along;
  for (const HalfedgeId seam : seams) {
    for (const HalfedgeId h : {seam, mesh.twin(seam)}) {
      along.push_back({node_of[h.value], node_of[mesh.next(h).value], weights[h.value]});
    }
  }
  interpolate(along, graph);
  interpolate(edges, graph);
  for (std::uint32_t node = 0; node < count; ++node) {
    if (index_of[node] != kNoIndex || graph.known[node] == 0) continue;
    index_of[node] = static_cast<std::uint32_t>(attribute.values.size() / attribute.components);
    const auto tuple = graph.values.begin() + node * size;
    attribute.values.insert(attribute.values.end(), tuple, tuple + size);
  }
  for (std::size_t corner = 0; corner < node_of.size(); ++corner) {
    if (node_of[corner] != kNone) attribute.corner_index[corner] = index_of[node_of[corner]];
  }
}

}  // namespace quadmatch::use
