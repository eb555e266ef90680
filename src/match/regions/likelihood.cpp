#include "likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace quadmatch::regions {
namespace {

constexpr std::size_t kCodes = 1 << 16;
/// How often a vertex of a true pair has the same code, edits considered.
constexpr double kAgrees = 0.9;

void count_codes(const Side& side, std::vector<double>& counts) {
  for (std::uint32_t v = 0; v < side.mesh.vertex_count(); ++v) ++counts[side.code(VertexId(v)).value];
}

}  // namespace

Likelihood::Likelihood(const Workbench& bench)
    : bench_(bench), log_rarity_(kCodes, 0), seen_(bench.sides.source.mesh.vertex_count(), 0) {
  const Mesh& source = bench.sides.source.mesh;
  const Mesh& target = bench.sides.target.mesh;
  count_codes(bench.sides.source, log_rarity_);
  count_codes(bench.sides.target, log_rarity_);
  const double vertices = static_cast<double>(source.vertex_count()) + target.vertex_count();
  // What is common says little, but never against: that most vertices are regular is no evidence of a mistake.
  for (double& count : log_rarity_) count = count > 0 ? std::max(0.0, std::log(kAgrees * vertices / count)) : 0;
  log_places_ = 0.5 * (std::log(source.halfedge_count()) + std::log(target.halfedge_count()));
}

double Likelihood::of(std::span<const Candidate> pairs) {
  ++now_;
  const Mesh& source = bench_.sides.source.mesh;
  const Mesh& target = bench_.sides.target.mesh;
  const double log_disagrees = std::log(1 - kAgrees);
  double sum = 0;
  for (const Candidate& pair : pairs) {
    if (bench_.misfit.uses_lengths()) {
      const double error = bench_.misfit.length_error(pair);
      sum += error < 1 ? 1.5 : error < 3 ? 0 : -1;
    }
    auto [s, t] = pair;
    do {
      if (std::exchange(seen_[source.origin(s)], now_) != now_) {
        const VertexCode code = bench_.sides.source.code(source.origin(s));
        sum += code == bench_.sides.target.code(target.origin(t)) ? log_rarity_[code.value] : log_disagrees;
      }
      s = source.next(s);
      t = target.next(t);
    } while (s != pair.source);
  }
  return sum;
}

}  // namespace quadmatch::regions
