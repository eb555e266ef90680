#pragma once
/// The mesh files of a folder and the folders in it.

#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::cli {

struct FoundFile {
  std::string path;           ///< as seen from the folder, with slashes
  std::uint64_t size = 0;     ///< bytes
  std::int64_t modified = 0;  ///< when, in nanoseconds of the file system's clock
};

struct FoundFiles {
  std::vector<FoundFile> meshes;  ///< by their ending; ascending by path
  std::uint64_t others = 0;       ///< files that are no meshes, by their ending
  std::uint64_t closed = 0;       ///< folders and files that may not be looked at
};

/// Walk a folder. Symbolic links to files are followed, those to folders are not, so that a walk ends; pipes, sockets
/// and devices are no files.
/// @par Errors  CannotRead: there is no such folder, or it may not be looked at.
[[nodiscard]] Expected<FoundFiles> find_mesh_files(const std::string& folder);

}  // namespace quadmatch::cli
