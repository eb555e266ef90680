#pragma once
/// Rows of quads that came between others: inserted edge loops.

#include <cstdint>
#include <vector>

#include "scene.hpp"

namespace quadmatch::use {

/// How many rows of quads make up what came, 0 where it is anything else.
///
/// An edge loop splits every quad of a poly-chord in two. The match lays the old row on either half, or on one here and
/// on the other there, or on none. So what came makes whole chords, each quad of which is unmatched or beside an
/// unmatched one, and what is on both sides of them was joined before. The wall of an extrusion is such a row as well,
/// and told by the corners it turns.
/// @par Cost  O(lengths of the chords through what came).
[[nodiscard]] std::uint32_t count_inserted_rows(const Scene& scene);

/// Did the quads at a boundary come from splitting a row there, rather than from the outside? Connectivity is the same.
/// But after a split the old boundary is where it was, at the far end of the new quads, and what lies on it in the
/// match is farther in. False without positions, and where the model is posed.
[[nodiscard]] bool is_split_at_boundary(const Scene& scene);

}  // namespace quadmatch::use
