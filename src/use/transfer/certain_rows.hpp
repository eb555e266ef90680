#pragma once
/// Rows of quads that could not be the ones that were taken out.

#include <cstdint>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {

/// Where a row of quads was taken out, its neighbour might as well be the one that is gone: the mesh that is left is
/// the same, if the two run side by side from end to end. But edits take out whole rows (poly-chords). So where all of
/// one is gone, and the next one runs on without it, or ends before, that one cannot be meant.
/// @param match            from this source
/// @param[in,out] certain  by faces of the source; those of which this is known are marked
/// @par Cost  O(#sides of matched faces beyond which unmatched ones lie, times the length of rows).
void mark_certain_rows(const Mesh& source, const Match& match, PerFace<std::uint8_t>& certain);

}  // namespace quadmatch::use
