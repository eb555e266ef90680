#pragma once
/// Where to light the fire: spokes whose colours are unique in both meshes, from those that see far to those that
/// see little.

#include <cstdint>
#include <vector>

#include <quadmatch/analysis/spoke_colours.hpp>

#include "fire.hpp"

namespace quadmatch::regions {

/// The spokes of both meshes, coloured alike.
struct ColouredSpokes {
  SpokeColours source, target;
};

/// @param arc_lengths  with them a colour is very safe; without, unmoved by inserted edge loops.
[[nodiscard]] ColouredSpokes colour_both(const Sides& sides, bool arc_lengths);

/// How much is asked of an anchor.
enum class Caution {
  High,  ///< first: three rounds with arc lengths, or four without and with neighbours that agree
  Low,   ///< for what is left when the rest is matched: one round fewer
};

/// Find anchors among the spokes whose faces are free in their mesh.
/// @return  by handicap, ascending; at most one for each extraordinary vertex. Independent of the numbering.
/// @par Cost  O(#spokes log #spokes).
[[nodiscard]] std::vector<Spark> find_sparks(const Sides& sides, const ColouredSpokes& with_lengths,
                                             const ColouredSpokes& without, const Patchwork& patchwork,
                                             Caution caution);

}  // namespace quadmatch::regions
