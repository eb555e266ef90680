#include "likelihood.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace quadmatch::regions {
namespace {

/// How often a vertex of a true pair has the same code, edits considered.
constexpr double kAgrees = 0.9;
/// How often lengths of a true pair fit within one, two and three sigma, and how often they are beyond.
constexpr std::array<double, 4> kTrueErrors = {0.6, 0.2, 0.1, 0.1};
/// Trials take no face whose lengths fit worse, in sigma. Where lengths are merely assumed, chance is what passes this.
constexpr double kGate = 4.0;
/// One face says no more than this: its neighbours say nearly the same.
constexpr double kMostByLengths = 1.5;
/// Smooth models fit by chance in whole patches: where lengths are merely assumed so much of what each face says is
/// what its neighbours have said.
constexpr double kHabit = 1.0;
/// What a face says that lands on its image, with the source placed as a whole; nothing if it does not: it may have
/// been moved.
constexpr double kLands = 2.0, kNear = 0.3;
/// A vertex that disagrees always speaks against, if only a little.
constexpr double kLeastAgainst = -0.5;

/// By code: the share of the vertices that have it.
std::vector<double> share_of_codes(const Side& side) {
  std::vector<double> share;
  for (std::uint32_t v = 0; v < side.mesh.vertex_count(); ++v) {
    const std::uint16_t code = side.code(VertexId(v)).value;
    if (code >= share.size()) share.resize(code + std::size_t{1}, 0);
    share[code] += 1.0;
  }
  for (double& count : share) count /= side.mesh.vertex_count();
  return share;
}

}  // namespace

Likelihood::Likelihood(const Workbench& bench, bool judges)
    : bench_(bench),
      judges_(judges),
      log_places_(0.5 * (std::log(bench.sides.source.mesh.halfedge_count()) +
                         std::log(bench.sides.target.mesh.halfedge_count()))) {}

void Likelihood::learn_codes() {
  if (std::exchange(knows_codes_, true)) return;
  seen_ = PerVertex<std::uint32_t>(bench_.sides.source.mesh.vertex_count(), 0);
  const std::vector<double> source_share = share_of_codes(bench_.sides.source);
  std::vector<double> target_share = share_of_codes(bench_.sides.target);
  target_share.resize(std::max(source_share.size(), target_share.size()), 0);
  agrees_.assign(source_share.size(), 0);  // a code that only the target has never agrees
  double chance_agrees = 0;
  for (std::size_t code = 0; code < agrees_.size(); ++code) {
    chance_agrees += source_share[code] * target_share[code];
    // Rare is what is rare in both. What is common says little, but never against: that most vertices are regular is
    // no evidence of a mistake.
    const double share = std::max(source_share[code], target_share[code]);
    agrees_[code] = share > 0 ? std::max(0.0, std::log(kAgrees / share)) : 0;
  }
  disagrees_ = std::min(kLeastAgainst, std::log((1 - kAgrees) / std::max(1e-9, 1 - chance_agrees)));
}

/// Lay faces on faces far away in the order of the file, which is as good as chance.
void Likelihood::learn_lengths() {
  if (std::exchange(knows_lengths_, true) || !bench_.misfit.uses_lengths()) return;
  const Mesh& source = bench_.sides.source.mesh;
  const Mesh& target = bench_.sides.target.mesh;
  constexpr std::uint32_t kSamples = 4000;
  double tried = 0;
  std::array<double, kTrueErrors.size()> count{};
  for (std::uint32_t k = 0; k < kSamples; ++k) {
    const auto pick = [k](const Mesh& mesh, std::uint64_t stride) {
      return mesh.first(FaceId(static_cast<std::uint32_t>((k + 1) * stride % mesh.face_count())));
    };
    const Candidate pair{pick(source, 7919), pick(target, 104729)};
    if (source.size(source.face(pair.source)) != target.size(target.face(pair.target))) continue;
    // Most fit so badly that one edge tells, and how badly does not matter.
    const double least = least_error_of(pair);
    const double error = least > kGate ? least : error_of(pair);
    if (error > kGate && !bench_.misfit.trusts_lengths()) continue;
    ++tried;
    ++count[error_class(error)];
  }
  for (std::size_t k = 0; k < count.size(); ++k) {
    const double share = std::max((count[k] + 1) / (tried + 4), 1e-3);
    double says = std::log(kTrueErrors[k] / share);
    if (!bench_.misfit.trusts_lengths() && says > 0) says = std::max(0.0, says - kHabit);
    by_error_[k] = std::clamp(says, -kMostByLengths, kMostByLengths);
  }
}

double Likelihood::error_of(const Candidate& pair) const {
  return judges_ ? bench_.misfit.strict_error(pair) : bench_.misfit.length_error(pair);
}

double Likelihood::least_error_of(const Candidate& pair) const {
  return judges_ ? bench_.misfit.least_strict_error(pair) : bench_.misfit.least_length_error(pair);
}

std::size_t Likelihood::error_class(double error) {
  return static_cast<std::size_t>(std::clamp(error, 0.0, kTrueErrors.size() - 0.5));
}

double Likelihood::of(std::span<const Candidate> pairs) {
  learn_codes();
  learn_lengths();
  ++now_;
  double sum = 0;
  for (const Candidate& pair : pairs) sum += of_next(pair, by_lengths(pair));
  return sum;
}

double Likelihood::of_best_start(std::span<const Candidate> pairs) {
  learn_codes();
  learn_lengths();
  ++now_;
  double sum = 0, best = 0;
  for (const Candidate& pair : pairs) {
    sum += of_next(pair, by_lengths(pair));
    best = std::max(best, sum);
  }
  return best;
}

double Likelihood::at_most(std::span<const Candidate> pairs) {
  learn_codes();
  ++now_;
  double sum = 0;
  for (const Candidate& pair : pairs) sum += of_next(pair, bench_.misfit.uses_lengths() ? kMostByLengths : 0);
  return sum;
}

double Likelihood::by_lengths(const Candidate& pair) const {
  return bench_.misfit.uses_lengths() ? by_error_[error_class(error_of(pair))] : 0;
}

double Likelihood::of_next(const Candidate& pair, double by_lengths) {
  const Mesh& source = bench_.sides.source.mesh;
  const Mesh& target = bench_.sides.target.mesh;
  double sum = by_lengths;
  if (bench_.misfit.is_placed() && bench_.misfit.distance(pair) < kNear) sum += kLands;
  auto [s, t] = pair;
  do {
    if (std::exchange(seen_[source.origin(s)], now_) != now_) {
      const VertexCode code = bench_.sides.source.code(source.origin(s));
      sum += code == bench_.sides.target.code(target.origin(t)) ? agrees_[code.value] : disagrees_;
    }
    s = source.next(s);
    t = target.next(t);
  } while (s != pair.source);
  return sum;
}

}  // namespace quadmatch::regions
