#pragma once
/// A bear to match with itself: a closed model of genus 0, box-modeled and subdivided, with and without its ears and
/// in any pose (Figs. 1.1 and 5.2).

#include <cstdint>

#include <quadmatch/shapes/model.hpp>

namespace quadmatch::shapes {

/// How the bear holds itself; angles in turns, all zero at rest. A pose moves vertices and nothing else.
struct BearPose {
  double left_arm = 0;   ///< raised to the side
  double right_arm = 0;  ///< likewise
  double left_leg = 0;   ///< swung forwards
  double right_leg = 0;  ///< likewise
  double head_turn = 0;  ///< to its left
  double head_tilt = 0;  ///< towards its left shoulder
  double body_bend = 0;  ///< the whole of it, to its left, more the higher up
};

struct BearOptions {
  bool ears = true;
  BearPose pose = {};
};

/// 2,944 quads with ears, 2,688 without.
///
/// Both begin with the same faces, with the same numbers and first corners: bear_common_faces() of them, which is all
/// but the places where the ears grow. Left and right are mirror images but for a patch sewn on the left of the belly.
[[nodiscard]] Model bear(const BearOptions& options = {});

/// Of the faces of either bear, how many the other has as well, from the first on: 2,656.
[[nodiscard]] std::uint32_t bear_common_faces();

}  // namespace quadmatch::shapes
