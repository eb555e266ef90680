// Beside strain.cpp the one source file that includes Eigen.

#include "placement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace quadmatch::regions {
namespace {

constexpr std::size_t kMostRegions = 8;
/// Vertices a similarity is judged by.
constexpr std::size_t kSamples = 500;
constexpr double kLands = 0.15;  // in edges
constexpr double kLeastShare = 0.3;
/// How far edges of the placed source may be from those of the target, as a ratio.
constexpr double kMostScale = 2;

Similarity as_similarity(const Eigen::Matrix4d& matrix) {
  Similarity similarity;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) similarity.linear[row][column] = matrix(row, column);
    similarity.shift[row] = matrix(row, 3);
  }
  return similarity;
}

/// The similarity that brings the vertices of some faces nearest to their images (Umeyama 1991).
std::optional<Similarity> fit(const Workbench& bench, const std::vector<HalfedgeId>& entries) {
  const Mesh& source = bench.sides.source.mesh;
  const Mesh& target = bench.sides.target.mesh;
  const std::size_t step = std::max<std::size_t>(1, entries.size() / kSamples);
  const auto count = static_cast<Eigen::Index>((entries.size() + step - 1) / step);
  if (count < 3) return std::nullopt;
  Eigen::Matrix3Xd from(3, count), to(3, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const HalfedgeId entry = entries[static_cast<std::size_t>(k) * step];
    const Point& p = source.positions()[source.origin(entry).value];
    const Point& q = target.positions()[target.origin(bench.patchwork.image(entry)).value];
    for (int axis = 0; axis < 3; ++axis) {
      from(axis, k) = p[axis];
      to(axis, k) = q[axis];
    }
  }
  const Eigen::Matrix4d matrix = Eigen::umeyama(from, to, true);
  if (!matrix.allFinite()) return std::nullopt;
  return as_similarity(matrix);
}

/// Does a vertex land farther from its image than a third of the edges there?
bool lands_off(const Sides& sides, const Similarity& similarity, Candidate pair) {
  const auto place = [](const Mesh& mesh, VertexId v) -> const Point& { return mesh.positions()[v.value]; };
  const Mesh& target = sides.target.mesh;
  const Point& there = place(target, target.origin(pair.target));
  const double off =
      squared_distance(similarity(place(sides.source.mesh, sides.source.mesh.origin(pair.source))), there);
  return off > 0.1 * squared_distance(there, place(target, target.tip(pair.target)));
}

/// The share of the source's vertices that land near a vertex of the target. Judging by what is matched would confirm
/// the wrong half of a symmetric model.
/// @param least  a smaller share is of no interest: 0 as soon as it is sure to be.
double share_that_lands(const Workbench& bench, const Similarity& similarity, const VertexGrid& grid, double reach,
                        double least) {
  const std::span<const Point> positions = bench.sides.source.mesh.positions();
  const std::size_t step = std::max<std::size_t>(1, positions.size() / kSamples);
  const std::size_t samples = (positions.size() + step - 1) / step;
  const auto share = [samples](std::size_t landed) {
    return samples == 0 ? 0 : static_cast<double>(landed) / static_cast<double>(samples);
  };
  std::size_t may_land = samples;
  for (std::size_t v = 0; v < positions.size(); v += step) {
    if (grid.any_within(similarity(positions[v]), reach)) continue;
    if (share(--may_land) < least) return 0;
  }
  return share(may_land);
}

}  // namespace

std::optional<Similarity> find_placement(const Workbench& bench, const VertexGrid& target_grid) {
  const double edge = target_grid.cell();
  std::vector<Similarity> candidates{Similarity()};
  const double source_edge = mean_edge(bench.sides.source.mesh);
  const auto add = [&](const std::vector<HalfedgeId>& entries) {
    const std::optional<Similarity> found = fit(bench, entries);
    // What is matched wrongly is best fitted by a point, and all that shrinks to one vertex lands on it.
    const double ratio = found ? found->scale() * source_edge / edge : 0;
    if (ratio > 1 / kMostScale && ratio < kMostScale) candidates.push_back(*found);
  };
  const std::vector<SizedRegion> regions = largest_first(bench.patchwork);
  const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench, regions);
  std::vector<HalfedgeId> all;
  all.reserve(bench.patchwork.matched_faces());
  std::size_t taken = 0;
  for (const auto& [region, count] : regions) {
    all.insert(all.end(), faces[region].begin(), faces[region].end());
    if (taken++ < kMostRegions) add(faces[region]);
  }
  add(all);
  std::optional<Similarity> best;
  double most = kLeastShare;
  for (const Similarity& candidate : candidates) {
    const double least = most + (best ? 0.01 : 0);
    const double share = share_that_lands(bench, candidate, target_grid, kLands * edge, least);
    if (share >= least) {
      best = candidate;
      most = share;
    }
  }
  return best;
}

std::optional<LocalPlacement> local_placement(const Workbench& bench, const Point& point) {
  constexpr std::size_t kNearest = 100;
  const Mesh& source = bench.sides.source.mesh;
  std::vector<std::pair<double, HalfedgeId>> by_distance;
  for (const HalfedgeId entry : bench.patchwork.history()) {
    if (!bench.patchwork.is_matched(source.face(entry))) continue;
    by_distance.emplace_back(squared_distance(source.positions()[source.origin(entry).value], point), entry);
  }
  const std::size_t count = std::min(kNearest, by_distance.size());
  const auto last = by_distance.begin() + static_cast<std::ptrdiff_t>(count);
  std::partial_sort(by_distance.begin(), last, by_distance.end());
  std::vector<HalfedgeId> nearest;
  for (auto it = by_distance.begin(); it != last; ++it) nearest.push_back(it->second);
  const std::optional<Similarity> similarity = fit(bench, nearest);
  if (!similarity) return std::nullopt;
  double sum = 0;
  for (const HalfedgeId entry : nearest) {
    const Point landed = (*similarity)(source.positions()[source.origin(entry).value]);
    const VertexId image = bench.sides.target.mesh.origin(bench.patchwork.image(entry));
    sum += squared_distance(landed, bench.sides.target.mesh.positions()[image.value]);
  }
  return LocalPlacement{*similarity, std::sqrt(sum / static_cast<double>(count))};
}

bool lies_well(const Workbench& bench) {
  const std::vector<HalfedgeId>& history = bench.patchwork.history();
  const std::size_t step = history.size() / kSamples + 1;
  const auto is_well = [&](auto fits_badly) {
    for (std::size_t k = 0; k < history.size(); k += step) {
      if (fits_badly(Candidate{history[k], bench.patchwork.image(history[k])})) return false;
    }
    return true;
  };
  for (const std::optional<Similarity>& similarity : {std::optional(Similarity()), fit(bench, history)}) {
    if (similarity && is_well([&](Candidate pair) { return lands_off(bench.sides, *similarity, pair); })) return true;
  }
  return false;
}

void place(Workbench& bench) {
  bench.misfit.place(std::nullopt, 1.0);
  if (!bench.misfit.may_use_positions()) return;
  if (!bench.target_grid) {
    const Mesh& target = bench.sides.target.mesh;
    const double edge = mean_edge(target);
    if (edge <= 0) return;
    bench.target_grid.emplace(target, edge);
  }
  bench.misfit.place(find_placement(bench, *bench.target_grid), bench.target_grid->cell());
}

}  // namespace quadmatch::regions
