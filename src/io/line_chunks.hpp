#pragma once
/// A file in pieces that end where a line does, so that a large text passes through a buffer small enough to stay in
/// the processor's cache.

#include <cstddef>
#include <string>
#include <string_view>

#include <quadmatch/io/file.hpp>
#include <quadmatch/mesh/expected.hpp>

#include "descriptor.hpp"

namespace quadmatch::io {

class LineChunks {
 public:
  /// The text of a file, which is opened.
  /// @par Errors  CannotRead.
  [[nodiscard]] static Expected<LineChunks> open(const std::string& path);
  /// A text in memory, in one piece. It must outlive this object.
  explicit LineChunks(const FileBytes& bytes) : memory_(&bytes), size_(bytes.size()) {}

  /// The next piece, empty at the end of the text; valid until the next call. It ends with a line feed that no
  /// backslash precedes, or with the text, and at least eight bytes behind it may be read.
  /// @par Errors  CannotRead.
  [[nodiscard]] Expected<std::string_view> next();

  /// Bytes in all, 0 if that is not known.
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Some bytes at an offset, to estimate what is in a text; fewer than asked for at its end, or if it cannot be read
  /// out of order.
  [[nodiscard]] std::string sample(std::size_t offset, std::size_t count) const;

 private:
  LineChunks() = default;
  /// Read until the buffer is full or the file ends.
  [[nodiscard]] Expected<void> fill();
  /// One past the last line in the buffer that is complete and not continued; 0 if there is none.
  [[nodiscard]] std::size_t end_of_lines() const;

  const FileBytes* memory_ = nullptr;
  std::string path_;
  Descriptor file_;
  std::size_t size_ = 0;
  FileBytes buffer_;
  std::size_t given_ = 0;   // bytes of the buffer in the latest piece
  std::size_t filled_ = 0;  // bytes of the buffer that hold text
  bool ended_ = false;
};

}  // namespace quadmatch::io
