#pragma once
/// Where the vertices of a merged mesh are.

#include <vector>

#include "layout.hpp"
#include "values.hpp"

namespace quadmatch::use {

struct MergedPositions {
  std::vector<Point> points;        ///< one per vertex of the layout, or none where one of the three has none
  std::uint32_t carried_along = 0;  ///< as in MergeReport
};

/// The position of the side that moved the vertex. One whose faces one side changed is where that side has it, and is
/// carried along by what the other side moved: by as much as the other moved it, or, where that has no such vertex, by
/// the harmonic mean of how far it moved those around.
[[nodiscard]] MergedPositions merge_positions(const ThreeFiles& files, const Cells& cells, const Junctions& junctions,
                                              const Layout& layout, const Origins& origins, Side preferred,
                                              ValueTally& tally);

}  // namespace quadmatch::use
