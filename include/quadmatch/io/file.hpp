#pragma once
/// Whole files in and out: one read, and writing aside with a rename at the end.

#include <string>
#include <string_view>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch {

/// All bytes of a file; `-` reads standard input to its end.
/// @par Errors  CannotRead, with the system's reason.
[[nodiscard]] Expected<std::string> read_file(const std::string& path);

/// Replace a file by these bytes, or leave it exactly as it was; `-` writes standard output.
/// The bytes go to a temporary file in the same folder, which is renamed when all of them are on disk.
/// @par Errors  CannotWrite, with the system's reason.
[[nodiscard]] Expected<void> replace_file(const std::string& path, std::string_view bytes);

}  // namespace quadmatch
