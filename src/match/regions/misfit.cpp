#include "misfit.hpp"

#include <algorithm>
#include <cmath>

#include "nth_smallest.hpp"

namespace quadmatch::regions {
namespace {

/// Lengths say nothing where even the better half of the matched faces differ by a third.
constexpr double kUseless = 0.35;
constexpr double kLeastSigma = 0.02;
/// Sigma, by the mean error about a face.
constexpr double kLocalSigma = 1.5;
/// Lengths that differ by less are those of a model that was not posed.
constexpr double kStill = 0.06;
/// A stretch that differs from place to place is believed if it lets the usual error fall to this share.
constexpr double kClearly = 0.9;
/// What an edge's length of distance costs: enough to decide between equals, and no more.
constexpr double kAway = 0.04;

/// The value that a share of the numbers stay below; reorders them. @pre not empty.
template <class Number>
Number quantile(std::vector<Number>& numbers, double share) {
  return nth_smallest(numbers, static_cast<std::size_t>(share * static_cast<double>(numbers.size() - 1)));
}

/// Some thousands of the matched faces, evenly spread over the order in which they were matched.
std::vector<Candidate> sample_of(const Mesh& source, const Patchwork& patchwork) {
  constexpr std::size_t kSamples = 4000;
  const std::vector<HalfedgeId>& history = patchwork.history();
  const std::size_t step = history.size() / kSamples + 1;
  std::vector<Candidate> sample;
  for (std::size_t k = 0; k < history.size(); k += step) {
    if (patchwork.is_matched(source.face(history[k]))) sample.push_back({history[k], patchwork.image(history[k])});
  }
  if (sample.empty()) {  // all of those were lifted again
    for (const HalfedgeId entry : history) {
      if (patchwork.is_matched(source.face(entry))) sample.push_back({entry, patchwork.image(entry)});
    }
  }
  return sample;
}

Point middle(const Mesh& mesh, FaceId face) {
  Point sum = {0, 0, 0};
  for (const HalfedgeId h : mesh.halfedges(face)) {
    for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += mesh.positions()[mesh.origin(h).value][axis];
  }
  for (double& number : sum) number /= mesh.size(face);
  return sum;
}

PerFace<Point> middles_of(const Mesh& mesh) {
  PerFace<Point> middles(mesh.face_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) middles[FaceId(f)] = middle(mesh, FaceId(f));
  return middles;
}

}  // namespace

Misfit::Misfit(const Sides& sides, bool with_positions) : sides_(sides), with_positions_(with_positions) {
  if (sides.source.mesh.positions().empty() || sides.target.mesh.positions().empty()) with_positions_ = false;
}

/// Lengths are measured when they are first wanted: where all is equal nobody asks.
bool Misfit::load_lengths() {
  if (with_positions_ && lengths_.empty()) {
    lengths_.reserve(2);
    lengths_.emplace_back(sides_.source.mesh);
    lengths_.emplace_back(sides_.target.mesh);
  }
  return with_positions_;
}

void Misfit::pin(std::vector<Candidate> pairs) {
  ++costs_known_;
  pins_ = std::move(pairs);
}

void Misfit::assume(double sigma) {
  ++costs_known_;
  uses_lengths_ = load_lengths();
  learnt_ = false;
  if (!uses_lengths_) return;
  stretched_.reset();
  scale_ = lengths_[1].median_edge() - lengths_[0].median_edge();
  sigma_ = sigma;
}

/// Calls visit(ours, theirs) with the lengths of each pair of corners, from that of the half-edges on.
/// @return how many these are.
template <class Visit>
std::size_t Misfit::for_each_corner(Candidate pair, const Lengths& source_lengths, Visit visit) const {
  const Mesh& source = sides_.source.mesh;
  const Mesh& target = sides_.target.mesh;
  const std::span<const Lengths::Pair> ours = source_lengths.of(source.face(pair.source));
  const std::span<const Lengths::Pair> theirs = lengths_[1].of(target.face(pair.target));
  std::size_t s = source.corner(pair.source), t = target.corner(pair.target);
  for (std::size_t k = 0; k < ours.size(); ++k) {
    visit(ours[s], theirs[t]);
    if (++s == ours.size()) s = 0;
    if (++t == theirs.size()) t = 0;
  }
  return ours.size();
}

void Misfit::calibrate(const Patchwork& patchwork) {
  ++costs_known_;
  uses_lengths_ = false;
  if (patchwork.matched_faces() == 0 || !load_lengths()) return;
  stretched_.reset();
  const std::vector<Candidate> sample = sample_of(sides_.source.mesh, patchwork);
  std::vector<double> ratios;
  for (const Candidate& pair : sample) {
    double ratio = 0;
    const std::size_t size = for_each_corner(
        pair, lengths_[0],
        [&](const Lengths::Pair& ours, const Lengths::Pair& theirs) { ratio += theirs.edge - ours.edge; });
    ratios.push_back(ratio / static_cast<double>(size));
  }
  scale_ = quantile(ratios, 0.5);
  Spread spread = spread_of(sample);
  uses_lengths_ = learnt_ = spread.lower < kUseless;
  sigma_ = sigma_far_ = sigma_of(spread);
  if (spread.middle <= kStill) return;
  stretched_ = stretched(sides_, patchwork, lengths_[0], lengths_[1], scale_);
  const Spread near = spread_of(sample);
  if (near.middle > kClearly * spread.middle) {
    stretched_.reset();
    return;
  }
  uses_lengths_ = learnt_ = near.lower < kUseless;
  sigma_ = sigma_of(near);
  sigma_far_ = std::max(sigma_, sigma_far_);
}

double Misfit::sigma_of(const Spread& spread) {
  return std::max(kLeastSigma, 1.5 * std::min(spread.middle, 2 * spread.lower));
}

Misfit::Spread Misfit::spread_of(const std::vector<Candidate>& sample) const {
  std::vector<double> errors;
  errors.reserve(sample.size());
  for (const Candidate& pair : sample) errors.push_back(raw_error(pair, source_lengths()));
  const double lower = quantile(errors, 0.25);
  return {lower, quantile(errors, 0.5)};
}

double Misfit::raw_error(Candidate pair, const Lengths& ours) const {
  const bool has_diagonals = sides_.source.mesh.size(sides_.source.mesh.face(pair.source)) > 3;
  double sum = 0;
  const std::size_t terms = for_each_corner(pair, ours, [&](const Lengths::Pair& here, const Lengths::Pair& there) {
    const double edge = there.edge - here.edge - scale_;
    sum += edge * edge;
    if (!has_diagonals) return;
    const double diagonal = there.diagonal - here.diagonal - scale_;
    sum += 0.5 * diagonal * diagonal;  // a quad's are met from both ends
  });
  return std::sqrt(sum / (static_cast<double>(terms) * (has_diagonals ? 1.5 : 1)));
}

double Misfit::least_raw_error(Candidate pair) const {
  const std::uint32_t terms = sides_.source.mesh.size(sides_.source.mesh.face(pair.source));
  const double edge = lengths_[1].single_edge(pair.target) - source_lengths().single_edge(pair.source) - scale_;
  return std::sqrt(edge * edge / (static_cast<double>(terms) * (terms > 3 ? 1.5 : 1)));
}

double Misfit::sigma_at(FaceId source_face) const {
  if (!stretched_) return sigma_;
  const double known = stretched_->known[source_face];
  const double sigma = std::max(sigma_, kLocalSigma * stretched_->error[source_face]);
  return known * sigma + (1 - known) * sigma_far_;
}

double Misfit::strict_sigma_at(FaceId source_face) const {
  if (!stretched_) return sigma_;
  const double known = stretched_->known[source_face];
  return known * sigma_ + (1 - known) * sigma_far_;
}

double Misfit::length_error(Candidate pair) const {
  return raw_error(pair, source_lengths()) / sigma_at(sides_.source.mesh.face(pair.source));
}

double Misfit::strict_error(Candidate pair) const {
  return raw_error(pair, source_lengths()) / strict_sigma_at(sides_.source.mesh.face(pair.source));
}

double Misfit::least_length_error(Candidate pair) const {
  return least_raw_error(pair) / sigma_at(sides_.source.mesh.face(pair.source));
}

double Misfit::least_strict_error(Candidate pair) const {
  return least_raw_error(pair) / strict_sigma_at(sides_.source.mesh.face(pair.source));
}

double Misfit::taper_error(Candidate pair) const {
  if (sides_.source.mesh.size(sides_.source.mesh.face(pair.source)) != 4) return 0;
  double difference[4] = {};
  std::size_t corner = 0;
  for_each_corner(pair, lengths_[0], [&](const Lengths::Pair& here, const Lengths::Pair& there) {
    difference[corner++] = there.edge - here.edge;
  });
  const double along = difference[0] - difference[2], across = difference[1] - difference[3];
  return std::sqrt((along * along + across * across) / 2);
}

std::uint32_t Misfit::disagreeing_corners(Candidate pair) const {
  std::uint32_t disagreeing = 0;
  auto [s, t] = pair;
  do {
    disagreeing += sides_.source.code(sides_.source.mesh.origin(s)) != sides_.target.code(sides_.target.mesh.origin(t));
    s = sides_.source.mesh.next(s);
    t = sides_.target.mesh.next(t);
  } while (s != pair.source);
  return disagreeing;
}

std::uint32_t Misfit::telling_corners(Candidate pair) const {
  std::uint32_t telling = 0;
  auto [s, t] = pair;
  do {
    const VertexCode code = sides_.source.code(sides_.source.mesh.origin(s));
    telling += code.extraordinary() && code == sides_.target.code(sides_.target.mesh.origin(t));
    s = sides_.source.mesh.next(s);
    t = sides_.target.mesh.next(t);
  } while (s != pair.source);
  return telling;
}

double Misfit::cost_by_pins(Candidate pair) const {
  constexpr double kDecides = 1000;
  const Mesh& source = sides_.source.mesh;
  const Mesh& target = sides_.target.mesh;
  for (const Candidate& pin : pins_) {
    const FaceId q = source.face(pin.source), r = target.face(pin.target);
    if (source.face(pair.source) != q && target.face(pair.target) != r) continue;
    const std::uint32_t steps = source.corner(pin.source) + source.size(q) - source.corner(pair.source);
    const bool same = source.face(pair.source) == q && turned(target, pair.target, steps) == pin.target;
    return same ? -kDecides : kDecides;
  }
  return 0;
}

double Misfit::cost(Candidate pair) const {
  if (!pins_.empty()) {
    if (const double decided = cost_by_pins(pair); decided != 0) return decided;
  }
  const double disagreeing = disagreeing_corners(pair);
  const double away = placement_ ? kAway * std::min(1.0, distance(pair)) : 0;
  if (!uses_lengths_) {
    // An edit adds extraordinary vertices and removes some, but seldom makes one that agrees: that says most.
    return std::min(kUnmatched - 0.02, 0.2 * disagreeing + away) - 0.5 * telling_corners(pair);
  }
  const double error = std::min(1.0, length_error(pair) / 3);
  // Where lengths agree a corner may well disagree: the edit is beside this face.
  return 0.9 * error + 0.15 * disagreeing * (error > 0.3 ? 1.0 : 0.3) + away;
}

double Misfit::present_cost(const Patchwork& patchwork, FaceId source_face) {
  if (!patchwork.is_matched(source_face)) return kUnmatched;
  if (kept_.size() == 0) kept_ = PerFace<Kept>(sides_.source.mesh.face_count());
  Kept& kept = kept_[source_face];
  const std::uint32_t changed_at = patchwork.changed_at(source_face);
  if (kept.changed_at != changed_at || kept.costs != costs_known_) {
    const HalfedgeId first = sides_.source.mesh.first(source_face);
    kept = {changed_at, costs_known_, cost({first, patchwork.image(first)})};
  }
  return kept.cost;
}

double Misfit::distance(Candidate pair) const {
  const FaceId q = sides_.source.mesh.face(pair.source), r = sides_.target.mesh.face(pair.target);
  const Point& there = placed_middles_[q];
  const Point& image = target_middles_[r];
  return std::sqrt(squared_distance(there, image)) / edge_;
}

void Misfit::place(const std::optional<Similarity>& placement, double edge) {
  ++costs_known_;
  placement_ = placement;
  edge_ = edge;
  if (!placement) return;
  placed_middles_ = middles_of(sides_.source.mesh);
  for (std::uint32_t f = 0; f < placed_middles_.size(); ++f) {
    placed_middles_[FaceId(f)] = (*placement)(placed_middles_[FaceId(f)]);
  }
  if (target_middles_.size() == 0) target_middles_ = middles_of(sides_.target.mesh);
}

}  // namespace quadmatch::regions
