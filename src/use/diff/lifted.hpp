#pragma once
/// Patches that were lifted from their neighbours, with a wall of quads between.

#include <cstddef>

#include "scene.hpp"

namespace quadmatch::use {

/// Of the sides between which faces came: how many meet, straight through the new quads, the side that they were
/// joined to before. Around a patch that is matched the whole wall is made of such quads.
[[nodiscard]] std::size_t count_walled(const Scene& scene);

/// Is what came what was there before, one or more rings of quads farther in? So it is with a patch that is too small,
/// or too regular, for a match to find again behind its walls.
[[nodiscard]] bool is_lifted_patch(const Scene& scene);

}  // namespace quadmatch::use
