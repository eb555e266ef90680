#pragma once
/// Reading the meshes a verb is given, and keeping the output away from them.

#include <optional>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>

namespace quadmatch::cli {

/// Read a mesh; an error is complained about. @param remarks  also warn of what the reader had to guess.
[[nodiscard]] std::optional<MeshFile> read_input(const std::string& path, bool remarks);

/// May these be read and that be written in one run? Complains where standard input would be read twice, or where the
/// output (empty: none) is one of the inputs.
[[nodiscard]] bool paths_fit(const std::vector<std::string>& inputs, const std::string& output);

/// "a.obj", or "standard input" for `-`.
[[nodiscard]] std::string display_name(const std::string& path);

}  // namespace quadmatch::cli
