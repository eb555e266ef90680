#include <algorithm>
#include <cstdint>
#include <queue>
#include <vector>

#include "mending.hpp"

namespace quadmatch::regions {
namespace {

/// What a face must be worth. Without lengths nothing but its neighbours can speak for it, and corners beside an edit
/// speak against it: one neighbour and two such corners are enough.
constexpr double kLeastWorth = 1.0, kLeastWithoutLengths = 0.5;

/// An unmatched face beside matched ones, laid where a neighbour says.
struct Proposal {
  double worth;
  std::uint64_t number;  // earlier ones first among equals
  Candidate pair;

  bool operator<(const Proposal& other) const {
    return worth != other.worth ? worth < other.worth : number > other.number;
  }
};

class Slivers {
 public:
  Slivers(Workbench& bench, bool generous)
      : bench_(bench), least_worth_(generous && !bench.misfit.uses_lengths() ? kLeastWithoutLengths : kLeastWorth) {}

  std::size_t match() {
    const std::size_t before = patchwork_.matched_faces();
    for (const HalfedgeId entry : bench_.rim.entries()) propose_neighbours(entry);
    while (!proposals_.empty()) {
      const Proposal best = proposals_.top();
      proposals_.pop();
      if (!is_free(best.pair)) continue;
      const double worth = worth_of(best.pair);
      if (worth < best.worth) {  // a neighbour has since been laid elsewhere
        if (worth >= least_worth_) proposals_.push({worth, best.number, best.pair});
        continue;
      }
      patchwork_.lay(best.pair, region_for(best.pair));
      propose_neighbours(best.pair.source);
    }
    return patchwork_.matched_faces() - before;
  }

 private:
  [[nodiscard]] bool is_free(Candidate pair) const {
    return !patchwork_.is_matched(source_.face(pair.source)) && !patchwork_.is_taken(target_.face(pair.target));
  }
  void propose_neighbours(HalfedgeId entry) {
    HalfedgeId s = entry, t = patchwork_.image(entry);
    do {
      const Candidate beyond{source_.twin(s), target_.twin(t)};
      if (beyond.source.valid() && beyond.target.valid() && is_free(beyond) &&
          source_.size(source_.face(beyond.source)) == target_.size(target_.face(beyond.target))) {
        if (const double worth = worth_of(beyond); worth >= least_worth_) proposals_.push({worth, count_++, beyond});
      }
      s = source_.next(s);
      t = target_.next(t);
    } while (s != entry);
  }
  /// A vote for each neighbour that would be a neighbour still, less what speaks against. Lengths that fit speak for a
  /// pair; those that do not say nothing, since beside an edit they seldom do.
  [[nodiscard]] double worth_of(Candidate pair) const {
    double worth = 0;
    auto [s, t] = pair;
    do {
      const Beyond beyond = patchwork_.beyond(s, t);
      worth += beyond == Beyond::InPlace ? 1.0 : beyond == Beyond::Elsewhere ? -0.5 : 0;
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
    if (bench_.misfit.uses_lengths()) worth += 1 - std::min(1.0, bench_.misfit.length_error(pair) / 2);
    return worth - 0.25 * bench_.misfit.disagreeing_corners(pair);
  }
  /// The region of a neighbour that can take the face in, or one of its own.
  [[nodiscard]] std::uint32_t region_for(Candidate pair) {
    auto [s, t] = pair;
    do {
      if (patchwork_.beyond(s, t) == Beyond::InPlace) {
        const std::uint32_t region = patchwork_.region(source_.face(source_.twin(s)));
        bench_.ghost.restart(region);
        if (bench_.ghost.fits(pair)) return region;
      }
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
    return patchwork_.fresh_region();
  }

  Workbench& bench_;
  double least_worth_;
  Patchwork& patchwork_ = bench_.patchwork;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  std::priority_queue<Proposal> proposals_;
  std::uint64_t count_ = 0;
};

}  // namespace

std::size_t match_slivers(Workbench& bench, bool generous) { return Slivers(bench, generous).match(); }

}  // namespace quadmatch::regions
