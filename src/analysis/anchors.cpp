// Anchors, §4.1: colour both skeleton graphs until a colour is unique in both, take the rarest, match neighbours.

#include <quadmatch/analysis/anchors.hpp>

#include <algorithm>
#include <span>
#include <tuple>

#include <quadmatch/mesh/components.hpp>

namespace quadmatch {
namespace {

/// How large the component of the skeleton is that each node lies in: the edges its particles went along. Stands for
/// the faces of the component of the mesh, at a cost that does not grow with them.
std::vector<std::uint64_t> traced_lengths(const ArcGraph& skeleton) {
  constexpr std::uint64_t kUnseen = ~std::uint64_t{0};
  std::vector<std::uint64_t> length(skeleton.node_count(), kUnseen);
  std::vector<std::uint32_t> component;
  for (std::uint32_t start = 0; start < skeleton.node_count(); ++start) {
    if (length[start] != kUnseen) continue;
    component.assign(1, start);
    length[start] = 0;
    std::uint64_t sum = 0;
    for (std::size_t next = 0; next < component.size(); ++next) {
      for (const Spoke& spoke : skeleton.spokes_of(component[next])) {
        sum += spoke.length;
        if (length[spoke.to_node] != kUnseen) continue;
        length[spoke.to_node] = 0;
        component.push_back(spoke.to_node);
      }
    }
    for (const std::uint32_t node : component) length[node] = sum / 2;
  }
  return length;
}

/// One of the two meshes with its colours of the current round.
struct Side {
  const Mesh& mesh;
  const ArcGraph& skeleton;
  const PerFan<VertexCode>& codes;
  std::vector<std::uint64_t> reach = traced_lengths(skeleton);  ///< of each node
  std::vector<Colour> colours = {};
  std::vector<std::uint32_t> by_colour = {};  ///< nodes, sorted by colour, then number

  void sort_by_colour() {
    by_colour.resize(skeleton.node_count());
    for (std::uint32_t node = 0; node < by_colour.size(); ++node) by_colour[node] = node;
    std::sort(by_colour.begin(), by_colour.end(),
              [this](std::uint32_t a, std::uint32_t b) { return std::tie(colours[a], a) < std::tie(colours[b], b); });
  }
  void refine(std::uint32_t round, const ColouringOptions& options) {
    colours = round == 0 ? initial_colours(skeleton, codes) : refine_colours(skeleton, codes, colours, options);
    sort_by_colour();
  }
  [[nodiscard]] std::uint64_t largest_reach() const { return *std::max_element(reach.begin(), reach.end()); }
};

/// A colour that both meshes have, and who has it.
struct CommonColour {
  Colour colour;
  std::span<const std::uint32_t> source, target;

  [[nodiscard]] std::uint64_t pairs() const { return std::uint64_t{source.size()} * target.size(); }
};

std::vector<CommonColour> common_colours(const Side& source, const Side& target) {
  std::vector<CommonColour> common;
  const auto run = [](const Side& side, std::size_t begin) {
    std::size_t end = begin;
    while (end < side.by_colour.size() && side.colours[side.by_colour[end]] == side.colours[side.by_colour[begin]]) {
      ++end;
    }
    return std::span(side.by_colour).subspan(begin, end - begin);
  };
  std::size_t s = 0, t = 0;
  while (s < source.by_colour.size() && t < target.by_colour.size()) {
    const Colour left = source.colours[source.by_colour[s]];
    const Colour right = target.colours[target.by_colour[t]];
    const auto source_run = run(source, s);
    const auto target_run = run(target, t);
    if (left == right) common.push_back({left, source_run, target_run});
    if (left <= right) s += source_run.size();
    if (right <= left) t += target_run.size();
  }
  return common;
}

/// Two nodes of one colour laid on each other: spoke `source_spoke` of the one on `target_spoke` of the other.
struct Alignment {
  Colour colour = 0;
  std::uint32_t round = 0;
  std::uint32_t source_node = 0, target_node = 0;
  std::uint32_t source_spoke = 0, target_spoke = 0;
  std::uint32_t agreeing = 0, disagreeing = 0;  ///< neighbours whose colours do or do not agree
  std::uint64_t reach = 0;                      ///< of the smaller of the two components

