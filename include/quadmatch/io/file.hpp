#pragma once
/// Whole files in and out: one read, and writing aside with a rename at the end.

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch {

/// The bytes of a file. Behind the last of them stand kPadding line feeds that do not belong to it, so that a scanner
/// may look ahead without asking for the end at every step. Memory is not cleared before it is read into.
class FileBytes {
 public:
  static constexpr std::size_t kPadding = 32;

  FileBytes() = default;
  /// A copy of bytes in memory.
  explicit FileBytes(std::string_view bytes);

  [[nodiscard]] const char* begin() const { return data_.get(); }
  [[nodiscard]] const char* end() const { return data_.get() + size_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::string_view view() const { return {data_.get(), size_}; }

  [[nodiscard]] char* data() { return data_.get(); }
  /// Keep the first `size` bytes, or make room for more, whose content is undefined. False if memory ran out.
  [[nodiscard]] bool resize(std::size_t size);

 private:
  struct Free {
    void operator()(char* bytes) const { std::free(bytes); }
  };
  std::unique_ptr<char, Free> data_;
  std::size_t size_ = 0;
};

/// All bytes of a file; `-` reads standard input to its end.
/// @par Errors  CannotRead, with the system's reason.
[[nodiscard]] Expected<FileBytes> read_file(const std::string& path);

/// Replace a file by these bytes, or leave it exactly as it was; `-` writes standard output.
///
/// The bytes go to a temporary file in the same folder, which is renamed when all of them are on disk; its mode is
/// that of the file it replaces. A symbolic link stays, and what it leads to is replaced. Devices and pipes, which
/// cannot be replaced, are written to.
///
/// @par Errors  CannotWrite, with the system's reason; a write-protected file is refused.
[[nodiscard]] Expected<void> replace_file(const std::string& path, std::string_view bytes);

}  // namespace quadmatch
