// The last judgement: a region stays if chance could not agree so often, or if neighbours that stay speak for it.

#include <algorithm>
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
  bool fills_gap = true;        ///< or only faces of believed regions, in both: what they left free is this, in both
};

/// Regions that stand or fall together.
using Group = std::vector<std::uint32_t>;

/// Corners at which an extraordinary vertex of a region is, in either mesh, and those where the codes agree.
struct Corners {
  std::uint32_t agreeing = 0, source_extraordinary = 0, target_extraordinary = 0;
};

/// Calls visit(h) for every half-edge that leaves an extraordinary vertex.
template <class Visit>
void for_each_telling_corner(const Side& side, Visit visit) {
  for (std::uint32_t fan = 0; fan < side.mesh.fan_count(); ++fan) {
    if (!side.code(side.mesh.vertex(FanId(fan))).extraordinary() || !side.mesh.halfedge(FanId(fan)).valid()) continue;
    for (const HalfedgeId h : side.mesh.outgoing(FanId(fan))) visit(h);
  }
}

std::vector<Corners> corners_by_region(const Sides& sides, const Patchwork& patchwork) {
  std::vector<Corners> corners(patchwork.region_count());
  for_each_telling_corner(sides.source, [&](HalfedgeId h) {
    const FaceId face = sides.source.mesh.face(h);
    if (!patchwork.is_matched(face)) return;
    const VertexId v = sides.source.mesh.origin(h), w = sides.target.mesh.origin(patchwork.image(h));
    Corners& here = corners[patchwork.region(face)];
    ++here.source_extraordinary;
    here.agreeing += sides.source.code(v) == sides.target.code(w);
  });
  for_each_telling_corner(sides.target, [&](HalfedgeId h) {
    const FaceId origin = patchwork.origin(sides.target.mesh.face(h));
    if (origin.valid()) ++corners[patchwork.region(origin)].target_extraordinary;
  });
  return corners;
}

class Judge {
 public:
  explicit Judge(Workbench& bench)
      : bench_(bench),
        corners_(corners_by_region(bench.sides, bench.patchwork)),
        likelihood_(bench, true),
        believed_(bench.patchwork.region_count(), false) {}

  void believe(const Group& group) {
    for (const std::uint32_t region : group) believed_[region] = true;
  }
  /// Many agreeing extraordinary vertices are enough, and at least as many as disagree: counted by corners here, which
  /// is as good.
  [[nodiscard]] bool has_evidence(const Group& group) const {
    Corners sum;
    for (const std::uint32_t region : group) {
      sum.agreeing += corners_[region].agreeing;
      sum.source_extraordinary += corners_[region].source_extraordinary;
      sum.target_extraordinary += corners_[region].target_extraordinary;
    }
    return sum.agreeing >= 20 && 2 * sum.agreeing >= std::min(sum.source_extraordinary, sum.target_extraordinary);
  }
  /// By its own evidence and what believed regions say of it. Each of these is enough; the cheapest first.
  /// @param pairs  of the group.
  [[nodiscard]] bool believes(const Group& group, const std::vector<Candidate>& pairs) {
    if (has_evidence(group) || is_pinned(pairs)) return true;
    const Testimony testimony = hear(pairs);
    if (testimony.votes + 0.67 * testimony.hop_votes >= 2) return true;
    if ((testimony.whole_component || testimony.fills_gap) && disagreeing(pairs) == 0) return true;
    const double needed = likelihood_.log_places() * (bench_.misfit.uses_lengths() ? 1 : 2);
    const auto is_enough = [&](double says) {
      return says + kVote * testimony.votes + kHopVote * testimony.hop_votes >= needed;
    };
    return is_enough(likelihood_.at_most(pairs)) && is_enough(likelihood_.of(pairs));
  }

 private:
  [[nodiscard]] Testimony hear(const std::vector<Candidate>& pairs) const {
    Testimony testimony;
    const Patchwork& patchwork = bench_.patchwork;
    const std::uint32_t region = bench_.patchwork.region(source_.face(pairs.front().source));
    for (const Candidate& pair : pairs) {
      auto [s, t] = pair;
      do {
        const HalfedgeId beside = source_.twin(s), beside_target = target_.twin(t);
        const bool matched = beside.valid() && bench_.patchwork.is_matched(source_.face(beside));
        if (!matched || bench_.patchwork.region(source_.face(beside)) != region) {
          testimony.whole_component = testimony.whole_component && !beside.valid() && !beside_target.valid();
          testimony.fills_gap = testimony.fills_gap && beside.valid() == beside_target.valid() &&
                                (!beside.valid() || (is_believed(source_.face(beside)) &&
                                                     is_believed(patchwork.origin(target_.face(beside_target)))));
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
  /// @param face  of the source, or none
  [[nodiscard]] bool is_believed(FaceId face) const {
    return face.valid() && bench_.patchwork.is_matched(face) && believed_[bench_.patchwork.region(face)];
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

  Workbench& bench_;
  std::vector<Corners> corners_;
  Likelihood likelihood_;
  std::vector<bool> believed_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
};

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
  Judge judge(bench);
  std::vector<SizedRegion> regions = largest_first(bench.patchwork);
  std::erase_if(regions, [&](const SizedRegion& region) {
    const bool has_evidence = judge.has_evidence({region.number});
    if (has_evidence) judge.believe({region.number});
    return has_evidence;
  });
  const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench, regions);
  std::vector<Group> doubtful;
  for (const SizedRegion& region : regions) doubtful.push_back({region.number});
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
        const bool believed = judge.believes(group, pairs);
        if (believed) judge.believe(group);
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
