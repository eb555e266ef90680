#include "memory_need.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include <quadmatch/io/read_mesh.hpp>

namespace quadmatch::cli {
namespace {

/// What matching an edited pair takes for each corner of both meshes, by bench/run.py --only batch, and some more.
constexpr std::uint64_t kBytesOfCorner = 128;
/// What a pair takes however small it is.
constexpr std::uint64_t kBytesOfPair = 2 << 20;

constexpr std::size_t kChunk = 1 << 16;

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_end(char c) { return c == '\n' || c == '\r'; }

/// Counts the words of lines, or of those that begin with `f`, over chunks.
class WordCounter {
 public:
  explicit WordCounter(bool face_lines_only) : all_(!face_lines_only) {}

  void take(std::string_view chunk) {
    for (const char c : chunk) {
      if (is_end(c)) {
        at_start_ = true;
        in_word_ = false;
      } else if (is_blank(c)) {
        in_word_ = false;
      } else if (!in_word_) {
        in_word_ = true;
        if (at_start_) counted_line_ = all_ || c == 'f';
        words_ += counted_line_ && (all_ || !at_start_);
        at_start_ = false;
      }
    }
  }
  [[nodiscard]] std::uint64_t words() const { return words_; }

 private:
  bool all_;
  bool at_start_ = true, in_word_ = false, counted_line_ = false;
  std::uint64_t words_ = 0;
};

/// The number after "element face" in the header of a PLY file.
std::optional<std::uint64_t> faces_of_ply(std::string_view header) {
  constexpr std::string_view kElement = "element face ";
  const std::size_t at = header.find(kElement);
  if (at == std::string_view::npos) return std::nullopt;
  std::uint64_t faces = 0;
  const char* const begin = header.data() + at + kElement.size();
  if (std::from_chars(begin, header.data() + header.size(), faces).ec != std::errc()) return std::nullopt;
  return faces;
}

/// Reads a file chunk by chunk; `take` returns false where it has seen enough.
template <class Take>
bool each_chunk(std::ifstream& file, Take take) {
  std::array<char, kChunk> chunk = {};
  while (file) {
    file.read(chunk.data(), chunk.size());
    const std::string_view bytes(chunk.data(), static_cast<std::size_t>(file.gcount()));
    if (!bytes.empty() && !take(bytes)) return true;
  }
  return file.eof();
}

/// Corners of a file of this format; nothing where it cannot be read.
std::optional<std::uint64_t> count_corners(std::ifstream& file, std::optional<Format> format, std::uint64_t bytes) {
  if (format == Format::Ply) {
    std::optional<std::uint64_t> faces;
    const bool read = each_chunk(file, [&faces](std::string_view header) {
      faces = faces_of_ply(header);
      return false;
    });
    // A header may promise more than there is; a corner takes a byte at least.
    if (read) return std::min(faces.value_or(bytes) * 4, bytes);
    return std::nullopt;
  }
  if (format == Format::Usda) {
    // Of the commas of a quad one belongs to its count, four to its corners and three to its point.
    std::uint64_t commas = 0;
    const auto count = [&commas](std::string_view chunk) {
      commas += static_cast<std::uint64_t>(std::count(chunk.begin(), chunk.end(), ','));
      return true;
    };
    if (each_chunk(file, count)) return commas / 2;
    return std::nullopt;
  }
  WordCounter counter(format != Format::Off);
  const auto count = [&counter](std::string_view chunk) {
    counter.take(chunk);
    return true;
  };
  if (!each_chunk(file, count)) return std::nullopt;
  // In OFF a quad has four corners and a count, and a vertex of its own three numbers.
  return format == Format::Off ? counter.words() / 2 : counter.words();
}

}  // namespace

Expected<MeshSize> measure_mesh_file(const std::string& path) {
  std::error_code failed;
  const std::uintmax_t bytes = std::filesystem::file_size(path, failed);
  const auto refuse = [&path](std::string message) {
    return Unexpected(Error{ErrorCode::CannotRead, std::move(message), path});
  };
  if (failed == std::errc::no_such_file_or_directory || failed == std::errc::not_a_directory) {
    return refuse("there is no such file; check the name and the folder");
  }
  if (failed) return refuse(fmt::format("cannot be read: {}; name a mesh file", failed.message()));
  std::ifstream file(path, std::ios::binary);
  const std::optional<std::uint64_t> corners = file ? count_corners(file, format_of_path(path), bytes) : std::nullopt;
  if (!corners) return refuse("cannot be read; check its permissions");
  return MeshSize{bytes, *corners};
}

std::uint64_t needed_memory(const MeshSize& source, const MeshSize& target) {
  return kBytesOfPair + source.bytes + target.bytes + (source.corners + target.corners) * kBytesOfCorner;
}

}  // namespace quadmatch::cli
