// Where a free part has no rare corner, its lengths may tell: the innermost faces of each free area are tried against
// the free faces of the target whose lengths, and those of their neighbours, fit best.

#include <algorithm>
#include <cstdint>
#include <vector>

#include "likelihood.hpp"
#include "mending.hpp"
#include "trial.hpp"

namespace quadmatch::regions {
namespace {

/// Smaller areas say too little.
constexpr std::size_t kLeastArea = 4;
/// Faces tried at most of one area, and partners grown for each.
constexpr int kMostPerArea = 6;
constexpr std::size_t kMostPartners = 4;
/// A trial of this many faces tells; only what is kept grows on.
constexpr std::size_t kTrialFaces = 200;
/// A partner must fit so well, in sigma: the face itself, then with its neighbours.
constexpr double kFits = 3.0;
/// Pairs of faces compared and faces grown at most, by faces of the source.
constexpr std::size_t kBudget = 30;
/// The best trial must beat the next by this much.
constexpr double kMargin = 1.0;

struct Partner {
  double error;
  Candidate pair;

  bool operator<(const Partner& other) const { return error < other.error; }
};

class Lookalikes {
 public:
  explicit Lookalikes(Workbench& bench)
      : bench_(bench),
        likelihood_(bench),
        depth_(source_.face_count(), 0),
        tried_(source_.face_count(), false),
        budget_(kBudget * source_.face_count()) {
    for (std::uint32_t f = 0; f < target_.face_count(); ++f) {
      if (!bench.patchwork.is_taken(FaceId(f))) free_targets_.push_back(FaceId(f));
    }
  }

  std::size_t match() {
    const std::size_t before = bench_.patchwork.matched_faces();
    for (const std::vector<FaceId>& area : areas()) {
      int tries = 0;
      for (const FaceId face : area) {
        if (tries == kMostPerArea || spent_ > budget_) break;
        if (tried_[face] || bench_.patchwork.is_matched(face)) continue;
        ++tries;
        try_face(face);
      }
    }
    bench_.ghost.restart();
    return bench_.patchwork.matched_faces() - before;
  }

 private:
  [[nodiscard]] bool is_free(FaceId face) const { return !bench_.patchwork.is_matched(face); }

  /// The free areas of the source, the largest first; the faces of each from the innermost to the rim.
  [[nodiscard]] std::vector<std::vector<FaceId>> areas() {
    measure_depth();
    std::vector<std::vector<FaceId>> result;
    PerFace<bool> listed(source_.face_count(), false);
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      if (!is_free(FaceId(f)) || listed[FaceId(f)]) continue;
      std::vector<FaceId> area{FaceId(f)};
      listed[FaceId(f)] = true;
      for (std::size_t here = 0; here < area.size(); ++here) {
        for (const HalfedgeId h : source_.halfedges(area[here])) {
          const HalfedgeId beside = source_.twin(h);
          if (!beside.valid() || listed[source_.face(beside)] || !is_free(source_.face(beside))) continue;
          listed[source_.face(beside)] = true;
          area.push_back(source_.face(beside));
        }
      }
      if (area.size() < kLeastArea) continue;
      std::stable_sort(area.begin(), area.end(), [&](FaceId a, FaceId b) { return depth_[a] > depth_[b]; });
      result.push_back(std::move(area));
    }
    std::stable_sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
    return result;
  }
  /// How many faces a free face is from what is not free.
  void measure_depth() {
    std::vector<FaceId> rim, next;
    const auto reach = [&](FaceId face, std::uint32_t depth) {
      if (!is_free(face) || depth_[face] > 0) return;
      depth_[face] = depth;
      next.push_back(face);
    };
    for (std::uint32_t f = 0; f < source_.face_count(); ++f) {
      for (const HalfedgeId h : source_.halfedges(FaceId(f))) {
        const HalfedgeId beside = source_.twin(h);
        if (!beside.valid() || !is_free(source_.face(beside))) reach(FaceId(f), 1);
      }
    }
    for (std::uint32_t depth = 2; !next.empty(); ++depth) {
      rim.swap(next);
      next.clear();
      for (const FaceId face : rim) {
        for (const HalfedgeId h : source_.halfedges(face)) {
          if (const HalfedgeId beside = source_.twin(h); beside.valid()) reach(source_.face(beside), depth);
        }
      }
    }
  }

  void try_face(FaceId face) {
    Candidate best{};
    double worth = 0, next_worth = 0;
    for (const Partner& partner : best_partners(source_.first(face))) {
      if (!grow_trial(bench_, partner.pair, {.most_faces = kTrialFaces})) continue;
      spent_ += bench_.ghost.pairs().size();
      const double worth_now = likelihood_.of_best_start(bench_.ghost.pairs());
      if (worth_now > worth) {
        next_worth = worth;
        worth = worth_now;
        best = partner.pair;
        best_faces_ = bench_.ghost.pairs();
      } else {
        next_worth = std::max(next_worth, worth_now);
      }
    }
    if (worth >= likelihood_.needed_for_trial() && worth >= next_worth + kMargin) {
      grow_trial(bench_, best, {.most_faces = source_.face_count()});
      keep_trial(bench_);
    } else if (worth > 0) {
      for (const Candidate& pair : best_faces_) tried_[source_.face(pair.source)] = true;
    }
  }

  [[nodiscard]] std::vector<Partner> best_partners(HalfedgeId s) {
    std::vector<Partner> partners;
    for (const FaceId other : free_targets_) {
      if (bench_.patchwork.is_taken(other) || target_.size(other) != source_.size(source_.face(s))) continue;
      for (const HalfedgeId t : target_.halfedges(other)) {
        if (bench_.misfit.disagreeing_corners({s, t}) == 0 && bench_.misfit.length_error({s, t}) < kFits) {
          partners.push_back({0, {s, t}});
        }
      }
    }
    spent_ += free_targets_.size();
    for (Partner& partner : partners) partner.error = error_about(partner.pair);
    const auto last = partners.begin() + static_cast<std::ptrdiff_t>(std::min(kMostPartners, partners.size()));
    std::partial_sort(partners.begin(), last, partners.end());
    partners.erase(last, partners.end());
    return partners;
  }
  /// The mean error of a pair and of those beside it, none counting more than what is bad anyhow.
  [[nodiscard]] double error_about(Candidate pair) const {
    constexpr double kWorst = 6.0;
    double sum = bench_.misfit.length_error(pair);
    int count = 1;
    auto [s, t] = pair;
    do {
      const Candidate beside{source_.twin(s), target_.twin(t)};
      if (beside.source.valid() != beside.target.valid()) {
        sum += kWorst;
        ++count;
      } else if (beside.source.valid()) {
        const bool alike = source_.size(source_.face(beside.source)) == target_.size(target_.face(beside.target));
        sum += alike ? std::min(kWorst, bench_.misfit.length_error(beside)) : kWorst;
        ++count;
      }
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
    return sum / count;
  }

  Workbench& bench_;
  Likelihood likelihood_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  PerFace<std::uint32_t> depth_;  // of free faces, from the rim inwards, 1 at the rim
  PerFace<bool> tried_;
  std::vector<FaceId> free_targets_;
  std::vector<Candidate> best_faces_;
  std::size_t budget_, spent_ = 0;
};

}  // namespace

std::size_t match_lookalikes(Workbench& bench) {
  // Where the source is placed as a whole, positions have found what there is to find.
  return bench.misfit.trusts_lengths() && !bench.misfit.is_placed() ? Lookalikes(bench).match() : 0;
}

}  // namespace quadmatch::regions
