#pragma once
/// A turn, a uniform scale and a shift.

#include <array>
#include <cmath>
#include <cstddef>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::regions {

struct Similarity {
  std::array<std::array<double, 3>, 3> linear = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  Point shift = {0, 0, 0};

  [[nodiscard]] double scale() const { return std::hypot(linear[0][0], linear[1][0], linear[2][0]); }
  [[nodiscard]] Point operator()(const Point& p) const {
    Point image = shift;
    for (std::size_t row = 0; row < 3; ++row) {
      for (std::size_t column = 0; column < 3; ++column) image[row] += linear[row][column] * p[column];
    }
    return image;
  }
};

[[nodiscard]] inline double squared_distance(const Point& a, const Point& b) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
  return sum;
}

}  // namespace quadmatch::regions
