#include <quadmatch/shapes/shirt.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include "cage.hpp"

namespace quadmatch::shapes {
namespace {

using Vertex = Cage::Vertex;
using Loop = std::vector<Vertex>;

/// In the order of the file: what only long sleeves have comes last.
enum Part : Cage::Part {
  Front,
  Back,
  Collar,
  Pocket,
  LeftSleeve,
  RightSleeve,
  LeftLowerSleeve,
  RightLowerSleeve,
  LeftCuff,
  RightCuff
};

constexpr std::uint32_t kColumns = 10;  // across the front, and across the back
constexpr std::uint32_t kRows = 14;     // from the waist to the shoulders
constexpr std::uint32_t kArmhole = 10;  // the row where the armholes begin
constexpr std::uint32_t kShoulder = 3;  // columns from an armhole to the neck
constexpr std::uint32_t kUpperRings = 4, kLowerRings = 6, kCuffRings = 2;
constexpr std::uint32_t kAround = 2 * (kRows - kArmhole);  // quads around a sleeve
constexpr unsigned kSteps = 1;
constexpr double kTextureUnit = 0.032;  // the charts are 28 units high

/// Front and back of the shirt lie on each other like two sheets, sewn together at the sides and shoulders.
class ShirtCage {
 public:
  explicit ShirtCage(Sleeves sleeves) {
    for (std::uint32_t j = 0; j <= kRows; ++j) {
      for (std::uint32_t i = 0; i <= kColumns; ++i) {
        if (!is_above_neckline(i, j)) at(front_, i, j) = cage_.add_vertex(sheet_point(i, j, 1));
        at(back_, i, j) = is_sewn(i, j) ? at(front_, i, j) : cage_.add_vertex(sheet_point(i, j, -1));
      }
    }
    add_sheets();
    add_collar();
    sew_pocket();
    for (const double side : {1.0, -1.0}) add_sleeve(side, sleeves);
  }

  [[nodiscard]] const Cage& cage() const { return cage_; }

 private:
  using Sheet = std::array<Vertex, std::size_t{kColumns + 1} * (kRows + 1)>;

  static Vertex& at(Sheet& sheet, std::uint32_t i, std::uint32_t j) { return sheet[j * (kColumns + 1) + i]; }
  static bool is_sewn(std::uint32_t i, std::uint32_t j) {
    const bool side = (i == 0 || i == kColumns) && j <= kArmhole;
    const bool shoulder = j == kRows && (i <= kShoulder || i >= kColumns - kShoulder);
    return side || shoulder;
  }
  /// The neckline is a row lower in front: the quads that are cut out, and the vertices.
  static bool is_neckline(std::uint32_t i, std::uint32_t j) {
    return j == kRows - 1 && i >= kShoulder && i < kColumns - kShoulder;
  }

  static bool is_above_neckline(std::uint32_t i, std::uint32_t j) {
    return j == kRows && i > kShoulder && i < kColumns - kShoulder;
  }

  static Point sheet_point(std::uint32_t i, std::uint32_t j, double side);
  void add_sheets();
  void add_collar();
  void sew_pocket();
  void add_sleeve(double side, Sleeves sleeves);
  [[nodiscard]] Loop armhole(double side);
  Loop add_ring(Cage::Part part, Cage::Chart chart, std::uint32_t row, const Loop& rim, const Loop& outer);

