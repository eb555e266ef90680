#include "expansion.hpp"

#include <algorithm>

#include "binary_cut.hpp"

namespace quadmatch::regions {
namespace {

/// How many faces in a row may fit badly before a ghost gives up.
constexpr std::uint32_t kMostBadSteps = 6;
constexpr double kBadError = 3.0;     // in sigma
constexpr double kBadDistance = 0.5;  // in edges
/// How much dearer than it is now a ghost may make the faces on its way: what lies beyond will not pay for more.
constexpr double kMostDebt = 3.0;

struct Step {
  Candidate pair;
  std::uint32_t bad_steps;
  double debt;
};

/// Lays what fits, nearest first, and stops where corners disagree or lengths long have.
class Extension {
 public:
  Extension(Workbench& bench, std::size_t most_faces, bool near_only = false)
      : bench_(bench), most_(most_faces), near_only_(near_only) {}

  void push_neighbours(Candidate pair, std::uint32_t bad_steps, double debt) {
    auto [s, t] = pair;
    do {
      const Candidate beyond{source_.twin(s), target_.twin(t)};
      if (beyond.source.valid() && beyond.target.valid() && !bench_.ghost.covers(source_.face(beyond.source))) {
        steps_.push_back({beyond, bad_steps, debt});
      }
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
  }
  void run() {
    for (std::size_t here = 0; here < steps_.size() && bench_.ghost.pairs().size() < most_; ++here) {
      take(steps_[here]);
    }
  }

 private:
  void take(Step step) {
    if (!bench_.ghost.fits(step.pair)) return;
    step.bad_steps = is_bad(step.pair) ? step.bad_steps + 1 : 0;
    if (step.bad_steps > kMostBadSteps) return;
    // What lies so already has nothing to gain, nor has what is beyond it.
    const bool gains = !lies_so_now(step.pair);
    if (gains) step.debt = std::max(0.0, step.debt + extra_cost(step.pair));
    if (step.debt > kMostDebt) return;
    bench_.ghost.accept(step.pair);
    if (gains && bench_.misfit.disagreeing_corners(step.pair) == 0) {
      push_neighbours(step.pair, step.bad_steps, step.debt);
    }
  }

  [[nodiscard]] bool lies_so_now(Candidate pair) const {
    return bench_.patchwork.is_matched(source_.face(pair.source)) && bench_.patchwork.image(pair.source) == pair.target;
  }
  [[nodiscard]] double extra_cost(Candidate pair) const {
    return bench_.misfit.cost(pair) - bench_.misfit.present_cost(bench_.patchwork, source_.face(pair.source));
  }
  [[nodiscard]] bool is_bad(Candidate pair) const {
    return (bench_.misfit.uses_lengths() && bench_.misfit.length_error(pair) > kBadError) ||
           (near_only_ && bench_.misfit.distance(pair) > kBadDistance);
  }

  Workbench& bench_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  std::size_t most_;
  bool near_only_;
  std::vector<Step> steps_;
};

/// Which faces of the ghost should join its region?
class Expansion {
 public:
  explicit Expansion(Workbench& bench) : bench_(bench), cut_(static_cast<std::uint32_t>(bench.ghost.pairs().size())) {}

  /// The pairs that are better off with the region, if a change of partner is rewarded; none if all of them together
  /// gain too little.
  std::vector<Candidate> joining(double reward, double least_gain = 0) {
    const std::vector<Candidate>& pairs = bench_.ghost.pairs();
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
      add_face(i, pairs[i]);
      if (reward > 0 && !lies_so_now(pairs[i])) cut_.add_cost(i, reward, 0);
    }
    const std::vector<bool> joins = cut_.solve();
    if (least_gain > 0 && cut_.gain(joins) < least_gain) return {};
    std::vector<Candidate> joining;
    for (std::uint32_t i = 0; i < pairs.size(); ++i) {
      if (joins[i]) joining.push_back(pairs[i]);
    }
    return joining;
  }

  std::size_t apply(std::uint32_t region, double least_gain) {
    const std::vector<Candidate> joining = this->joining(0, least_gain);
    std::size_t changed = 0;
    for (const Candidate& pair : joining) changed += !lies_so_now(pair);
    for (const Candidate& pair : joining) {
      if (const FaceId face = source_.face(pair.source); patchwork_.is_matched(face)) patchwork_.lift(face);
      if (const FaceId owner = patchwork_.origin(target_.face(pair.target)); owner.valid()) patchwork_.lift(owner);
    }
    for (const Candidate& pair : joining) patchwork_.lay(pair, region);
    return changed;
  }

