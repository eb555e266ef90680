#include <algorithm>
#include <cstdint>
#include <vector>

#include "hops.hpp"
#include "likelihood.hpp"
#include "mending.hpp"
#include "trial.hpp"

namespace quadmatch::regions {
namespace {

/// Where many hops land: how a free face would lie on a free face.
struct Landing {
  Candidate pair;  // by the first half-edge of the source face
  std::uint32_t votes = 0;
};

class Islands {
 public:
  explicit Islands(Workbench& bench) : bench_(bench), likelihood_(bench), landing_of_(source_.face_count(), kNone) {}

  std::size_t match() {
    const std::size_t before = bench_.patchwork.matched_faces();
    gather_landings();
    for (const Trial& trial : best_first()) {
      if (grow_trial(bench_, trial.seed, {}) && worth_of_ghost() > 0) keep_trial(bench_);
    }
    bench_.ghost.restart();
    return bench_.patchwork.matched_faces() - before;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Trial {
    Candidate seed;
    double worth;
  };

  [[nodiscard]] bool is_free(FaceId source_face) const { return !bench_.patchwork.is_matched(source_face); }
  [[nodiscard]] bool is_free_target(FaceId target_face) const { return !bench_.patchwork.is_taken(target_face); }

  void gather_landings() {
    for (const HalfedgeId entry : bench_.rim.entries()) {
      HalfedgeId s = entry, t = bench_.patchwork.image(entry);
      do {
        if (!bench_.misfit.uses_lengths()) land_beside({s, t});
        for_each_landing(bench_, {s, t}, [&](Candidate landing) { land(landing); });
        s = source_.next(s);
        t = target_.next(t);
      } while (s != entry);
    }
  }
  /// A hop over nothing: what is beside a pair may be a part that an edit cut off at its corners only.
  void land_beside(Candidate edges) {
    const Candidate beside{source_.twin(edges.source), target_.twin(edges.target)};
    if (beside.source.valid() && beside.target.valid()) land(beside);
  }
  void land(Candidate pair) {
    const FaceId face = source_.face(pair.source), other = target_.face(pair.target);
    if (!is_free(face) || !is_free_target(other) || source_.size(face) != target_.size(other)) return;
    ++landings_[number_of(normal(pair))].votes;
  }
  /// The same pair, named by the first half-edge of the source face.
  [[nodiscard]] Candidate normal(Candidate pair) const {
    const FaceId face = source_.face(pair.source);
    return {source_.first(face), turned(target_, pair.target, source_.size(face) - source_.corner(pair.source))};
  }
  /// The landings of one face hang together in a list.
  std::uint32_t number_of(Candidate pair) {
    std::uint32_t& head = landing_of_[source_.face(pair.source)];
    for (std::uint32_t number = head; number != kNone; number = next_[number]) {
      if (landings_[number].pair == pair) return number;
    }
    landings_.push_back({pair, 0});
    next_.push_back(head);
    return head = static_cast<std::uint32_t>(landings_.size() - 1);
  }
  [[nodiscard]] std::uint32_t votes_for(Candidate pair) const {
    const Candidate wanted = normal(pair);
    for (std::uint32_t number = landing_of_[source_.face(pair.source)]; number != kNone; number = next_[number]) {
      if (landings_[number].pair == wanted) return landings_[number].votes;
    }
    return 0;
  }

  /// One trial for each map that hops propose, the best first.
  std::vector<Trial> best_first() {
    std::vector<bool> tried(landings_.size(), false);
    std::vector<Trial> trials;
    for (std::uint32_t number = 0; number < landings_.size(); ++number) {
      if (tried[number] || !grow_trial(bench_, landings_[number].pair, {})) continue;
      for (const Candidate& pair : bench_.ghost.pairs()) {
        const Candidate wanted = normal(pair);
        for (std::uint32_t k = landing_of_[source_.face(pair.source)]; k != kNone; k = next_[k]) {
          if (landings_[k].pair == wanted) tried[k] = true;
        }
      }
      if (const double worth = worth_of_ghost(); worth > 0) trials.push_back({landings_[number].pair, worth});
    }
    std::stable_sort(trials.begin(), trials.end(), [](const Trial& a, const Trial& b) { return a.worth > b.worth; });
    return trials;
  }

  /// What a trial is worth; 0 if it is not to be believed.
  [[nodiscard]] double worth_of_ghost() {
    return bench_.misfit.uses_lengths() ? worth_by_lengths() : worth_by_evidence();
  }
  [[nodiscard]] double worth_by_lengths() const {
    const std::vector<Candidate>& pairs = bench_.ghost.pairs();
    const auto size = static_cast<double>(pairs.size());
    std::uint32_t votes = 0, rim = 0;
    double fit = 0;
    for (const Candidate& pair : pairs) {
      votes += votes_for(pair);
      for (const HalfedgeId h : source_.halfedges(source_.face(pair.source))) {
        const HalfedgeId beside = source_.twin(h);
        rim += beside.valid() && !bench_.ghost.covers(source_.face(beside));
      }
      fit += 1 - std::min(1.0, bench_.misfit.length_error(pair) / 3);
    }
    const double share = rim == 0 ? 1.0 : static_cast<double>(votes) / rim;
    fit /= size;
    return fit > 0.6 && votes >= 2 ? size * fit * std::min(1.0, 2 * share) : 0;
  }
  /// What corners say, hops, and edges beyond which something else is matched already.
  [[nodiscard]] double worth_by_evidence() {
    constexpr double kVote = 2.0, kAgainst = 1.0, kEnough = 3.0;
    const std::vector<Candidate>& pairs = bench_.ghost.pairs();
    double worth = likelihood_.of(pairs);
    for (const Candidate& pair : pairs) worth += kVote * votes_for(pair) - kAgainst * contradictions(pair);
    return worth >= kEnough ? worth : 0;
  }
  /// Edges across which a face is matched, in either mesh, but not to the face across in the other.
  [[nodiscard]] std::uint32_t contradictions(Candidate pair) const {
    std::uint32_t count = 0;
    auto [s, t] = pair;
    do {
      count += bench_.patchwork.beyond(s, t) == Beyond::Elsewhere;
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
    return count;
  }

  Workbench& bench_;
  Likelihood likelihood_;  // asked without lengths only
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  std::vector<Landing> landings_;
  std::vector<std::uint32_t> next_;
  PerFace<std::uint32_t> landing_of_;
};

}  // namespace

std::size_t match_islands(Workbench& bench) { return Islands(bench).match(); }

}  // namespace quadmatch::regions
