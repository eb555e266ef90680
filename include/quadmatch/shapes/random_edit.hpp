#pragma once
/// Edits at random places, as a test of a matcher wants them: named, sized, and the same on every machine.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/random.hpp>

namespace quadmatch::shapes {

/// One word of a recipe: `loop`, `delete:20`.
struct RandomEdit {
  std::string name;
  std::uint32_t size = 0;  ///< what it counts, `random_edit_kinds` says
};

struct RandomEditKind {
  const char* name;
  std::uint32_t size;       ///< unless another is given
  const char* description;  ///< what it does, with N for the size
};

/// All there are: delete, extrude, collapse, rip, refine, loop, unloop, twist, handle; subdivide, after which no face
/// survives; renumber.
[[nodiscard]] std::vector<RandomEditKind> random_edit_kinds();

/// @par Errors  BadArgument where there is no such edit, or the size is no number from 1 on.
[[nodiscard]] Expected<RandomEdit> parse_random_edit(std::string_view text);

/// Make an edit at a random place. Places are tried until one fits.
/// @par Errors  as of the edit; its last refusal where none of the places tried fits.
/// @par Cost    of the edit, times the places tried, 400 at most for each of its steps.
[[nodiscard]] Expected<Edit> edit_at_random(const PolygonSoup& soup, const RandomEdit& edit, Random& random);

}  // namespace quadmatch::shapes