  [[nodiscard]] bool lies_so_now(Candidate pair) const {
    return patchwork_.is_matched(source_.face(pair.source)) && patchwork_.image(pair.source) == pair.target;
  }

 private:
  [[nodiscard]] double cost_now(FaceId face) const { return bench_.misfit.present_cost(patchwork_, face); }
  void add_face(std::uint32_t i, Candidate pair) {
    const FaceId face = source_.face(pair.source);
    const double now = cost_now(face);
    cut_.add_cost(i, now, lies_so_now(pair) ? now : bench_.misfit.cost(pair));
    const FaceId owner = patchwork_.origin(target_.face(pair.target));
    if (owner.valid() && owner != face) add_eviction(i, owner);
    auto [s, t] = pair;
    do {
      if (const HalfedgeId beside = source_.twin(s); beside.valid()) add_edge(i, s, t, beside);
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
  }
  /// Whoever takes a target face leaves its present owner unmatched, unless that joins as well.
  void add_eviction(std::uint32_t i, FaceId owner) {
    const double loss = std::max(0.0, Misfit::kUnmatched - cost_now(owner));
    const std::uint32_t j = bench_.ghost.pair_of(owner);
    if (j == Ghost::kNone) {
      cut_.add_cost(i, 0, loss);
    } else {
      cut_.add_pair_cost(i, j, 0, 0, loss, 0);
    }
  }
  /// A seam where the half-edges on which both sides of an edge lie are not each other's twins; an unmatched face makes
  /// none.
  [[nodiscard]] double seam(HalfedgeId image, HalfedgeId image_beside) const {
    if (!image.valid() || !image_beside.valid()) return 0;
    return target_.twin(image) == image_beside ? 0 : Misfit::kSeam;
  }
  [[nodiscard]] HalfedgeId image_now(HalfedgeId h) const {
    return patchwork_.is_matched(source_.face(h)) ? patchwork_.image(h) : HalfedgeId();
  }
  void add_edge(std::uint32_t i, HalfedgeId s, HalfedgeId t, HalfedgeId beside) {
    const std::uint32_t j = bench_.ghost.pair_of(source_.face(beside));
    const HalfedgeId now = image_now(s), beside_now = image_now(beside);
    if (j == Ghost::kNone) {
      cut_.add_cost(i, seam(now, beside_now), seam(t, beside_now));
    } else if (i < j) {
      const HalfedgeId beside_then = bench_.ghost.image(beside);
      cut_.add_pair_cost(i, j, seam(now, beside_now), seam(now, beside_then), seam(t, beside_now),
                         seam(t, beside_then));
    }
  }

  Workbench& bench_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  Patchwork& patchwork_ = bench_.patchwork;
  BinaryCut cut_;
};

}  // namespace

void extend_region(Workbench& bench, const std::vector<HalfedgeId>& faces, std::uint32_t region,
                   std::size_t most_faces) {
  bench.ghost.restart(region);
  Extension extension(bench, most_faces);
  for (const HalfedgeId entry : faces) {
    if (bench.patchwork.region(bench.sides.source.mesh.face(entry)) == region) {
      extension.push_neighbours({entry, bench.patchwork.image(entry)}, 0, 0);
    }
  }
  extension.run();
}

bool extend_seed(Workbench& bench, Candidate seed, std::size_t most_faces, bool near_only) {
  bench.ghost.restart();
  if (!bench.ghost.fits(seed)) return false;
  Extension extension(bench, most_faces, near_only);
  bench.ghost.accept(seed);
  extension.push_neighbours(seed, 0, 0);
  extension.run();
  return true;
}

std::size_t expand(Workbench& bench, std::uint32_t region, double least_gain) {
  return bench.ghost.pairs().empty() ? 0 : Expansion(bench).apply(region, least_gain);
}

std::vector<Candidate> would_join(Workbench& bench, double reward) {
  if (bench.ghost.pairs().empty()) return {};
  Expansion expansion(bench);
  std::vector<Candidate> pairs = expansion.joining(reward);
  std::erase_if(pairs, [&](Candidate pair) { return expansion.lies_so_now(pair); });
  return pairs;
}

}  // namespace quadmatch::regions
