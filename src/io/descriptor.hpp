#pragma once
/// An open file, and reading from it with the system's reasons in words.

#include <cstddef>
#include <string>
#include <utility>

#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::io {

/// A file descriptor that closes itself, save standard input and output.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();

  [[nodiscard]] bool valid() const { return number_ >= 0; }
  [[nodiscard]] int number() const { return number_; }
  /// Close now, to learn whether it succeeded.
  [[nodiscard]] bool close();

 private:
  int number_ = -1;
};

/// A file open for reading, with its size; 0 where it has none, as a pipe.
struct OpenFile {
  Descriptor descriptor;
  std::size_t size = 0;
};

/// Open a file, or standard input for `-`.
/// @par Errors  CannotRead: missing, not permitted, a folder.
[[nodiscard]] Expected<OpenFile> open_for_reading(const std::string& path);

/// Read up to `size` bytes. @return how many; 0 at the end of the file.
/// @par Errors  CannotRead, with `path`.
[[nodiscard]] Expected<std::size_t> read_some(const Descriptor& file, char* into, std::size_t size,
                                              const std::string& path);

/// CannotRead for this path, said as `why`.
[[nodiscard]] Unexpected<Error> cannot_read(const std::string& path, const std::string& why);

/// What the system says of an error number.
[[nodiscard]] std::string system_reason(int number);

/// The system may refuse single calls above 2 GB.
inline constexpr std::size_t kMostPerCall = std::size_t{1} << 30;

}  // namespace quadmatch::io
