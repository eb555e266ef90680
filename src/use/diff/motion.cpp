#include "motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

namespace quadmatch::use {
namespace {

/// Below so many points some plane or line fits everything.
constexpr std::size_t kFewest = 4;

Eigen::Vector3d vector_of(const Point& p) { return {p[0], p[1], p[2]}; }

double diagonal(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const VertexId v : mesh.corners()) box.extend(vector_of(mesh.positions()[v.value]));
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// One column for each point.
Eigen::Matrix3Xd columns(const Mesh& mesh, const std::vector<VertexPair>& pairs, VertexId VertexPair::*side) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(pairs.size()));
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    points.col(static_cast<Eigen::Index>(k)) = vector_of(mesh.positions()[(pairs[k].*side).value]);
  }
  return points;
}

/// The similarity that lays one set of points on the other, if all of them land within `reach`.
std::optional<WholeMotion> fit(Eigen::Matrix3Xd from, const Eigen::Matrix3Xd& to, double reach, bool mirrored) {
  const Eigen::Vector3d shift = to.rowwise().mean() - from.rowwise().mean();
  if (mirrored) from.row(0) *= -1;
  const Eigen::Matrix4d matrix = Eigen::umeyama(from, to, true);
  const Eigen::Matrix3Xd landed = (matrix.topLeftCorner<3, 3>() * from).colwise() + matrix.topRightCorner<3, 1>();
  const double scale = std::cbrt(std::abs(matrix.topLeftCorner<3, 3>().determinant()));
  if (!(scale > 0) || !((landed - to).colwise().norm().maxCoeff() <= reach * std::max(1.0, scale))) return std::nullopt;
  const double cosine = (matrix.topLeftCorner<3, 3>().trace() / scale - 1) / 2;
  return WholeMotion{std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi, scale, mirrored, shift.norm()};
}

}  // namespace

Motion find_motion(const Mesh& source, const Mesh& target, const std::vector<VertexPair>& pairs, double tolerance) {
  Motion motion;
  if (source.positions().empty() || target.positions().empty()) return motion;
  const double reach = tolerance * diagonal(source);
  for (const VertexPair& pair : pairs) {
    const Eigen::Vector3d there = vector_of(source.positions()[pair.source.value]);
    const Eigen::Vector3d here = vector_of(target.positions()[pair.target.value]);
    // Not "farther than": a position that is no number is never where it was.
    if (!((here - there).norm() <= reach)) motion.moved.push_back(pair);
  }
  if (motion.moved.empty() || pairs.size() < kFewest) return motion;
  const Eigen::Matrix3Xd from = columns(source, pairs, &VertexPair::source);
  const Eigen::Matrix3Xd to = columns(target, pairs, &VertexPair::target);
  if (!from.allFinite() || !to.allFinite()) return motion;
  motion.whole = fit(from, to, reach, false);
  if (!motion.whole) motion.whole = fit(from, to, reach, true);
  return motion;
}

}  // namespace quadmatch::use
