#include "venture.hpp"

#include <algorithm>

namespace quadmatch::regions {
namespace {

/// Belief in a place is the sum of what was said on the way to it. It never exceeds the first, however much agreed:
/// what is near counts; and growth ends where it falls below the second.
constexpr double kMostBelief = 6.0, kLeastBelief = -3.0;
/// What a step costs, so that near faces come first.
constexpr double kStep = 0.02;
/// What an edge says beyond which another region lies as it should, and one beyond which none does.
constexpr double kVote = 1.0, kAgainst = 0.5;

}  // namespace

const std::vector<Candidate>& Venture::from_region(std::uint32_t region) {
  begin(region);
  for (const HalfedgeId entry : bench_.rim.entries(region))
    push_neighbours({entry, bench_.patchwork.image(entry)}, kNone, kMostBelief);
  grow(source_.face_count());
  cut_back();
  return kept_;
}

const std::vector<Candidate>& Venture::from_seed(Candidate seed, std::size_t most_faces) {
  begin(Patchwork::kNoRegion);
  if (is_free(seed)) queue_.push_back({0, count_++, kNone, seed});
  grow(most_faces);
  cut_back();
  return kept_;
}

void Venture::begin(std::uint32_t base) {
  bench_.ghost.restart(base);
  queue_.clear();
  nodes_.clear();
  count_ = 0;
}

void Venture::push_neighbours(Candidate pair, std::uint32_t parent, double belief) {
  auto [s, t] = pair;
  do {
    const Candidate beyond{source_.twin(s), target_.twin(t)};
    if (beyond.source.valid() && beyond.target.valid() && is_free(beyond) && bench_.ghost.fits(beyond)) {
      const double then = std::min(kMostBelief, belief + score(beyond) - kStep);
      if (then > kLeastBelief) {
        queue_.push_back({then, count_++, parent, beyond});
        std::push_heap(queue_.begin(), queue_.end());
      }
    }
    s = source_.next(s);
    t = target_.next(t);
  } while (s != pair.source);
}

void Venture::grow(std::size_t most_faces) {
  while (!queue_.empty() && nodes_.size() < most_faces) {
    std::pop_heap(queue_.begin(), queue_.end());
    const Step step = queue_.back();
    queue_.pop_back();
    if (!bench_.ghost.fits(step.pair)) continue;
    nodes_.push_back({step.parent, score(step.pair)});
    bench_.ghost.accept(step.pair);
    push_neighbours(step.pair, static_cast<std::uint32_t>(nodes_.size() - 1), step.belief);
  }
}

/// What the corners say that are new, and the faces beside that other regions have.
double Venture::score(Candidate pair) {
  double score = 0;
  auto [s, t] = pair;
  do {
    if (!bench_.ghost.knows(s)) score += likelihood_.of_vertex(source_.origin(s), target_.origin(t));
    const HalfedgeId beside = source_.twin(s);
    const bool is_own = beside.valid() && bench_.patchwork.is_matched(source_.face(beside)) &&
                        bench_.ghost.covers(source_.face(beside));
    const Beyond beyond = is_own ? Beyond::Free : bench_.patchwork.beyond(s, t);
    score += beyond == Beyond::InPlace ? kVote : beyond == Beyond::Elsewhere ? -kAgainst : 0;
    s = source_.next(s);
    t = target_.next(t);
  } while (s != pair.source);
  return score;
}

/// Pairs hang together as a tree, each on the one from which it was reached. Cut off every branch that says less than
/// nothing.
void Venture::cut_back() {
  std::vector<double> branch(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) branch[i] = nodes_[i].score;
  worth_ = 0;
  for (std::size_t i = nodes_.size(); i-- > 0;) {  // whoever hangs on another comes after it
    if (branch[i] < 0) continue;
    (nodes_[i].parent == kNone ? worth_ : branch[nodes_[i].parent]) += branch[i];
  }
  kept_.clear();
  std::vector<bool> keeps(nodes_.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    keeps[i] = branch[i] >= 0 && (nodes_[i].parent == kNone || keeps[nodes_[i].parent]);
    if (keeps[i]) kept_.push_back(bench_.ghost.pairs()[i]);
  }
}

std::size_t venture_on(Workbench& bench) {
  const std::size_t before = bench.patchwork.matched_faces();
  Likelihood likelihood(bench);
  Venture venture(bench, likelihood);
  for (const auto& [region, faces] : largest_first(bench.patchwork)) {
    for (const Candidate& pair : venture.from_region(region)) bench.patchwork.lay(pair, region);
  }
  bench.ghost.restart();
  return bench.patchwork.matched_faces() - before;
}

}  // namespace quadmatch::regions
