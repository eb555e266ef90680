#include "compatibility.hpp"

#include <algorithm>
#include <utility>

namespace quadmatch {
namespace {

/// Gaps of more faces than this are not looked along: the apex of a fan of a million triangles would otherwise be
/// walked around once for each of them.
constexpr std::uint32_t kLongestGap = 255;

/// Turning about the origin of a half-edge, away from the face beyond it: one step towards `next` in L.
struct AboutOrigin {
  static HalfedgeId side(const Mesh& mesh, HalfedgeId h) { return mesh.prev(h); }
};

/// Turning about the tip: one step towards `previous`.
struct AboutTip {
  static HalfedgeId side(const Mesh& mesh, HalfedgeId h) { return mesh.next(h); }
};

}  // namespace

CompatibilityGraph::CompatibilityGraph(const Growth& growth)
    : growth_(growth),
      source_(growth.source()),
      target_(growth.target()),
      node_at_(growth.source().halfedge_count(), kNone) {}

void CompatibilityGraph::extend(std::size_t from) {
  const auto& order = growth_.order();
  for (std::size_t place = from; place < order.size(); ++place) {
    for (const HalfedgeId h : source_.halfedges(source_.face(order[place].source))) {
      if (node_at_[h] != kNone) remove_node(node_at_[h]);
    }
  }
  new_nodes_.clear();
  add_candidates(from);
  for (const std::uint32_t node : new_nodes_) link_about_origin(node);
  for (const std::uint32_t node : new_nodes_) link_about_tip(node);
  push_touched();
}

/// The possible pairs beyond the edges of all newly matched faces. In passes over a few hundred at a time, each asking
/// the memory for what the next one reads: the wavefront is wide, so there is always something else to do meanwhile.
void CompatibilityGraph::add_candidates(std::size_t from) {
  constexpr std::size_t kAtATime = 256;
  const auto& order = growth_.order();
  for (std::size_t place = from; place < order.size();) {
    beyond_.clear();
    for (; place < order.size() && beyond_.size() < kAtATime; ++place) {
      auto [s, t] = order[place];
      for (std::uint32_t corner = source_.size(source_.face(s)); corner > 0; --corner) {
        const Candidate beyond{source_.twin(s), target_.twin(t)};
        if (beyond.source.valid() && beyond.target.valid() && !growth_.is_matched(source_.face(beyond.source)) &&
            !growth_.is_taken(target_.face(beyond.target))) {
          growth_.prefetch_faces(beyond);
          beyond_.push_back(beyond);
        }
        s = source_.next(s);
        t = target_.next(t);
      }
    }
    std::erase_if(beyond_, [this](Candidate beyond) {
      return source_.size(source_.face(beyond.source)) != target_.size(target_.face(beyond.target));
    });
    for (const Candidate beyond : beyond_) growth_.prefetch_vertices(beyond);
    for (const Candidate beyond : beyond_) add_node(beyond);
  }
}

std::vector<CompatibilityGraph::Member> CompatibilityGraph::take_largest() {
  std::vector<Member> members;
  while (members.empty() && !queue_.empty()) {
    const Entry entry = queue_.top();
    queue_.pop();
    if (runs_[entry.run].stamp != entry.stamp) continue;
    // The map has grown since the candidates came in: those that no longer fit it leave L before sizes are compared.
    if (drop_misfits(entry.run)) {
      push_touched();
      continue;
    }
    const std::vector<std::uint32_t> nodes = nodes_of(entry.run);
    for (const std::uint32_t node : nodes) {
      members.push_back({nodes_[node].candidate, false});
      for_each_in_middle(node, [&](Candidate candidate) {
        members.push_back({candidate, true});
        return true;
      });
    }
    for (const std::uint32_t node : nodes) {
      node_at_[nodes_[node].candidate.source] = kNone;
      free_nodes_.push_back(node);
    }
    free_run(entry.run);
  }
  return members;
}

// Nodes and links.

/// A wavefront edge with a possible pair beyond it.
void CompatibilityGraph::add_node(Candidate candidate) {
  std::uint32_t number = static_cast<std::uint32_t>(nodes_.size());
  if (free_nodes_.empty()) {
    nodes_.emplace_back();
  } else {
    number = free_nodes_.back();
    free_nodes_.pop_back();
  }
  Node& node = nodes_[number];
  node = {.candidate = candidate, .disagreeing = growth_.disagreeing_corners(candidate)};
  node.run = new_run();
  Run& run = runs_[node.run];
  run.some_node = number;
  run.nodes = 1;
  run.faces = 1;
  run.disagreeing = node.disagreeing;
  node_at_[candidate.source] = number;
  new_nodes_.push_back(number);
  touch(node.run);
}

void CompatibilityGraph::remove_node(std::uint32_t number) {
  if (nodes_[number].previous != kNone) unlink_next(nodes_[number].previous);
  if (nodes_[number].next != kNone) unlink_next(number);
  free_run(nodes_[number].run);
  node_at_[nodes_[number].candidate.source] = kNone;
  free_nodes_.push_back(number);
}

/// Walk the faces about a vertex in both meshes at once, from a candidate to the next edge of the wavefront.
template <class Turn>
CompatibilityGraph::Gap CompatibilityGraph::walk_gap(Candidate candidate, Turn turn) const {
  Gap gap;
  auto [s, t] = candidate;
  bool together = true;  // the target still does what the source does
  for (gap.faces = 1; gap.faces <= kLongestGap; ++gap.faces) {
    const HalfedgeId beyond = source_.twin(turn.side(source_, s));
    const HalfedgeId beyond_target = together ? target_.twin(turn.side(target_, t)) : HalfedgeId();
    if (!beyond.valid()) return gap;
    if (growth_.is_matched(source_.face(beyond))) {
      gap.source_end = turn.side(source_, s);
      gap.agrees = together && beyond_target.valid() && growth_.image(beyond) == beyond_target;
      return gap;
    }
    together = together && beyond_target.valid() && !growth_.is_taken(target_.face(beyond_target)) &&
               source_.size(source_.face(beyond)) == target_.size(target_.face(beyond_target));
    s = beyond;
    t = beyond_target;
  }
  return gap;
}

void CompatibilityGraph::link_about_origin(std::uint32_t node) {
  if (nodes_[node].next != kNone) return;
  const Gap gap = walk_gap(nodes_[node].candidate, AboutOrigin());
  const std::uint32_t next = gap.source_end.valid() ? node_at_[gap.source_end] : kNone;
  if (next == kNone) return;
  // What it was linked to lay beyond a gap that has just been cut in two.
  if (nodes_[next].previous != kNone) unlink_next(nodes_[next].previous);
  if (gap.agrees) link(node, next, gap.faces);
}

void CompatibilityGraph::link_about_tip(std::uint32_t node) {
  if (nodes_[node].previous != kNone) return;
  const Gap gap = walk_gap(nodes_[node].candidate, AboutTip());
  const std::uint32_t previous = gap.source_end.valid() ? node_at_[gap.source_end] : kNone;
  if (previous == kNone) return;
  if (nodes_[previous].next != kNone) unlink_next(previous);
  if (gap.agrees) link(previous, node, gap.faces);
}

/// The candidates across the vertex, between a node and its next one; the visit may end them by returning false.
template <class Visit>
void CompatibilityGraph::for_each_in_middle(std::uint32_t number, Visit visit) const {
  const Node& node = nodes_[number];
  if (node.next == kNone) return;
  auto [s, t] = node.candidate;
  for (std::uint32_t face = 2; face < node.gap; ++face) {
    s = source_.twin(source_.prev(s));
    t = target_.twin(target_.prev(t));
    if (!visit(Candidate{s, t})) return;
  }
}

// Runs.

std::uint32_t CompatibilityGraph::new_run() {
  std::uint32_t run = static_cast<std::uint32_t>(runs_.size());
  if (free_runs_.empty()) {
    runs_.emplace_back();
  } else {
    run = free_runs_.back();
    free_runs_.pop_back();
  }
  runs_[run] = {.birth = ++clock_};
  return run;
}

void CompatibilityGraph::free_run(std::uint32_t run) {
  runs_[run] = {};
  free_runs_.push_back(run);
}

/// Join the end of one run to the beginning of another, or of itself.
void CompatibilityGraph::link(std::uint32_t node, std::uint32_t next, std::uint32_t gap) {
  nodes_[node].next = next;
  nodes_[node].gap = gap;
  nodes_[next].previous = node;
  std::uint32_t kept = nodes_[node].run;
  std::uint32_t given_up = nodes_[next].run;
  if (kept == given_up) {
    runs_[kept].cyclic = true;
  } else {
    const bool keep_left = runs_[kept].nodes >= runs_[given_up].nodes;
    if (!keep_left) std::swap(kept, given_up);
    const auto onward = keep_left ? &Node::next : &Node::previous;
    for (std::uint32_t n = keep_left ? next : node; n != kNone; n = nodes_[n].*onward) nodes_[n].run = kept;
    Run& run = runs_[kept];
    const Run& other = runs_[given_up];
    run.nodes += other.nodes;
    run.faces += other.faces;
    run.disagreeing += other.disagreeing;
    run.birth = std::min(run.birth, other.birth);
    free_run(given_up);
  }
  runs_[kept].faces += std::int64_t{gap} - 2;
  touch(kept);
}

/// Cut a run between a node and its next one.
void CompatibilityGraph::unlink_next(std::uint32_t node) {
  const std::uint32_t next = std::exchange(nodes_[node].next, kNone);
  nodes_[next].previous = kNone;
  Run& run = runs_[nodes_[node].run];
  run.faces -= std::int64_t{nodes_[node].gap} - 2;
  touch(nodes_[node].run);
  if (run.cyclic) {
    run.cyclic = false;
  } else {
    split(node, next);
  }
}

/// Two runs out of one that has been cut: walk both ways from the cut, and relabel the part that ends first.
void CompatibilityGraph::split(std::uint32_t left_end, std::uint32_t right_end) {
  const std::uint32_t old_run = nodes_[left_end].run;
  const std::uint32_t part = new_run();
  std::uint32_t left = left_end, right = right_end;
  while (left != kNone && right != kNone) {
    left = nodes_[left].previous;
    right = nodes_[right].next;
  }
  if (right == kNone) {
    move_part(right_end, &Node::next, old_run, part);
    runs_[old_run].some_node = left_end;
  } else {
    move_part(left_end, &Node::previous, old_run, part);
    runs_[old_run].some_node = right_end;
  }
  touch(part);
}

void CompatibilityGraph::move_part(std::uint32_t end, std::uint32_t Node::*onward, std::uint32_t from,
                                   std::uint32_t to) {
  Run& old_run = runs_[from];
  Run& part = runs_[to];
  part.some_node = end;
  for (std::uint32_t n = end; n != kNone; n = nodes_[n].*onward) {
    nodes_[n].run = to;
    ++part.nodes;
    part.faces += nodes_[n].next == kNone ? 1 : std::int64_t{nodes_[n].gap} - 1;
    part.disagreeing += nodes_[n].disagreeing;
  }
  old_run.nodes -= part.nodes;
  old_run.faces -= part.faces;
  old_run.disagreeing -= part.disagreeing;
}

/// The queue entry of a run no longer holds; a new one follows when all changes of this step are made.
void CompatibilityGraph::touch(std::uint32_t run) {
  runs_[run].stamp = 0;
  touched_.push_back(run);
}

void CompatibilityGraph::push_touched() {
  for (const std::uint32_t number : touched_) {
    Run& run = runs_[number];
    if (run.nodes == 0 || run.stamp != 0) continue;  // given up, or pushed already
    run.stamp = ++clock_;
    queue_.push({run.faces, run.disagreeing, run.birth, run.stamp, number});
  }
  touched_.clear();
}

/// In the order of the wavefront: a path from its beginning, a cycle from any fixed node.
std::vector<std::uint32_t> CompatibilityGraph::nodes_of(std::uint32_t run) const {
  std::uint32_t start = runs_[run].some_node;
  if (!runs_[run].cyclic) {
    while (nodes_[start].previous != kNone) start = nodes_[start].previous;
  }
  std::vector<std::uint32_t> nodes;
  nodes.reserve(runs_[run].nodes);
  for (std::uint32_t n = start; n != kNone && nodes.size() < runs_[run].nodes; n = nodes_[n].next) nodes.push_back(n);
  return nodes;
}

/// Take candidates that have come to contradict the map out of a run. True if there were any.
bool CompatibilityGraph::drop_misfits(std::uint32_t run) {
  bool dropped = false;
  for (const std::uint32_t node : nodes_of(run)) {
    if (!growth_.fits(nodes_[node].candidate)) {
      remove_node(node);
      dropped = true;
      continue;
    }
    bool middle_fits = true;
    for_each_in_middle(node, [&](Candidate candidate) { return middle_fits = growth_.fits(candidate); });
    if (!middle_fits) {
      unlink_next(node);
      dropped = true;
    }
  }
  return dropped;
}

}  // namespace quadmatch
