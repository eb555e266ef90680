// Where neither colours nor neighbours help: faces whose corners have rare codes, tried against those of the other mesh
// that look alike.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "by_hash.hpp"
#include "likelihood.hpp"
#include "mending.hpp"
#include "trial.hpp"
#include "venture.hpp"

namespace quadmatch::regions {
namespace {

/// A trial of this many faces tells; only what is kept grows on.
constexpr std::size_t kTrialFaces = 400;
/// Partners tried at most for one half-edge, and half-edges for one look.
constexpr std::size_t kMostPartners = 24, kMostPerLook = 3;
/// Faces grown in trials at most, by faces of the source.
constexpr std::size_t kBudget = 20;
/// The best trial must beat the next by this much, or be as good as equal to it in what it covers.
constexpr double kMargin = 1.0;

struct Look {
  std::uint64_t hash;
  HalfedgeId halfedge;

  bool operator<(const Look& other) const { return hash != other.hash ? hash < other.hash : halfedge < other.halfedge; }
};

/// The codes about a face, from a half-edge on: of its corners, and of the far corners of the faces beside it.
std::uint64_t look_from(const Side& side, HalfedgeId start, bool far) {
  std::uint64_t codes[32];
  std::size_t count = 0;
  HalfedgeId h = start;
  do {
    codes[count++] = side.code(side.mesh.origin(h)).value;
    if (far && count < 30) {
      const HalfedgeId beside = side.mesh.twin(h);
      codes[count++] = beside.valid() ? side.code(side.mesh.tip(side.mesh.next(beside))).value : 0;
      codes[count++] = beside.valid() ? side.code(side.mesh.origin(side.mesh.prev(beside))).value : 0;
    }
    h = side.mesh.next(h);
  } while (h != start && count < 30);
  return XXH3_64bits(codes, count * sizeof codes[0]);
}

/// All half-edges at free faces that leave an extraordinary vertex, by how they look.
template <class IsFree>
std::vector<Look> looks(const Side& side, bool far, IsFree is_free) {
  std::vector<Look> result;
  for (std::uint32_t f = 0; f < side.mesh.face_count(); ++f) {
    if (!is_free(FaceId(f))) continue;
    for (const HalfedgeId h : side.mesh.halfedges(FaceId(f))) {
      if (side.code(side.mesh.origin(h)).extraordinary()) result.push_back({look_from(side, h, far), h});
    }
  }
  sort_by_hash(result, [](const Look& look) { return look.hash; });
  return result;
}

/// Half-edges of both meshes that look the same: ranges of two sorted lists.
struct Class {
  std::size_t source, source_end, target, target_end;

  [[nodiscard]] std::size_t rarity() const { return (source_end - source) * (target_end - target); }
};

std::vector<Class> rarest_first(const std::vector<Look>& left, const std::vector<Look>& right) {
  std::vector<Class> classes;
  for (std::size_t i = 0, j = 0; i < left.size() && j < right.size();) {
    if (left[i].hash != right[j].hash) {
      ++(left[i].hash < right[j].hash ? i : j);
      continue;
    }
    Class here{i, i, j, j};
    while (here.source_end < left.size() && left[here.source_end].hash == left[i].hash) ++here.source_end;
    while (here.target_end < right.size() && right[here.target_end].hash == left[i].hash) ++here.target_end;
    classes.push_back(here);
    i = here.source_end;
    j = here.target_end;
  }
  std::stable_sort(classes.begin(), classes.end(),
                   [](const Class& a, const Class& b) { return a.rarity() < b.rarity(); });
  return classes;
}

class Restarts {
 public:
  explicit Restarts(Workbench& bench)
      : bench_(bench),
        likelihood_(bench),
        venture_(bench, likelihood_),
        budget_(kBudget * bench.sides.source.mesh.face_count()) {}

  std::size_t match() {
    const std::size_t before = bench_.patchwork.matched_faces();
    for (const bool far : {true, false}) try_looks(far);
    bench_.ghost.restart();
    return bench_.patchwork.matched_faces() - before;
  }

 private:
  /// Once something is matched the true partner of what is left free is surely among what is left free: chance has no
  /// other places to begin in.
  [[nodiscard]] double needed_for(std::size_t left, std::size_t right) const {
    constexpr double kFactor = 1.3;
    const double needed = likelihood_.needed_for_trial();
    const bool knows_something = 10 * bench_.patchwork.matched_faces() > source_.face_count();
    if (bench_.misfit.uses_lengths() || !knows_something) return needed;
    return std::min(needed, kFactor * (std::log1p(static_cast<double>(left)) + std::log1p(static_cast<double>(right))));
  }
  void try_looks(bool far) {
    const std::vector<Look> left =
        looks(bench_.sides.source, far, [&](FaceId f) { return !bench_.patchwork.is_matched(f); });
    const std::vector<Look> right =
        looks(bench_.sides.target, far, [&](FaceId f) { return !bench_.patchwork.is_taken(f); });
    needed_ = needed_for(left.size(), right.size());
    for (const Class& alike : rarest_first(left, right)) {
      std::size_t tried = 0;
      for (std::size_t i = alike.source; i < alike.source_end && tried < kMostPerLook; ++i) {
        if (bench_.patchwork.is_matched(source_.face(left[i].halfedge))) continue;
        ++tried;
        if (!try_partners(left[i].halfedge, right, alike)) return;
      }
    }
  }

  /// @return false when the budget is spent.
  bool try_partners(HalfedgeId s, const std::vector<Look>& right, const Class& alike) {
    Candidate best{};
    double worth = 0, next_worth = 0;
    std::size_t partners = 0;
    for (std::size_t j = alike.target; j < alike.target_end && partners < kMostPartners; ++j) {
      const Candidate pair{s, right[j].halfedge};
      const std::optional<double> tried = worth_of_trial(pair);
      if (!tried) continue;
      ++partners;
      const double worth_now = *tried;
      spent_ += bench_.ghost.pairs().size();
      if (worth_now > worth) {
        next_worth = worth;
        worth = worth_now;
        best = pair;
      } else {
        next_worth = std::max(next_worth, worth_now);
      }
      if (spent_ > budget_) return false;
    }
    if (worth >= needed_ && worth >= next_worth + kMargin) keep(best);
    return true;
  }
  /// Leaves the trial in the ghost. Without lengths it dares more, since corners alone seldom tell enough before the
  /// next edit. @return nothing if the pair does not fit.
  [[nodiscard]] std::optional<double> worth_of_trial(Candidate pair) {
    if (bench_.misfit.uses_lengths()) {
      if (!grow_trial(bench_, pair, {.most_faces = kTrialFaces})) return {};
      return likelihood_.of_best_start(bench_.ghost.pairs());
    }
    if (venture_.from_seed(pair, kTrialFaces).empty()) return {};
    return venture_.worth();
  }
  void keep(Candidate seed) {
    if (bench_.misfit.uses_lengths()) {
      grow_trial(bench_, seed, {.most_faces = source_.face_count()});
      keep_trial(bench_);
      return;
    }
    const std::uint32_t region = bench_.patchwork.fresh_region();
    for (const Candidate& pair : venture_.from_seed(seed, source_.face_count())) bench_.patchwork.lay(pair, region);
  }

  Workbench& bench_;
  Likelihood likelihood_;
  Venture venture_;
  double needed_ = 0;
  const Mesh& source_ = bench_.sides.source.mesh;
  std::size_t budget_, spent_ = 0;
};

}  // namespace

std::size_t restart(Workbench& bench) { return Restarts(bench).match(); }

}  // namespace quadmatch::regions
