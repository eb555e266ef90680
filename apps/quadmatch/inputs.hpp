#pragma once
/// Reading the meshes a verb is given, and keeping the output away from them.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>

#include "text.hpp"

namespace quadmatch::cli {

/// Read a mesh; an error is complained about. @param remarks  also warn of what the reader had to guess.
[[nodiscard]] std::optional<MeshFile> read_input(const std::string& path, bool remarks);

/// Both meshes of a pair.
struct InputPair {
  MeshFile source, target;
};

/// Read two meshes, at the same time if there may be two threads. Complains as if one had been read after the other.
/// @param threads  0: as many as there are processors.
[[nodiscard]] std::optional<InputPair> read_inputs(const std::string& source, const std::string& target, bool remarks,
                                                   std::uint32_t threads);

/// May these be read and that be written in one run? Complains where standard input would be read twice, or where the
/// output (empty: none) is one of the inputs. @param option  what names the output.
[[nodiscard]] bool paths_fit(const std::vector<std::string>& inputs, const std::string& output,
                             const char* option = "-o");

/// Do two names lead to one file, whether it is there yet or not?
[[nodiscard]] bool same_file(const std::string& a, const std::string& b);

}  // namespace quadmatch::cli
