// Slides: a ring matched one step round is as sound as the right one, and only lengths tell. Where faces fit badly, the
// map moved by one quad in each direction is offered. Without lengths that is done where corners disagree: one quad on,
// an extraordinary vertex may lie on one of the same code.

#include <cstdint>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

constexpr double kBad = 3.0;  // in sigma
constexpr double kGood = 1.0;
constexpr double kNear = 0.3;  // in edges
/// Beyond a twisted ring a third and more of the faces that fit badly fit one quad on, in a pose hardly any.
constexpr double kExplains = 0.25;
/// A shift is tried where it lets the error about a face fall to this share.
constexpr double kFalls = 0.8, kFallsWithoutLengths = 0.7;
/// Without lengths: what the sum of all costs must fall by, so that not every extraordinary vertex that an edit made is
/// reason enough to tear a region apart; and what a corner counts where both are extraordinary and agree, when one that
/// disagrees counts 1.
constexpr double kLeastGain = 6.0, kTelling = 2.0;

class Slides {
 public:
  explicit Slides(Workbench& bench) : bench_(bench), tried_(source_.face_count(), false) {}

  /// Of the faces whose lengths fit badly, or that land elsewhere than their image, the share that fits one quad on.
  [[nodiscard]] double explained() const {
    std::size_t bad = 0, good = 0;
    for (const HalfedgeId entry : bench_.patchwork.history()) {
      const Candidate now{entry, bench_.patchwork.image(entry)};
      if (bench_.misfit.length_error(now) <= kBad && lands_near(now)) continue;
      ++bad;
      good += for_any_shift(now, [&](const Candidate& shifted) {
        return bench_.misfit.length_error(shifted) <= kGood && lands_near(shifted);
      });
    }
    return bad == 0 ? 0.0 : static_cast<double>(good) / static_cast<double>(bad);
  }

  std::size_t undo() {
    std::size_t changed = 0;
    const std::vector<HalfedgeId> history = bench_.patchwork.history();
    for (const HalfedgeId entry : history) {
      if (!is_bad(entry) || tried_[source_.face(entry)]) continue;
      for (const Candidate& shifted : better_shifts(entry)) {
        if (spent_ > budget_) return changed;
        changed += lay(shifted);
      }
    }
    return changed;
  }

 private:
  /// Do lengths fit badly? Where a face lands on its image they only say that the edit is near.
  [[nodiscard]] bool is_bad(HalfedgeId entry) const {
    if (!bench_.patchwork.is_matched(source_.face(entry))) return false;
    const Candidate pair{entry, bench_.patchwork.image(entry)};
    if (!bench_.misfit.uses_lengths()) return bench_.misfit.disagreeing_corners(pair) > 0;
    if (bench_.misfit.is_placed() && lands_near(pair)) return false;
    return bench_.misfit.length_error(pair) > kBad;
  }
  /// True as well where nobody knows where the source lies.
  [[nodiscard]] bool lands_near(Candidate pair) const {
    return !bench_.misfit.is_placed() || bench_.misfit.distance(pair) <= kNear;
  }
  /// Visit a face on each quad beside its image, until a visit says yes.
  template <class Visit>
  bool for_any_shift(Candidate now, Visit visit) const {
    HalfedgeId s = now.source, t = now.target;
    do {
      const HalfedgeId beyond = target_.twin(t);
      if (beyond.valid() && target_.size(target_.face(beyond)) == 4 && source_.size(source_.face(s)) == 4 &&
          visit(Candidate{s, target_.next(target_.next(beyond))})) {
        return true;
      }
      s = source_.next(s);
      t = target_.next(t);
    } while (s != now.source);
    return false;
  }
  [[nodiscard]] std::vector<Candidate> better_shifts(HalfedgeId entry) const {
    const Candidate now{entry, bench_.patchwork.image(entry)};
    const double enough = falls_ * error_about(now);
    std::vector<Candidate> shifts;
    for_any_shift(now, [&](const Candidate& shifted) {
      if (error_about(shifted) < enough) shifts.push_back(shifted);
      return false;
    });
    return shifts;
  }
  /// Of lengths; or of corners, raised so that it is positive almost everywhere.
  [[nodiscard]] double error_of(Candidate pair) const {
    if (bench_.misfit.uses_lengths()) return bench_.misfit.length_error(pair);
    return 4.0 + bench_.misfit.disagreeing_corners(pair) - kTelling * bench_.misfit.telling_corners(pair);
  }
  /// The mean error of a pair and of those beside it.
  [[nodiscard]] double error_about(Candidate pair) const {
    double sum = error_of(pair);
    int count = 1;
    auto [s, t] = pair;
    do {
      const Candidate beside{source_.twin(s), target_.twin(t)};
      if (beside.source.valid() && beside.target.valid() &&
          source_.size(source_.face(beside.source)) == target_.size(target_.face(beside.target))) {
        sum += error_of(beside);
        ++count;
      }
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
    return sum / count;
  }
  std::size_t lay(Candidate seed) {
    if (!extend_seed(bench_, seed, kSeedFaces)) return 0;
    for (const Candidate& pair : bench_.ghost.pairs()) tried_[source_.face(pair.source)] = true;
    spent_ += kSeedCost + bench_.ghost.pairs().size();
    return expand(bench_, bench_.patchwork.fresh_region(), bench_.misfit.uses_lengths() ? 0 : kLeastGain);
  }

  Workbench& bench_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  double falls_ = bench_.misfit.uses_lengths() ? kFalls : kFallsWithoutLengths;
  PerFace<bool> tried_;
  std::size_t budget_ = kSeedsBudget * source_.face_count(), spent_ = 0;
};

}  // namespace

bool slides_explain(Workbench& bench) { return Slides(bench).explained() > kExplains; }

std::size_t undo_slides(Workbench& bench) {
  const std::size_t changed = Slides(bench).undo();
  bench.ghost.restart();
  return changed;
}

}  // namespace quadmatch::regions
