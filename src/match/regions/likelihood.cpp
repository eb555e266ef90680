#include "likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadmatch::regions {
namespace {

/// How often a vertex of a true pair has the same code, edits considered.
constexpr double kAgrees = 0.9;
/// How often lengths of a true pair fit within sigma, and how often they are beyond three.
constexpr double kFits = 0.7, kMisfits = 0.1;
/// One face says no more than this: its neighbours say nearly the same.
constexpr double kMostByLengths = 1.5;
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

Likelihood::Likelihood(const Workbench& bench) : bench_(bench), seen_(bench.sides.source.mesh.vertex_count(), 0) {
  learn_codes();
  if (bench.misfit.trusts_lengths()) learn_lengths();
  log_places_ =
      0.5 * (std::log(bench.sides.source.mesh.halfedge_count()) + std::log(bench.sides.target.mesh.halfedge_count()));
}

void Likelihood::learn_codes() {
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
  const Mesh& source = bench_.sides.source.mesh;
  const Mesh& target = bench_.sides.target.mesh;
  constexpr std::uint32_t kSamples = 1000;
  double tried = 1, fit = 0, misfit = 0;
  for (std::uint32_t k = 0; k < kSamples; ++k) {
    const auto pick = [k](const Mesh& mesh, std::uint64_t stride) {
      return mesh.first(FaceId(static_cast<std::uint32_t>((k + 1) * stride % mesh.face_count())));
    };
    const Candidate pair{pick(source, 7919), pick(target, 104729)};
    if (source.size(source.face(pair.source)) != target.size(target.face(pair.target))) continue;
    const double error = bench_.misfit.length_error(pair);
    ++tried;
    fit += error < 1;
    misfit += error > 3;
  }
  const auto share = [tried](double count) { return std::max(count / tried, 1e-3); };
  fits_ = std::clamp(std::log(kFits / share(fit)), 0.0, kMostByLengths);
  misfits_ = std::clamp(std::log(kMisfits / share(misfit)), -kMostByLengths, 0.0);
}

double Likelihood::of(std::span<const Candidate> pairs) {
  ++now_;
  const Mesh& source = bench_.sides.source.mesh;
  const Mesh& target = bench_.sides.target.mesh;
  double sum = 0;
  for (const Candidate& pair : pairs) {
    if (bench_.misfit.trusts_lengths()) {
      const double error = bench_.misfit.length_error(pair);
      sum += error < 1 ? fits_ : error > 3 ? misfits_ : 0;
    }
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
  }
  return sum;
}

}  // namespace quadmatch::regions
