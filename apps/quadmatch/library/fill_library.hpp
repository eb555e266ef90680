#pragma once
/// Bringing a library up to date with its folder.

#include <cstdint>

#include <quadmatch/mesh/expected.hpp>

#include "library_store.hpp"
#include "mesh_files.hpp"

namespace quadmatch::cli {

struct FillOptions {
  std::uint32_t threads = 1;
  bool anew = false;   ///< read unchanged files too
  bool quiet = false;  ///< no progress
};

struct FillCounts {
  std::uint64_t added = 0, changed = 0, unchanged = 0, removed = 0;
  /// Of the files added and changed, how many cannot be read; and the first of them by path.
  std::uint64_t broken = 0;
  std::string first_broken = {};
};

/// Read what is new or has another size or time than before, and forget what is gone. Can be killed at any moment and
/// called again: what was kept is not read again. The library is the same for any number of threads.
///
/// @par Errors  of the store. Meshes that cannot be read are no error: the library keeps why.
[[nodiscard]] Expected<FillCounts> fill_library(LibraryStore& store, const FoundFiles& files,
                                                const FillOptions& options);

}  // namespace quadmatch::cli
