#pragma once
/// Which vertices are elsewhere, and whether all of them moved as one body.

#include <optional>
#include <vector>

#include <quadmatch/use/diff.hpp>

namespace quadmatch::use {

struct Motion {
  std::vector<VertexPair> moved;
  std::optional<WholeMotion> whole;
};

/// @param pairs      vertices that are the same.
/// @param tolerance  in shares of the diagonal of the source's bounding box.
/// @return           nothing where one mesh has no positions.
[[nodiscard]] Motion find_motion(const Mesh& source, const Mesh& target, const std::vector<VertexPair>& pairs,
                                 double tolerance);

}  // namespace quadmatch::use
