#pragma once
/// A dirty mesh is worth a warning, never a refusal.

#include <string>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::cli {

/// One sentence that counts what is dirty in a mesh, e.g. "66 non-manifold edges, 12 unused vertices; matching goes on,
/// faces are not adjacent across such edges"; empty for a clean one. Triangles and larger faces are no dirt.
///
/// @param work  what goes on all the same: "matching".
/// @par Cost    O(#V) for a clean mesh, that of `check` for one with seams.
[[nodiscard]] std::string describe_dirt(const Mesh& mesh, const std::string& work);

}  // namespace quadmatch::cli
