#pragma once
/// Points, and the sine and cosine that are the same on every machine: libm's differ in the last bit, and shipped
/// models must come out byte for byte alike. (This layer is also compiled without fused multiply-add.)

#include <cmath>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

[[nodiscard]] inline Point operator+(const Point& a, const Point& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
[[nodiscard]] inline Point operator-(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
[[nodiscard]] inline Point operator*(double s, const Point& a) { return {s * a[0], s * a[1], s * a[2]}; }
[[nodiscard]] inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
[[nodiscard]] inline Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
/// @pre a is not zero
[[nodiscard]] inline Point normalized(const Point& a) { return (1.0 / std::sqrt(dot(a, a))) * a; }

/// A direction in the plane.
struct Heading {
  double cos = 1.0;
  double sin = 0.0;
};

/// Cosine and sine of a fraction of a full turn: heading(0.25) is (0, 1), exactly.
[[nodiscard]] inline Heading heading(double turns) {
  constexpr double kTurn = 6.283185307179586;
  const double quarters = std::floor(4.0 * turns + 0.5);
  const double angle = kTurn * (turns - quarters / 4.0);  // within an eighth of a turn of zero
  const double square = angle * angle;
  double cosine = 1.0, sine = 1.0;
  for (int n = 18; n > 0; n -= 2) {  // Taylor series, from the last term by Horner's rule
    cosine = 1.0 - cosine * square / (n * (n - 1));
    sine = 1.0 - sine * square / (n * (n + 1));
  }
  sine *= angle;
  switch (static_cast<long long>(quarters) & 3) {
    case 0:
      return {cosine, sine};
    case 1:
      return {-sine, cosine};
    case 2:
      return {-cosine, -sine};
    default:
      return {sine, -cosine};
  }
}

}  // namespace quadmatch::shapes