  /// Better first; only the last resort depends on the numbering.
  [[nodiscard]] auto rank() const {
    return std::tuple(disagreeing, ~round, ~reach, ~agreeing, colour, source_node, target_node, target_spoke);
  }
};

std::uint32_t spoke_count(const Side& side, std::uint32_t node) {
  return static_cast<std::uint32_t>(side.skeleton.spokes_of(node).size());
}

/// Spoke `step` of a node, counted on from spoke `start`.
const Spoke& spoke_at(const Side& side, std::uint32_t node, std::uint32_t start, std::uint32_t step) {
  const auto spokes = side.skeleton.spokes_of(node);
  return spokes[(start + step) % spokes.size()];
}

/// §4.1: "then look for matching neighbours of the two matched vertices".
void compare_neighbours(const Side& source, const Side& target, Alignment& alignment) {
  const std::uint32_t count = spoke_count(source, alignment.source_node);
  for (std::uint32_t step = 0; step < count; ++step) {
    const Spoke& left = spoke_at(source, alignment.source_node, alignment.source_spoke, step);
    const Spoke& right = spoke_at(target, alignment.target_node, alignment.target_spoke, step);
    const bool agree = left.to_node != Spoke::kNone && right.to_node != Spoke::kNone &&
                       source.colours[left.to_node] == target.colours[right.to_node];
    ++(agree ? alignment.agreeing : alignment.disagreeing);
  }
}

/// The ways to lay one node on another of its colour: the beginnings of their least strings.
void align(const Side& source, const Side& target, Colour colour, std::uint32_t source_node, std::uint32_t target_node,
           const ColouringOptions& options, std::uint32_t round, std::vector<Alignment>& alignments) {
  if (spoke_count(source, source_node) != spoke_count(target, target_node)) return;  // unequal at the last round only
  const auto source_starts = least_rotations(source.skeleton, source.codes, source.colours, source_node, options);
  const auto target_starts = least_rotations(target.skeleton, target.codes, target.colours, target_node, options);
  for (const std::uint32_t target_start : target_starts) {
    Alignment alignment{.colour = colour,
                        .round = round,
                        .source_node = source_node,
                        .target_node = target_node,
                        .source_spoke = source_starts.front(),
                        .target_spoke = target_start,
                        .reach = std::min(source.reach[source_node], target.reach[target_node])};
    compare_neighbours(source, target, alignment);
    alignments.push_back(alignment);
  }
}

/// A seed on the first spoke whose faces can lie on each other; not valid if there is none.
Anchor seed_of(const Side& source, const Side& target, const Alignment& alignment) {
  for (std::uint32_t step = 0; step < spoke_count(source, alignment.source_node); ++step) {
    const Dart left = spoke_at(source, alignment.source_node, alignment.source_spoke, step).start;
    const Dart right = spoke_at(target, alignment.target_node, alignment.target_spoke, step).start;
    if (left.backward != right.backward) continue;
    if (source.mesh.size(source.mesh.face(left.halfedge)) == target.mesh.size(target.mesh.face(right.halfedge))) {
      return {left.halfedge, right.halfedge};
    }
  }
  return {};
}

/// The stopping condition of §4.1: a pair of uniquely coloured nodes, one from each mesh.
/// Reading: the paper's models are connected. In ours a button must not stop the search before the coat is told
/// apart, so the pair must lie in components at least half as large as the largest.
bool has_unique_pair(const Side& source, const Side& target, std::span<const CommonColour> common) {
  const std::uint64_t source_half = source.largest_reach() / 2;
  const std::uint64_t target_half = target.largest_reach() / 2;
  return std::any_of(common.begin(), common.end(), [&](const CommonColour& colour) {
    return colour.pairs() == 1 && source.reach[colour.source.front()] >= source_half &&
           target.reach[colour.target.front()] >= target_half;
  });
}

/// Add all alignments of the rarest colours; of a bounded number of pairs where even the rarest is common.
void align_rarest(const Side& source, const Side& target, std::span<const CommonColour> common,
                  const ColouringOptions& options, std::uint32_t round, std::uint64_t rarest,
                  std::vector<Alignment>& alignments) {
  constexpr std::size_t kMostAlignments = 4096;
  for (const CommonColour& colour : common) {
    if (colour.pairs() != rarest) continue;
    for (const std::uint32_t left : colour.source) {
      for (const std::uint32_t right : colour.target) {
        if (alignments.size() >= kMostAlignments) return;
        align(source, target, colour.colour, left, right, options, round, alignments);
      }
    }
  }
}

/// A half-edge of the largest component: on its boundary if it has one, so that boundaries come to lie on each other.
HalfedgeId any_halfedge(const Mesh& mesh, bool on_boundary) {
  const Components components = connected_components(mesh);
  const auto& counts = components.face_count;
  const auto largest = static_cast<std::uint32_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
  HalfedgeId first;
  for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
    const HalfedgeId h(number);
    if (components.of_face[mesh.face(h)] != largest) continue;
    if (!on_boundary || !mesh.twin(h).valid()) return h;
    if (!first.valid()) first = h;
  }
  return first;
}

/// §4.1: "if there are no extraordinary vertices at all, then we pick an arbitrary pair".
AnchorSearch arbitrary_pair(const Mesh& source, const Mesh& target) {
  AnchorSearch search;
  search.arbitrary = true;
  if (source.face_count() == 0 || target.face_count() == 0) return search;
  Anchor anchor{any_halfedge(source, true), any_halfedge(target, true)};
  if (source.twin(anchor.source).valid() != target.twin(anchor.target).valid()) {
    anchor = {any_halfedge(source, false), any_halfedge(target, false)};
  }
  if (source.size(source.face(anchor.source)) == target.size(target.face(anchor.target))) {
    search.anchors.push_back(anchor);
  }
  return search;
}

}  // namespace

