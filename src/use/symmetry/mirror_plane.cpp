#include "mirror_plane.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

namespace quadmatch {

Point MirrorPlane::mirrored(const Point& p) const {
  const double height = normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] - offset;
  return {p[0] - 2 * height * normal[0], p[1] - 2 * height * normal[1], p[2] - 2 * height * normal[2]};
}

namespace use {
namespace {

/// Pairs and vertices looked at.
constexpr std::size_t kSamples = 2000;

Eigen::Vector3d vector_of(const Point& p) { return {p[0], p[1], p[2]}; }

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// The lowest and the highest corner of the box around points.
std::pair<Point, Point> box_of(std::span<const Point> points) {
  Point low = points.front(), high = points.front();
  for (const Point& p : points) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  return {low, high};
}

/// The best plane for weighted pairs. With p and q about the common middle, the sum of |q - (p - 2 n n'p)|^2 is a
/// constant plus 4 n' (sum p q') n: least for the eigenvector of the least eigenvalue.
MirrorPlane weighted_plane(std::span<const Point> from, std::span<const Point> to, const std::vector<double>& weights) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  double total = 0;
  for (std::size_t k = 0; k < from.size(); ++k) {
    middle += weights[k] * 0.5 * (vector_of(from[k]) + vector_of(to[k]));
    total += weights[k];
  }
  middle /= total;
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < from.size(); ++k) {
    const Eigen::Vector3d p = vector_of(from[k]) - middle, q = vector_of(to[k]) - middle;
    sum += weights[k] * (p * q.transpose() + q * p.transpose());
  }
  Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(0);
  Eigen::Index largest = 0;
  normal.cwiseAbs().maxCoeff(&largest);
  if (normal[largest] < 0) normal = -normal;
  return {{normal[0], normal[1], normal[2]}, normal.dot(middle), 0};
}

/// Is a vertex within reach of a point? Candidates are found by x.
class NearPoints {
 public:
  explicit NearPoints(std::span<const Point> points) : points_(points.begin(), points.end()) {
    std::sort(points_.begin(), points_.end());
  }
  [[nodiscard]] bool any_within(const Point& point, double reach) const {
    auto here = std::lower_bound(points_.begin(), points_.end(), Point{point[0] - reach, -HUGE_VAL, -HUGE_VAL});
    for (; here != points_.end() && (*here)[0] <= point[0] + reach; ++here) {
      if (distance(*here, point) <= reach) return true;
    }
    return false;
  }

 private:
  std::vector<Point> points_;
};

}  // namespace

double mean_edge(const Mesh& mesh) {
  if (mesh.positions().empty() || mesh.halfedge_count() == 0) return 0;
  double sum = 0;
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId side(h);
    sum += distance(mesh.positions()[mesh.origin(side).value], mesh.positions()[mesh.tip(side).value]);
  }
  return sum / mesh.halfedge_count();
}

std::optional<MirrorPlane> fit_plane(const Mesh& mesh, std::span<const VertexPair> pairs) {
  constexpr int kRounds = 12;
  if (mesh.positions().empty() || pairs.empty()) return std::nullopt;
  std::vector<Point> from, to;
  const std::size_t step = pairs.size() / kSamples + 1;
  for (std::size_t k = 0; k < pairs.size(); k += step) {
    from.push_back(mesh.positions()[pairs[k].source.value]);
    to.push_back(mesh.positions()[pairs[k].target.value]);
  }
  const auto [low, high] = box_of(from);
  const double size = distance(low, high);
  std::vector<double> weights(from.size(), 1.0), off(from.size());
  MirrorPlane plane;
  for (int round = 0; round < kRounds; ++round) {
    plane = weighted_plane(from, to, weights);
    for (std::size_t k = 0; k < from.size(); ++k) {
      off[k] = distance(plane.mirrored(from[k]), to[k]);
      const double far = off[k] / (1e-4 * size + 1e-30);
      weights[k] = round < kRounds / 2 ? 1 / (far + 0.1) : 1 / (far * far + 1);  // at last hardly any
    }
  }
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::nth_element(off.begin(), middle, off.end());
  plane.error = size > 0 ? *middle / size : 0;
  return plane;
}

MirrorPlane likely_plane(const Mesh& mesh, double edge) {
  const std::span<const Point> points = mesh.positions();
  const auto [low, high] = box_of(points);
  const NearPoints near(points);
  const std::size_t step = points.size() / 200 + 1;
  MirrorPlane best;
  std::size_t most = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    MirrorPlane plane{{0, 0, 0}, (low[axis] + high[axis]) / 2, 0};
    plane.normal[axis] = 1;
    std::size_t opposite = 0;
    for (std::size_t v = 0; v < points.size(); v += step) {
      opposite += near.any_within(plane.mirrored(points[v]), 0.1 * edge);
    }
    if (axis > 0 && opposite <= most) continue;
    best = plane;
    most = opposite;
  }
  return best;
}

}  // namespace use
}  // namespace quadmatch
