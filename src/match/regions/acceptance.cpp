// The last judgement: a region stays if chance could not agree so often, or if neighbours that stay speak for it.

#include <algorithm>
#include <optional>
#include <vector>

#include "hops.hpp"
#include "likelihood.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

constexpr double kVote = 2.5, kHopVote = 2.0;

/// What the matched faces around a region say of it.
struct Testimony {
  std::uint32_t votes = 0;      ///< edges of the rim beyond which a face of another region lies as it should
  std::uint32_t hop_votes = 0;  ///< the same, beyond one or two quads that only one mesh has
  bool whole_component = true;  ///< nothing is beyond the rim, in either mesh
};

class Judge {
 public:
  explicit Judge(Workbench& bench) : bench_(bench), believed_(bench.patchwork.region_count(), false) {}

  void believe(std::uint32_t region) { believed_[region] = true; }
  /// By its own evidence and what believed regions say of it. Each of these is enough; the cheapest first.
  [[nodiscard]] bool believes(const std::vector<Candidate>& pairs) {
    if (has_evidence(pairs) || is_pinned(pairs)) return true;
    const Testimony testimony = hear(pairs);
    if (testimony.votes + 0.67 * testimony.hop_votes >= 2) return true;
    if (testimony.whole_component && disagreeing(pairs) == 0) return true;
    if (!likelihood_) likelihood_.emplace(bench_, true);
    const double needed = likelihood_->log_places() * (bench_.misfit.uses_lengths() ? 1 : 2);
    return likelihood_->of(pairs) + kVote * testimony.votes + kHopVote * testimony.hop_votes >= needed;
  }

 private:
  [[nodiscard]] Testimony hear(const std::vector<Candidate>& pairs) const {
    Testimony testimony;
    const std::uint32_t region = bench_.patchwork.region(source_.face(pairs.front().source));
    for (const Candidate& pair : pairs) {
      auto [s, t] = pair;
      do {
        const HalfedgeId beside = source_.twin(s), beside_target = target_.twin(t);
        const bool matched = beside.valid() && bench_.patchwork.is_matched(source_.face(beside));
        if (!matched || bench_.patchwork.region(source_.face(beside)) != region) {
          testimony.whole_component = testimony.whole_component && !beside.valid() && !beside_target.valid();
          if (matched && bench_.patchwork.image(beside) == beside_target) {
            testimony.votes += believed_[bench_.patchwork.region(source_.face(beside))];
          } else if (agrees_after_hop(bench_, {s, t}, [&](std::uint32_t other) { return believed_[other]; })) {
            ++testimony.hop_votes;
          }
        }
        s = source_.next(s);
        t = target_.next(t);
      } while (s != pair.source);
    }
    return testimony;
  }
  [[nodiscard]] bool is_pinned(const std::vector<Candidate>& pairs) const {
    const std::vector<Candidate>& pins = bench_.misfit.pins();
    return std::any_of(pins.begin(), pins.end(), [&](const Candidate& pin) {
      return std::any_of(pairs.begin(), pairs.end(),
                         [&](const Candidate& pair) { return source_.face(pair.source) == source_.face(pin.source); });
    });
  }
  [[nodiscard]] std::uint32_t disagreeing(const std::vector<Candidate>& pairs) const {
    std::uint32_t corners = 0;
    for (const Candidate& pair : pairs) corners += bench_.misfit.disagreeing_corners(pair);
    return corners;
  }
  /// Many agreeing extraordinary vertices are enough, and at least as many as disagree: counted by corners here, which
  /// is as good.
  [[nodiscard]] bool has_evidence(const std::vector<Candidate>& pairs) const {
    std::uint32_t agreeing = 0, source_extraordinary = 0, target_extraordinary = 0;
    for (const Candidate& pair : pairs) {
      auto [s, t] = pair;
      do {
        const VertexCode left = bench_.sides.source.code(source_.origin(s));
        const VertexCode right = bench_.sides.target.code(target_.origin(t));
        source_extraordinary += left.extraordinary();
        target_extraordinary += right.extraordinary();
        agreeing += left.extraordinary() && left == right;
        s = source_.next(s);
        t = target_.next(t);
      } while (s != pair.source);
    }
    return agreeing >= 20 && 2 * agreeing >= std::min(source_extraordinary, target_extraordinary);
  }

  Workbench& bench_;
  std::optional<Likelihood> likelihood_;  // learnt when it is first asked
  std::vector<bool> believed_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
};

/// Regions that stand or fall together.
using Group = std::vector<std::uint32_t>;

/// Slivers side by side are regions of their own, but one piece of evidence: put those together that agree across their
/// common edges.
std::vector<Group> grouped(const Workbench& bench, const std::vector<std::vector<HalfedgeId>>& faces,
                           const std::vector<Group>& doubtful) {
  const Mesh& source = bench.sides.source.mesh;
  const Mesh& target = bench.sides.target.mesh;
  constexpr std::uint32_t kNone = 0xffffffff;
  std::vector<std::uint32_t> group_of(faces.size(), kNone);
  std::vector<Group> groups;
  for (const Group& single : doubtful) {
    group_of[single.front()] = static_cast<std::uint32_t>(groups.size());
    groups.push_back(single);
  }
  for (const Group& single : doubtful) {
    for (const HalfedgeId entry : faces[single.front()]) {
      for (const HalfedgeId h : source.halfedges(source.face(entry))) {
        const HalfedgeId beside = source.twin(h);
        if (!beside.valid() || !bench.patchwork.is_matched(source.face(beside))) continue;
        const std::uint32_t one = group_of[single.front()];
        const std::uint32_t other = group_of[bench.patchwork.region(source.face(beside))];
        if (other == kNone || other == one || bench.patchwork.image(beside) != target.twin(bench.patchwork.image(h))) {
          continue;
        }
        for (const std::uint32_t region : groups[other]) group_of[region] = one;
        groups[one].insert(groups[one].end(), groups[other].begin(), groups[other].end());
        groups[other].clear();
      }
    }
  }
  std::erase_if(groups, [](const Group& group) { return group.empty(); });
  return groups;
}

}  // namespace

std::size_t drop_unlikely(Workbench& bench) {
  const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench);
  Judge judge(bench);
  std::vector<Group> doubtful;
  for (const auto& [region, count] : largest_first(bench.patchwork)) doubtful.push_back({region});
  const auto judge_all = [&] {
    std::vector<Candidate> pairs;
    // Belief spreads from region to region. Garbage speaks for garbage, so only what is believed is heard.
    for (std::size_t before = doubtful.size() + 1; doubtful.size() < before;) {
      before = doubtful.size();
      std::erase_if(doubtful, [&](const Group& group) {
        pairs.clear();
        for (const std::uint32_t region : group) {
          for (const HalfedgeId entry : faces[region]) pairs.push_back({entry, bench.patchwork.image(entry)});
        }
        const bool believed = judge.believes(pairs);
        for (const std::uint32_t region : group) {
          if (believed) judge.believe(region);
        }
        return believed;
      });
    }
  };
  judge_all();
  doubtful = grouped(bench, faces, doubtful);
  judge_all();
  std::size_t dropped = 0;
  for (const Group& group : doubtful) {
    for (const std::uint32_t region : group) {
      for (const HalfedgeId entry : faces[region]) bench.patchwork.lift(bench.sides.source.mesh.face(entry));
      dropped += faces[region].size();
    }
  }
  return dropped;
}

}  // namespace quadmatch::regions
