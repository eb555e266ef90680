#include "ignition.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <utility>

#include "by_hash.hpp"

namespace quadmatch::regions {
namespace {

constexpr std::uint32_t kRounds = 8;
constexpr std::uint32_t kNone = 0xffffffff;

/// Spokes of which both meshes have one alike, and for how many rounds they look alike.
struct UniquePair {
  std::uint32_t source;
  std::uint32_t target;
  std::uint32_t rounds;
  Colour colour;
};

struct ColouredSpoke {
  Colour colour;
  std::uint32_t spoke;

  bool operator<(const ColouredSpoke& other) const {
    return colour != other.colour ? colour < other.colour : spoke < other.spoke;
  }
};

/// All spokes of some round, in order of colour.
std::vector<ColouredSpoke> coloured(const std::vector<std::uint32_t>& spokes, const std::vector<Colour>& colours) {
  std::vector<ColouredSpoke> result;
  result.reserve(spokes.size());
  for (const std::uint32_t spoke : spokes) result.push_back({colours[spoke], spoke});
  sort_by_hash(result, [](const ColouredSpoke& spoke) { return spoke.colour; });
  return result;
}

/// For how many rounds two spokes look alike.
std::uint32_t rounds_alike(const SpokeColours& source, std::uint32_t s, const SpokeColours& target, std::uint32_t t,
                           std::uint32_t from) {
  std::uint32_t round = from;
  while (round < source.last() && source.rounds[round + 1][s] == target.rounds[round + 1][t]) ++round;
  return round;
}

/// Find the pairs unique after some round, from `from` on. A colour that is unique stays so, and one that is in one
/// mesh only never comes to the other: each round looks only at what the last one left undecided.
std::vector<UniquePair> unique_pairs(const SpokeColours& source, std::vector<std::uint32_t> source_spokes,
                                     const SpokeColours& target, std::vector<std::uint32_t> target_spokes,
                                     std::uint32_t from) {
  std::vector<UniquePair> pairs;
  for (std::uint32_t round = from; round <= source.last() && !source_spokes.empty(); ++round) {
    const std::vector<ColouredSpoke> left = coloured(source_spokes, source.rounds[round]);
    const std::vector<ColouredSpoke> right = coloured(target_spokes, target.rounds[round]);
    source_spokes.clear();
    target_spokes.clear();
    for (std::size_t i = 0, j = 0; i < left.size() && j < right.size();) {
      const Colour colour = std::max(left[i].colour, right[j].colour);
      while (i < left.size() && left[i].colour < colour) ++i;
      while (j < right.size() && right[j].colour < colour) ++j;
      if (i == left.size() || j == right.size() || left[i].colour != right[j].colour) continue;
      std::size_t i_end = i, j_end = j;
      while (i_end < left.size() && left[i_end].colour == left[i].colour) ++i_end;
      while (j_end < right.size() && right[j_end].colour == left[i].colour) ++j_end;
      if (i_end - i == 1 && j_end - j == 1) {
        const std::uint32_t s = left[i].spoke, t = right[j].spoke;
        pairs.push_back({s, t, rounds_alike(source, s, target, t, round), left[i].colour});
      } else {
        for (std::size_t k = i; k < i_end; ++k) source_spokes.push_back(left[k].spoke);
        for (std::size_t k = j; k < j_end; ++k) target_spokes.push_back(right[k].spoke);
      }
      i = i_end;
      j = j_end;
    }
  }
  return pairs;
}

/// Which spoke is thought to lie on which.
using SpokeMap = std::vector<std::uint32_t>;

/// The neighbours about the vertex and the opposite end of the arc.
struct Neighbours {
  std::uint32_t spokes[3];
};

Neighbours neighbours_of(const Side& side, std::uint32_t node, std::uint32_t spoke) {
  const ArcGraph& graph = side.separatrices;
  const std::uint32_t first = graph.first_spoke[node], last = graph.first_spoke[node + 1] - 1;
  const bool cyclic = !side.codes[graph.nodes[node]].on_boundary();
  const std::uint32_t ccw = spoke < last ? spoke + 1 : cyclic ? first : kNone;
  const std::uint32_t cw = spoke > first ? spoke - 1 : cyclic ? last : kNone;
  return {{ccw, cw, graph.spokes[spoke].to_spoke}};
}

struct Support {
  std::uint32_t agree = 0, disagree = 0;
};

Support support_of(const SpokeMap& map, const Neighbours& left, const Neighbours& right) {
  Support support;
  for (int k = 0; k < 3; ++k) {
    if (left.spokes[k] == kNone || map[left.spokes[k]] == kNone) continue;
    ++(map[left.spokes[k]] == right.spokes[k] ? support.agree : support.disagree);
  }
  return support;
}

std::vector<std::uint32_t> node_of_spokes(const ArcGraph& graph) {
  std::vector<std::uint32_t> node_of(graph.spokes.size());
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    std::fill(node_of.begin() + graph.first_spoke[node], node_of.begin() + graph.first_spoke[node + 1], node);
  }
  return node_of;
}

template <class IsFree>
std::vector<std::uint32_t> free_spokes(const ArcGraph& graph, IsFree is_free) {
  std::vector<std::uint32_t> spokes;
  for (std::uint32_t spoke = 0; spoke < graph.spokes.size(); ++spoke) {
    if (is_free(graph.spokes[spoke].start.halfedge)) spokes.push_back(spoke);
  }
  return spokes;
}

/// A spark to be, with what it is ordered by.
struct Ranked {
  std::uint32_t handicap;
  Colour colour;
  std::uint32_t source, target;
};

class Ignition {
 public:
  Ignition(const Sides& sides, const ColouredSpokes& with_lengths, const ColouredSpokes& without,
           const Patchwork& patchwork)
      : sides_(sides),
        source_nodes_(node_of_spokes(sides.source.separatrices)),
        target_nodes_(node_of_spokes(sides.target.separatrices)) {
    const auto left = free_spokes(sides.source.separatrices,
                                  [&](HalfedgeId h) { return !patchwork.is_matched(sides.source.mesh.face(h)); });
    const auto right = free_spokes(sides.target.separatrices,
                                   [&](HalfedgeId h) { return !patchwork.is_taken(sides.target.mesh.face(h)); });
    with_lengths_ = unique_pairs(with_lengths.source, left, with_lengths.target, right, 2);
    without_ = unique_pairs(without.source, left, without.target, right, 2);
  }

