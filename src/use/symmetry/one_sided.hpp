#pragma once
/// Pieces of a mirror that do not cross its line: a thumb laid on itself, a patch that is its own mirror image.

#include <vector>

#include <quadmatch/mesh/components.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::use {

/// Tell for each region whether it lays one side of the mirror on the same side, rather than on the other. The line is
/// that of the largest region of each component, if it divides that region into two sides.
/// @param regions  reversing, from the largest, each with its partners in regions too
/// @par Cost       O(#faces).
[[nodiscard]] std::vector<bool> one_sided(const Mesh& mesh, const Components& components,
                                          const std::vector<Region>& regions);

}  // namespace quadmatch::use
