#pragma once
/// What a merge has to tell of the meshes: changes of either side, conflicts, doubts.

#include "layout.hpp"
#include "values.hpp"

namespace quadmatch::use {

[[nodiscard]] SideChanges changes_of(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions,
                                     Side side);

[[nodiscard]] std::vector<ConflictArea> conflict_areas(const ThreeMeshes& meshes, const Cells& cells,
                                                       const Junctions& junctions, const Layout& layout,
                                                       const Mesh& result);

/// Regions of the match to one side that are ambiguous or of low confidence, and in which the other changed something.
[[nodiscard]] std::vector<DoubtfulPart> doubtful_parts(const ThreeMeshes& meshes, const Cells& cells,
                                                       const Junctions& junctions, Side side, const Match& match);

/// Of the departures that building a mesh finds: those of which the result has more than the sides have, together.
[[nodiscard]] std::vector<DepartureKind> new_departures(const ThreeMeshes& meshes, const Mesh& result);

}  // namespace quadmatch::use