  Cage cage_;
  Sheet front_ = {}, back_ = {};
  std::vector<Cage::Face> pocket_;
};

/// Column i from the wearer's right to its left, row j from the waist up; side 1 in front, -1 behind.
Point ShirtCage::sheet_point(std::uint32_t i, std::uint32_t j, double side) {
  const Heading around = heading(0.5 - 0.5 * i / kColumns);  // half an ellipse
  const double up = 1.0 * j / kRows;
  const double above = j <= kArmhole ? 0.0 : 1.0 * (j - kArmhole) / (kRows - kArmhole);
  const double half_width = 0.50 + 0.03 * (1 - up) - 0.05 * above;
  const double depth = 0.24 * (1 - above * above);
  const bool shoulder = i <= kShoulder || i >= kColumns - kShoulder;
  const double neck = shoulder ? 0.0 : 0.13 * above * above;
  const double slack = i == 0 || i == kColumns ? 0.13 * heading(0.5 * above).sin : 0.0;  // the armholes' width
  const double slope = 0.16 * above * around.cos * around.cos;
  return {half_width * around.cos, 1.3 * up - slope, side * (depth * around.sin + neck + slack)};
}

void ShirtCage::add_sheets() {
  const Cage::Chart front = cage_.add_chart(), back = cage_.add_chart();
  for (std::uint32_t j = 0; j < kRows; ++j) {
    for (std::uint32_t i = 0; i < kColumns; ++i) {
      const std::uint32_t left = i + 1, up = j + 1;
      cage_.add_face(Back, back, kColumns - left, j,
                     {at(back_, left, j), at(back_, i, j), at(back_, i, up), at(back_, left, up)});
      if (is_neckline(i, j)) continue;
      const Cage::Face face = cage_.add_face(
          Front, front, i, j, {at(front_, i, j), at(front_, left, j), at(front_, left, up), at(front_, i, up)});
      if ((i == 6 || i == 7) && (j == 8 || j == 9)) pocket_.push_back(face);
    }
  }
}

/// Quads between a rim, given as the faces on it run along it, and as many vertices further out.
Loop ShirtCage::add_ring(Cage::Part part, Cage::Chart chart, std::uint32_t row, const Loop& rim, const Loop& outer) {
  const auto size = static_cast<std::uint32_t>(rim.size());
  for (std::uint32_t m = 0; m < size; ++m) {
    const std::uint32_t next = (m + 1) % size;
    cage_.add_face(part, chart, size - 1 - m, row, {rim[next], rim[m], outer[m], outer[next]});
  }
  return outer;
}

void ShirtCage::add_collar() {
  Loop rim = {at(front_, kColumns - kShoulder, kRows)};
  for (std::uint32_t i = kColumns - kShoulder; i >= kShoulder; --i) rim.push_back(at(front_, i, kRows - 1));
  for (std::uint32_t i = kShoulder; i < kColumns - kShoulder; ++i) rim.push_back(at(back_, i, kRows));
  Loop outer;
  for (const Vertex v : rim) {
    const Point point = cage_.position(v);
    outer.push_back(cage_.add_vertex({0.92 * point[0], point[1] + 0.07, 0.92 * point[2]}));
  }
  add_ring(Collar, cage_.add_chart(), 0, rim, outer);
}

void ShirtCage::sew_pocket() {
  cage_.extrude(pocket_, Pocket, cage_.add_chart(),
                scale_and_move(cage_.centre(pocket_), {0.94, 0.94, 0.94}, {0, 0, 0.03}));
  for (const Cage::Face face : pocket_) cage_.set_part(face, Pocket);
}

/// From the armpit up in front and down behind on the left, the other way round on the right.
Loop ShirtCage::armhole(double side) {
  const std::uint32_t column = side > 0 ? kColumns : 0;
  Loop rim;
  for (std::uint32_t j = kArmhole; j <= kRows; ++j) rim.push_back(at(front_, column, j));
  for (std::uint32_t j = kRows - 1; j > kArmhole; --j) rim.push_back(at(back_, column, j));
  if (side < 0) std::reverse(rim.begin() + 1, rim.end());
  return rim;
}

void ShirtCage::add_sleeve(double side, Sleeves sleeves) {
  const bool left = side > 0, is_long = sleeves == Sleeves::Long;
  const std::uint32_t rings = is_long ? kUpperRings + kLowerRings + kCuffRings : kUpperRings;
  const Heading droop = heading(0.11);
  const Point along = {side * droop.cos, -droop.sin, 0}, up = {side * droop.sin, droop.cos, 0};
  const Cage::Chart chart = cage_.add_chart();
  Loop rim = armhole(side);
  Cage::Part part = left ? LeftSleeve : RightSleeve;
  for (std::uint32_t ring = 1; ring <= rings; ++ring) {
    if (ring > kUpperRings) part = left ? LeftLowerSleeve : RightLowerSleeve;
    if (ring > kUpperRings + kLowerRings) part = left ? LeftCuff : RightCuff;
    const bool flares = part == LeftCuff || part == RightCuff;
    const double radius = flares ? 0.115 : 0.155 - 0.006 * ring;
    const Point middle = Point{side * 0.47, 1.04, 0} + (0.075 * ring) * along;
    Loop outer;
    for (std::uint32_t m = 0; m < kAround; ++m) {
      const Heading around = heading(1.0 * m / kAround);  // from the armpit to the front, or to the back
      outer.push_back(cage_.add_vertex(middle + (-radius * around.cos) * up + Point{0, 0, side * radius * around.sin}));
    }
    rim = add_ring(part, chart, ring - 1, rim, outer);
  }
}

}  // namespace

Model shirt(Sleeves sleeves) {
  const std::vector<Cage::PartName> names = {{"front", "cloth"},
                                             {"back", "cloth"},
                                             {"collar", "trim"},
                                             {"pocket", "trim"},
                                             {"left_sleeve", "cloth"},
                                             {"right_sleeve", "cloth"},
                                             {"left_lower_sleeve", "cloth"},
                                             {"right_lower_sleeve", "cloth"},
                                             {"left_cuff", "trim"},
                                             {"right_cuff", "trim"}};
  return ShirtCage(sleeves).cage().finish(names, kSteps, kTextureUnit);
}

}  // namespace quadmatch::shapes
