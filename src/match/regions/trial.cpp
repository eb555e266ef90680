#include "trial.hpp"

namespace quadmatch::regions {
namespace {

class Trial {
 public:
  Trial(Workbench& bench, const TrialRules& rules) : bench_(bench), rules_(rules) {}

  bool grow(Candidate seed) {
    bench_.ghost.restart();
    if (!is_free(seed) || !take_seed(seed)) return false;
    const std::vector<Candidate>& pairs = bench_.ghost.pairs();
    for (std::size_t here = 0; here < pairs.size() && pairs.size() < rules_.most_faces; ++here) {
      const Candidate pair = pairs[here];  // the vector grows
      const bool grows = here == 0 || !rules_.cover_disagreeing || bench_.misfit.disagreeing_corners(pair) == 0;
      if (grows) take_neighbours(pair);
    }
    return true;
  }

 private:
  [[nodiscard]] bool is_free(Candidate pair) const {
    return !bench_.patchwork.is_matched(source_.face(pair.source)) &&
           !bench_.patchwork.is_taken(target_.face(pair.target));
  }
  bool take_seed(Candidate seed) {
    if (!rules_.any_seed) return take(seed);
    if (!bench_.ghost.fits(seed)) return false;
    bench_.ghost.accept(seed);
    return true;
  }
  bool take(Candidate pair) {
    if (!bench_.ghost.fits(pair)) return false;
    if (!rules_.cover_disagreeing && bench_.misfit.disagreeing_corners(pair) > 0) return false;
    if (bench_.misfit.uses_lengths() && bench_.misfit.length_error(pair) > rules_.worst_error) {
      return false;
    }
    bench_.ghost.accept(pair);
    return true;
  }
  void take_neighbours(Candidate pair) {
    auto [s, t] = pair;
    do {
      const Candidate beyond{source_.twin(s), target_.twin(t)};
      if (beyond.source.valid() && beyond.target.valid() && !bench_.ghost.covers(source_.face(beyond.source)) &&
          is_free(beyond)) {
        take(beyond);
      }
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
  }

  Workbench& bench_;
  const TrialRules& rules_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
};

}  // namespace

bool grow_trial(Workbench& bench, Candidate seed, const TrialRules& rules) { return Trial(bench, rules).grow(seed); }

void keep_trial(Workbench& bench) {
  const std::uint32_t region = bench.patchwork.fresh_region();
  for (const Candidate& pair : bench.ghost.pairs()) bench.patchwork.lay(pair, region);
}

}  // namespace quadmatch::regions
