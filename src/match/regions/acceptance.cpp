// The last judgement: a region stays if chance could not agree so often, or if its neighbours speak for it.

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
};

class Judge {
 public:
  Judge(Workbench& bench, Likelihood& likelihood) : bench_(bench), likelihood_(likelihood) {}

  [[nodiscard]] bool believes(const std::vector<Candidate>& pairs) {
    const Testimony testimony = hear(pairs);
    const double speaks = likelihood_.of(pairs);
    const double needed = likelihood_.log_places() * (bench_.misfit.uses_lengths() ? 1 : 2);
    if (speaks + kVote * testimony.votes + kHopVote * testimony.hop_votes >= needed) return true;
    if (testimony.whole_component && disagreeing(pairs) == 0) return true;
    if (testimony.votes + 0.67 * testimony.hop_votes >= 2) return true;
    return !bench_.misfit.uses_lengths() && has_evidence(pairs);
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
            ++testimony.votes;
          } else if (agrees_after_hop(bench_, {s, t})) {
            ++testimony.hop_votes;
          }
        }
        s = source_.next(s);
        t = target_.next(t);
      } while (s != pair.source);
    }
    return testimony;
  }
  [[nodiscard]] std::uint32_t disagreeing(const std::vector<Candidate>& pairs) const {
    std::uint32_t corners = 0;
    for (const Candidate& pair : pairs) corners += bench_.misfit.disagreeing_corners(pair);
    return corners;
  }
  /// Without lengths, many agreeing extraordinary vertices are enough: counted by corners here, which is as good.
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
  Likelihood& likelihood_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
};

}  // namespace

std::size_t drop_unlikely(Workbench& bench, Likelihood& likelihood) {
  const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench);
  Judge judge(bench, likelihood);
  std::size_t dropped = 0;
  std::vector<std::uint32_t> doubtful;
  std::vector<Candidate> pairs;
  for (const std::uint32_t region : largest_first(faces)) {
    pairs.clear();
    for (const HalfedgeId entry : faces[region]) pairs.push_back({entry, bench.patchwork.image(entry)});
    if (!judge.believes(pairs)) doubtful.push_back(region);
  }
  for (const std::uint32_t region : doubtful) {
    for (const HalfedgeId entry : faces[region]) bench.patchwork.lift(bench.sides.source.mesh.face(entry));
    dropped += faces[region].size();
  }
  return dropped;
}

}  // namespace quadmatch::regions