AnchorSearch find_anchors(const Mesh& source_mesh, const ArcGraph& source_skeleton,
                          const PerFan<VertexCode>& source_codes, const Mesh& target_mesh,
                          const ArcGraph& target_skeleton, const PerFan<VertexCode>& target_codes,
                          const AnchorOptions& options) {
  if (source_skeleton.nodes.empty() || target_skeleton.nodes.empty()) return arbitrary_pair(source_mesh, target_mesh);

  Side source{source_mesh, source_skeleton, source_codes};
  Side target{target_mesh, target_skeleton, target_codes};
  AnchorSearch search;
  std::vector<Alignment> best;
  std::uint64_t best_pairs = ~std::uint64_t{0};
  for (std::uint32_t round = 0; round <= std::max(options.rounds, 1U); ++round) {
    source.refine(round, options.colouring);
    target.refine(round, options.colouring);
    const std::vector<CommonColour> common = common_colours(source, target);
    if (common.empty()) break;  // colours only ever split: there will be none later either
    const auto rarest = std::min_element(common.begin(), common.end(),
                                         [](const auto& a, const auto& b) { return a.pairs() < b.pairs(); });
    if (rarest->pairs() <= best_pairs) {
      // Unique pairs of earlier rounds stay: an edit can have changed what a later round sees around them.
      if (rarest->pairs() > 1 || best_pairs > 1) best.clear();
      best_pairs = rarest->pairs();
      align_rarest(source, target, common, options.colouring, round, best_pairs, best);
      search.rounds = round;
      search.source_rarity = static_cast<std::uint32_t>(rarest->source.size());
      search.target_rarity = static_cast<std::uint32_t>(rarest->target.size());
    }
    if (round > 0 && has_unique_pair(source, target, common)) break;
  }

  std::sort(best.begin(), best.end(), [](const Alignment& a, const Alignment& b) { return a.rank() < b.rank(); });
  for (const Alignment& alignment : best) {
    if (search.anchors.size() == options.count) break;
    const Anchor anchor = seed_of(source, target, alignment);
    const bool is_new = std::find(search.anchors.begin(), search.anchors.end(), anchor) == search.anchors.end();
    if (anchor.source.valid() && is_new) search.anchors.push_back(anchor);
  }
  if (search.anchors.empty()) return arbitrary_pair(source_mesh, target_mesh);
  return search;
}

}  // namespace quadmatch
