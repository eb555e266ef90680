#include <quadmatch/shapes/bear.hpp>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <vector>

#include "cage.hpp"

namespace quadmatch::shapes {
namespace {

using Face = Cage::Face;
using Faces = std::vector<Face>;

/// In the order of the file. The bases of the ears are part of the head, or the tips of the ears.
enum Part : Cage::Part {
  Body,
  Patch,
  Tail,
  LeftArm,
  RightArm,
  LeftLeg,
  RightLeg,
  Head,
  Eyes,
  Snout,
  Nose,
  EarBases,
  Ears,
};

constexpr unsigned kSteps = 2;
constexpr double kTextureUnit = 0.04;  // so that coordinates of the refined mesh are whole hundredths
constexpr std::uint32_t kFacesOfACageFace = 16;

/// A cross-section of body and head: y, half the width, and z in front and behind.
struct Section {
  double y, half_width, front, back;
};
constexpr std::array<Section, 7> kSections = {{{0.44, 0.60, 0.44, -0.44},
                                               {0.86, 0.84, 0.84, -0.60},
                                               {1.32, 0.58, 0.50, -0.42},
                                               {1.48, 0.40, 0.30, -0.30},
                                               {1.58, 0.74, 0.54, -0.50},
                                               {1.96, 0.94, 0.68, -0.66},
                                               {2.42, 0.68, 0.42, -0.46}}};
constexpr std::uint32_t kRows = kSections.size() - 1;
enum Row : std::uint32_t { Belly, Chest, Neck, Jaw, Cheeks, Brow };

/// Body and head stand in one box, 3 quads wide and 2 deep, before anything is extruded from it.
class BearCage {
 public:
  BearCage() {
    add_trunk();
    sew_patch();
    pull_tail();
    for (const double side : {1.0, -1.0}) {
      pull_arm(side);
      pull_leg(side);
    }
    pull_snout();
    for (const double side : {1.0, -1.0}) sink_eye(side);
    cage_.set_part(ear_base(1), EarBases);
    cage_.set_part(ear_base(-1), EarBases);
  }

  void pull_ears() {
    for (const double side : {1.0, -1.0}) pull_ear(side);
  }
  void pose(const BearPose& pose);
  [[nodiscard]] const Cage& cage() const { return cage_; }

 private:
  static constexpr std::uint32_t kAround = 10;

  void add_trunk();
  void sew_patch();
  void pull_tail();
  void pull_arm(double side);
  void pull_leg(double side);
  void pull_snout();
  void sink_eye(double side);
  void pull_ear(double side);

  /// Faces of the box's wall: columns 0-2 in front from its right to its left, 3-4 on its left, 5-7 behind, 8-9.
  [[nodiscard]] Face wall(Row row, std::uint32_t column) const { return walls_[row * kAround + column]; }
  [[nodiscard]] Face ear_base(double side) const { return side > 0 ? top_[2] : top_[0]; }

