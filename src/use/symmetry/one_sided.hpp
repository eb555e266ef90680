#pragma once
/// Pieces of a mirror that do not cross its line: a thumb laid on itself, a patch that is its own mirror image.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/components.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::use {

/// On which side of the mirror's line each face lies: 1 or -1; 0 on the line, and where there are no two sides. The
/// line is that of the largest region of each component, if it divides that region in two; faces of no such region are
/// on the side from which they are reached first.
/// @param regions  reversing, from the largest, each with its partners in regions too
/// @par Cost       O(#faces).
[[nodiscard]] PerFace<std::int8_t> sides_of(const Mesh& mesh, const Components& components,
                                            const std::vector<Region>& regions);

/// Tell for each region whether it lays one side on the same side, rather than on the other.
/// @par Cost  O(#faces).
[[nodiscard]] std::vector<bool> one_sided(const PerFace<std::int8_t>& sides, const std::vector<Region>& regions);

}  // namespace quadmatch::use
