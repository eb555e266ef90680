#pragma once
/// Reading meshes: OBJ, PLY (ascii, binary of both byte orders), OFF, USD text.

#include <optional>
#include <string>
#include <string_view>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>

namespace quadmatch {

/// Read a mesh file; `-` reads standard input.
///
/// @param path    the format is told by the ending, else by the first bytes.
/// @par Errors    CannotRead, UnknownFormat, and whatever `parse_mesh` finds; each with path and line.
/// @par Cost      one pass over the bytes, about three times the file's size in memory.
[[nodiscard]] Expected<MeshFile> read_mesh(const std::string& path);

/// Read a mesh from memory.
///
/// @param name    what errors call it, e.g. the path.
/// @param format  told by the first bytes when absent.
[[nodiscard]] Expected<MeshFile> parse_mesh(std::string_view bytes, const std::string& name,
                                            std::optional<Format> format = std::nullopt);
/// The same of bytes that are there as a reader wants them: without a copy.
[[nodiscard]] Expected<MeshFile> parse_mesh(const FileBytes& bytes, const std::string& name,
                                            std::optional<Format> format = std::nullopt);

/// The format that an ending (".obj") stands for.
[[nodiscard]] std::optional<Format> format_of_path(std::string_view path);

}  // namespace quadmatch
