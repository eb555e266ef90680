#include "camera.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace quadmatch::picture {
namespace {

constexpr double kHalfFieldOfView = 15 * 3.14159265358979323846 / 180;

Point unit(const Point& p) {
  const double length = std::sqrt(dot(p, p));
  return {p[0] / length, p[1] / length, p[2] / length};
}

Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

/// From the middle of the mesh to the camera.
Point direction_of(PictureView view) {
  switch (view) {
    case PictureView::Front:
      return {0, 0, 1};
    case PictureView::Back:
      return {0, 0, -1};
    case PictureView::Left:
      return {-1, 0, 0};
    case PictureView::Right:
      return {1, 0, 0};
    case PictureView::Above:
      return {0, 1, 0};
    case PictureView::Below:
      return {0, -1, 0};
    default:
      return unit({-0.42, 0.3, 1});
  }
}

/// What points up in the picture.
Point upright_of(PictureView view) {
  if (view == PictureView::Above) return {0, 0, -1};
  if (view == PictureView::Below) return {0, 0, 1};
  return {0, 1, 0};
}

struct Box {
  Point low, high;
};

Box box_of(const Mesh& mesh) {
  const std::span<const Point> points = mesh.positions();
  Box box{points[mesh.corners().front().value], points[mesh.corners().front().value]};
  for (const VertexId corner : mesh.corners()) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::min(box.low[axis], points[corner.value][axis]);
      box.high[axis] = std::max(box.high[axis], points[corner.value][axis]);
    }
  }
  return box;
}

/// The first vertex of a face that is nowhere, or no vertex.
VertexId first_not_finite(const Mesh& mesh) {
  const auto finite = [&](VertexId corner) {
    const Point& p = mesh.positions()[corner.value];
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  const auto place = std::find_if_not(mesh.corners().begin(), mesh.corners().end(), finite);
  return place == mesh.corners().end() ? VertexId{} : *place;
}

}  // namespace

Expected<std::vector<Point>> framed(const MeshFile& file) {
  const Mesh& mesh = file.mesh;
  if (mesh.positions().empty() || mesh.corners().empty()) {
    return Unexpected(
        Error{ErrorCode::BadArgument, "the mesh has no positions, so there is nothing to draw", file.path});
  }
  if (const VertexId lost = first_not_finite(mesh); lost.valid()) {
    return Unexpected(
        Error{ErrorCode::BadArgument,
              fmt::format("{} is nowhere (its position is no number), so the mesh cannot be drawn", to_string(lost)),
              file.path});
  }
  const Box box = box_of(mesh);
  // First by the box, in halves, so that nothing overflows; then by the distance of the farthest vertex.
  double extent = 0;
  Point centre = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    centre[axis] = box.low[axis] / 2 + box.high[axis] / 2;
    extent = std::max(extent, box.high[axis] / 2 - box.low[axis] / 2);
  }
  std::vector<Point> points(mesh.vertex_count(), Point{0, 0, 0});
  double squared = 0;
  for (const VertexId corner : mesh.corners()) {
    Point& point = points[corner.value];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double away = mesh.positions()[corner.value][axis] - centre[axis];
      point[axis] = extent > 0 ? away / extent : 0;
    }
    squared = std::max(squared, dot(point, point));
  }
  const double radius = squared > 0 ? std::sqrt(squared) : 1;
  for (Point& point : points) {
    for (double& coordinate : point) coordinate /= radius;
  }
  return points;
}

Camera::Camera(PictureView view, std::uint32_t width, std::uint32_t height)
    : back_(direction_of(view)), width_(width), height_(height) {
  right_ = unit(cross(upright_of(view), back_));
  up_ = cross(back_, right_);
  // So far away that the unit sphere fills the view, and a little farther.
  const double distance = 1.05 / std::sin(kHalfFieldOfView);
  eye_ = {distance * back_[0], distance * back_[1], distance * back_[2]};
  // A narrow view shows as much as a square one.
  step_ = 2 * std::tan(kHalfFieldOfView) / std::min(width_, height_);
}

std::array<float, 2> Camera::pixel_of(const Point& point) const {
  const Point away = {point[0] - eye_[0], point[1] - eye_[1], point[2] - eye_[2]};
  const double pixels = 1 / (-dot(away, back_) * step_);
  return {static_cast<float>(width_ / 2 + dot(away, right_) * pixels),
          static_cast<float>(height_ / 2 - dot(away, up_) * pixels)};
}

Point Camera::ray_through(double x, double y) const {
  const double aside = (x - width_ / 2) * step_;
  const double above = (height_ / 2 - y) * step_;
  Point ray = {};
  for (std::size_t axis = 0; axis < 3; ++axis) ray[axis] = aside * right_[axis] + above * up_[axis] - back_[axis];
  return ray;
}

Point Camera::seen(const Point& direction) const {
  return {dot(direction, right_), dot(direction, up_), dot(direction, back_)};
}

}  // namespace quadmatch::picture
