#pragma once
/// Colours by refinement (§4.1, Algorithm 1): the Weisfeiler-Leman procedure that respects the rotation system.

#include <cstdint>
#include <vector>

#include <quadmatch/analysis/skeleton.hpp>

namespace quadmatch {

/// A hash of all that a node sees within as many arcs as rounds were made. The same for the same neighbourhood in any
/// mesh, whatever its numbering; 64 bits, so that two different ones agree by chance once in 10^19.
using Colour = std::uint64_t;

struct ColouringOptions {
  /// Also tell arcs of unequal length apart (§4.1, footnote 1).
  bool arc_lengths = false;
};

/// Round 0: the colour of a node is its code: valence, boundary, and whether all its faces are quads.
[[nodiscard]] std::vector<Colour> initial_colours(const ArcGraph& graph, const PerFan<VertexCode>& codes);

/// One round of Algorithm 1: the colour of each node, followed by those of its neighbours in counter-clockwise order,
/// beginning where the string is lexicographically least; linear, from its first edge, at a boundary node.
///
/// @param colours  one per node, of the round before.
/// @par Cost       O(#spokes): the least rotation takes linear time.
/// @par Reading    Algorithm 1 lists neighbours only; we keep the node's own colour in front, as in the
///                 Weisfeiler-Leman procedure it is taken from, so that a round never forgets what an earlier one knew.
[[nodiscard]] std::vector<Colour> refine_colours(const ArcGraph& graph, const PerFan<VertexCode>& codes,
                                                 const std::vector<Colour>& colours,
                                                 const ColouringOptions& options = {});

/// The spokes of a node at which its least string of neighbour colours may begin: one, or several where the
/// neighbourhood is rotationally symmetric. Counted from the node's first spoke.
[[nodiscard]] std::vector<std::uint32_t> least_rotations(const ArcGraph& graph, const PerFan<VertexCode>& codes,
                                                         const std::vector<Colour>& colours, std::uint32_t node,
                                                         const ColouringOptions& options = {});

}  // namespace quadmatch