  std::vector<Spark> sparks(Caution caution) {
    const bool low = caution == Caution::Low;
    SpokeMap map(sides_.source.separatrices.spokes.size(), kNone);
    for (const UniquePair& pair : without_) map[pair.source] = pair.target;
    for (const UniquePair& pair : with_lengths_) map[pair.source] = pair.target;
    for (const UniquePair& pair : with_lengths_) {
      if (pair.rounds >= 3) {
        propose(pair, kRounds - pair.rounds);
      } else if (low) {
        propose(pair, 120);
      } else if (is_supported(pair, map)) {
        propose(pair, 40);
      }
    }
    for (const UniquePair& pair : without_) {
      if (pair.rounds < (low ? 3 : 4) || !is_supported(pair, map)) continue;
      propose(pair, (pair.rounds >= 4 ? 8 : 120) + kRounds - pair.rounds);
    }
    return chosen();
  }

 private:
  [[nodiscard]] bool is_supported(const UniquePair& pair, const SpokeMap& map) const {
    const Support support = support_of(map, neighbours_of(sides_.source, source_nodes_[pair.source], pair.source),
                                       neighbours_of(sides_.target, target_nodes_[pair.target], pair.target));
    return support.agree >= 2 && support.disagree == 0;
  }
  void propose(const UniquePair& pair, std::uint32_t handicap) {
    const Dart s = sides_.source.separatrices.spokes[pair.source].start;
    const Dart t = sides_.target.separatrices.spokes[pair.target].start;
    if (s.backward == t.backward) ranked_.push_back({handicap, pair.colour, pair.source, pair.target});
  }
  /// The best for each vertex.
  std::vector<Spark> chosen() {
    std::sort(ranked_.begin(), ranked_.end(), [](const Ranked& a, const Ranked& b) {
      return a.handicap != b.handicap ? a.handicap < b.handicap : a.colour < b.colour;
    });
    std::vector<bool> source_taken(sides_.source.separatrices.node_count(), false);
    std::vector<bool> target_taken(sides_.target.separatrices.node_count(), false);
    std::vector<Spark> sparks;
    for (const Ranked& ranked : ranked_) {
      const std::uint32_t node = source_nodes_[ranked.source], other = target_nodes_[ranked.target];
      if (source_taken[node] || target_taken[other]) continue;
      source_taken[node] = target_taken[other] = true;
      sparks.push_back({{sides_.source.separatrices.spokes[ranked.source].start.halfedge,
                         sides_.target.separatrices.spokes[ranked.target].start.halfedge},
                        ranked.handicap});
    }
    return sparks;
  }

  const Sides& sides_;
  std::vector<std::uint32_t> source_nodes_, target_nodes_;
  std::vector<UniquePair> with_lengths_, without_;
  std::vector<Ranked> ranked_;
};

}  // namespace

ColouredSpokes colour_both(const Sides& sides, bool arc_lengths) {
  const auto colour = [arc_lengths](const Side& side) {
    return colour_spokes(side.separatrices, side.codes, kRounds, {.arc_lengths = arc_lengths});
  };
  return {colour(sides.source), colour(sides.target)};
}

std::vector<Spark> find_sparks(const Sides& sides, const ColouredSpokes& with_lengths, const ColouredSpokes& without,
                               const Patchwork& patchwork, Caution caution) {
  return Ignition(sides, with_lengths, without, patchwork).sparks(caution);
}

}  // namespace quadmatch::regions
