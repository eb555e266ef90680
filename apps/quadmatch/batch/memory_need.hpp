#pragma once
/// How much memory a pair will need, told before it is read.

#include <cstdint>
#include <string>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::cli {

/// How large a mesh file is, as far as a look at its bytes tells.
struct MeshSize {
  std::uint64_t bytes = 0;
  std::uint64_t corners = 0;  ///< of all faces
};

/// Count the corners of a mesh file: in OBJ words of face lines, in PLY what the header says, in OFF words of all lines
/// but a few, in USD commas. A guess from above where the file is none of these.
///
/// @par Errors  CannotRead.
/// @par Cost    one pass over the bytes, 64 kB in memory; PLY: its header only.
[[nodiscard]] Expected<MeshSize> measure_mesh_file(const std::string& path);

/// Bytes that matching two meshes takes at most, with what is read and written: from above on all that `bench/run.py
/// --only batch` measures, several times too much for meshes that are the same.
[[nodiscard]] std::uint64_t needed_memory(const MeshSize& source, const MeshSize& target);

}  // namespace quadmatch::cli