  Cage cage_;
  Faces walls_;
  Faces bottom_, top_;  // 3 in front, 3 behind, each from its right to its left
};

/// A point of a section: columns 0-3 from the bear's right to its left, rows from front to back.
Point section_point(const Section& section, std::uint32_t column, std::uint32_t row) {
  constexpr std::array<double, 4> kAcross = {-1.0, -0.42, 0.42, 1.0};
  const double middle = 0.5 * (section.front + section.back);
  const double depth = row == 0 ? section.front : row == 1 ? middle : section.back;
  const bool corner = row != 1 && (column == 0 || column == 3);
  const double pulled_in = corner ? 0.82 : 1.0;  // rounder than a box
  return {pulled_in * section.half_width * kAcross[column], section.y, middle + pulled_in * (depth - middle)};
}

void BearCage::add_trunk() {
  // The way around a section, seen from above counter-clockwise, from its right side in front.
  constexpr std::array<std::array<std::uint32_t, 2>, kAround> kLoop = {
      {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};
  std::vector<std::array<Cage::Vertex, kAround>> loops;
  for (const Section& section : kSections) {
    loops.emplace_back();
    for (std::uint32_t i = 0; i < kAround; ++i) {
      loops.back()[i] = cage_.add_vertex(section_point(section, kLoop[i][0], kLoop[i][1]));
    }
  }
  const Cage::Chart wall_chart = cage_.add_chart();
  for (std::uint32_t row = 0; row < kRows; ++row) {
    const auto &low = loops[row], &high = loops[row + 1];
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t j = (i + 1) % kAround;
      walls_.push_back(cage_.add_face(row < Jaw ? Body : Head, wall_chart, i, row, {low[i], low[j], high[j], high[i]}));
    }
  }
  for (const bool is_top : {false, true}) {
    const auto& loop = is_top ? loops.back() : loops.front();
    const Section& section = is_top ? kSections.back() : kSections.front();
    const Point bulge = {0, is_top ? 0.1 : -0.06, 0};
    std::array<std::array<Cage::Vertex, 4>, 3> at = {};  // by row and column
    for (std::uint32_t i = 0; i < kAround; ++i) at[kLoop[i][1]][kLoop[i][0]] = loop[i];
    for (const std::uint32_t column : {1U, 2U}) {
      at[1][column] = cage_.add_vertex(section_point(section, column, 1) + bulge);
    }
    const Cage::Chart chart = cage_.add_chart();
    for (std::uint32_t row = 0; row < 2; ++row) {
      for (std::uint32_t c = 0; c < 3; ++c) {
        const auto &front = at[row], &back = at[row + 1];
        if (is_top) {
          top_.push_back(cage_.add_face(Head, chart, c, row, {front[c], front[c + 1], back[c + 1], back[c]}));
        } else {
          bottom_.push_back(cage_.add_face(Body, chart, c, row, {back[c], back[c + 1], front[c + 1], front[c]}));
        }
      }
    }
  }
}

/// On the left of the belly only, so that the bear is not quite its own mirror image.
void BearCage::sew_patch() {
  const Faces at = {wall(Belly, 2)};
  const Point centre = cage_.centre(at);
  cage_.extrude(at, Patch, cage_.add_chart(), scale_and_move(centre, {0.62, 0.62, 0.62}, {0.01, 0.0, 0.05}));
  cage_.set_part(at[0], Patch);
}

void BearCage::pull_tail() {
  const Faces at = {wall(Belly, 6)};
  const Point centre = cage_.centre(at);
  cage_.extrude(at, Tail, cage_.add_chart(), scale_and_move(centre, {0.5, 0.7, 1.0}, {0, -0.02, -0.24}));
  cage_.set_part(at[0], Tail);
}

/// Two faces at the shoulder; three rings down to the paw.
void BearCage::pull_arm(double side) {
  const Part part = side > 0 ? LeftArm : RightArm;
  const Faces at = side > 0 ? Faces{wall(Chest, 3), wall(Chest, 4)} : Faces{wall(Chest, 8), wall(Chest, 9)};
  const Cage::Chart chart = cage_.add_chart();
  const auto pull = [&](const Point& factors, const Point& by, double droop) {
    const Point centre = cage_.centre(at);
    cage_.extrude(at, part, chart, [&](const Point& p) {
      return scale_and_move(centre, factors, {side * by[0], by[1], by[2]})(turned(p, centre, {0, 0, 1}, -side * droop));
    });
  };
  pull({0.95, 0.95, 0.62}, {0.26, -0.08, 0.02}, 0.11);
  pull({1.05, 1.05, 1.05}, {0.24, -0.26, 0.05}, 0.09);
  pull({1.0, 1.0, 1.0}, {0.12, -0.22, 0.06}, 0.04);
  for (const Face f : at) cage_.set_part(f, part);
}

/// Two faces under the hip; down to the ankle, and the foot forwards.
void BearCage::pull_leg(double side) {
  const Part part = side > 0 ? LeftLeg : RightLeg;
  const std::uint32_t column = side > 0 ? 2 : 0;
  const Faces sole = {bottom_[column], bottom_[3 + column]};
  const Cage::Chart chart = cage_.add_chart();
  cage_.extrude(sole, part, chart, scale_and_move(cage_.centre(sole), {1.45, 0.2, 0.9}, {side * 0.10, -0.16, 0.02}));
  const Faces ankle = cage_.extrude(sole, part, chart,
                                    scale_and_move(cage_.centre(sole), {1.05, 0.0, 1.0}, {side * 0.03, -0.28, 0.02}));
  const Faces toes = {cage_.farthest(ankle, {0, 0, 1})};
  cage_.extrude(toes, part, cage_.add_chart(),
                scale_and_move(cage_.centre(toes), {1.1, 0.95, 1.0}, {side * 0.05, 0.0, 0.32}));
  for (const Face f : {sole[0], sole[1], toes[0]}) cage_.set_part(f, part);
}

void BearCage::pull_snout() {
  const Faces at = {wall(Cheeks, 1)};
  const Cage::Chart chart = cage_.add_chart();
  cage_.extrude(at, Snout, chart, scale_and_move(cage_.centre(at), {0.9, 0.75, 1.0}, {0, -0.07, 0.06}));
  cage_.extrude(at, Snout, chart, scale_and_move(cage_.centre(at), {0.85, 0.85, 0.2}, {0, 0.0, 0.24}));
  cage_.extrude(at, Nose, chart, scale_and_move(cage_.centre(at), {0.55, 0.42, 1.0}, {0, 0.07, 0.03}));
  cage_.set_part(at[0], Nose);
}

void BearCage::sink_eye(double side) {
  const Faces at = {wall(Brow, side > 0 ? 2 : 0)};
  const Cage::Chart chart = cage_.add_chart();
  const Point centre = cage_.centre(at);
  cage_.extrude(at, Head, chart, scale_and_move(centre, {0.46, 0.42, 0.46}, {-side * 0.13, -0.05, 0.14}));
  cage_.set_part(at[0], Eyes);
}

void BearCage::pull_ear(double side) {
  const Faces at = {ear_base(side)};
  const Cage::Chart chart = cage_.add_chart();
  cage_.extrude(at, Ears, chart, scale_and_move(cage_.centre(at), {1.4, 1.0, 0.55}, {side * 0.17, 0.02, -0.06}));
  cage_.extrude(at, Ears, chart, scale_and_move(cage_.centre(at), {1.2, 1.2, 0.9}, {side * 0.10, 0.33, 0.0}));
}

void BearCage::pose(const BearPose& pose) {
  const auto turn = [this](std::initializer_list<Cage::Part> parts, const Point& about, const Point& axis,
                           double turns) {
    cage_.move_parts(std::vector(parts), [&](const Point& p) { return turned(p, about, axis, turns); });
  };
  turn({LeftArm}, {0.46, 1.10, 0}, {0, 0, 1}, pose.left_arm);
  turn({RightArm}, {-0.46, 1.10, 0}, {0, 0, 1}, -pose.right_arm);
  turn({LeftLeg}, {0.28, 0.50, 0}, {1, 0, 0}, -pose.left_leg);
  turn({RightLeg}, {-0.28, 0.50, 0}, {1, 0, 0}, -pose.right_leg);
  const std::initializer_list<Cage::Part> head = {Head, Eyes, Snout, Nose, EarBases, Ears};
  turn(head, {0, 1.45, 0}, {0, 1, 0}, pose.head_turn);
  turn(head, {0, 1.45, 0}, {0, 0, 1}, -pose.head_tilt);
  cage_.move_all([&](const Point& p) {
    const double share = std::clamp((p[1] - 0.4) / 1.6, 0.0, 1.2);
    return turned(p, {0, 0.4, 0}, {0, 0, 1}, -pose.body_bend * share);
  });
}

std::vector<Cage::PartName> part_names(bool ears) {
  return {{"body", "fur"},      {"patch", "patch"},  {"tail", "fur"},      {"left_arm", "fur"},
          {"right_arm", "fur"}, {"left_leg", "fur"}, {"right_leg", "fur"}, {"head", "fur"},
          {"eyes", "eyes"},     {"snout", "muzzle"}, {"nose", "nose"},     {ears ? "ears" : "crown", "fur"},
          {"ears", "fur"}};
}

}  // namespace

Model bear(const BearOptions& options) {
  BearCage bear;
  if (options.ears) bear.pull_ears();
  bear.pose(options.pose);
  return bear.cage().finish(part_names(options.ears), kSteps, kTextureUnit);
}

std::uint32_t bear_common_faces() {
  return kFacesOfACageFace * (BearCage().cage().face_count() - 2);  // all but the bases of the ears
}

}  // namespace quadmatch::shapes
