#pragma once
/// What a modeller would call an area of change.

#include <cstdint>

#include <quadmatch/use/diff.hpp>

#include "scene.hpp"

namespace quadmatch::use {

struct Name {
  ChangeKind kind = ChangeKind::Reconnection;
  std::uint32_t rows = 0;  ///< of an inserted or removed loop
};

/// @par Cost  O(size of the area, and of the chords through it).
[[nodiscard]] Name name_of(const Scene& scene);

}  // namespace quadmatch::use
