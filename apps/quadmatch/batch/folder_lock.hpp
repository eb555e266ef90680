#pragma once
/// One run at a time writes into a results folder.

#include <string>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::cli {

/// Holds a folder until it is destroyed or the process ends, however it ends.
class FolderLock {
 public:
  /// @par Errors  CannotWrite: another process holds it (which one is said), or its file `lock` cannot be made.
  [[nodiscard]] static Expected<FolderLock> take(const std::string& folder);

  FolderLock(FolderLock&& other) noexcept : file_(other.file_) { other.file_ = -1; }
  FolderLock& operator=(FolderLock&& other) = delete;
  ~FolderLock();

 private:
  explicit FolderLock(int file) : file_(file) {}
  int file_;
};

}  // namespace quadmatch::cli
