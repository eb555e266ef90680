#pragma once
/// Where a mesh stands and from where it is looked at.

#include <array>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/picture/picture.hpp>

namespace quadmatch::picture {

/// The positions of a mesh moved and scaled into the unit sphere, by what its faces use; other vertices are 0.
/// @par Errors  BadArgument where there are none, or one is not finite, with the name of the file.
[[nodiscard]] Expected<std::vector<Point>> framed(const MeshFile& file);

/// A pinhole camera that looks at the origin: web/src/picture/linked_cameras.ts has the same.
class Camera {
 public:
  /// A pane of so many pixels.
  Camera(PictureView view, std::uint32_t width, std::uint32_t height);

  [[nodiscard]] const Point& eye() const { return eye_; }
  /// Where a point is seen, in pixels from the upper left corner. @pre it lies in the unit sphere.
  [[nodiscard]] std::array<float, 2> pixel_of(const Point& point) const;
  /// The direction of what is seen at a place of the pane; of no particular length.
  [[nodiscard]] Point ray_through(double x, double y) const;
  /// A direction as it is seen: to the right, up, and towards us.
  [[nodiscard]] Point seen(const Point& direction) const;

 private:
  Point right_, up_, back_, eye_;
  double width_, height_;
  /// Of a pixel, one length in front of the eye.
  double step_;
};

[[nodiscard]] inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace quadmatch::picture
