// Large files pass through a small buffer: where it is cut must not matter.

#include <filesystem>
#include <fstream>
#include <random>

#include <unistd.h>

#include "io_support.hpp"
#include "line_chunks.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

/// A file that is removed afterwards.
class TemporaryText {
 public:
  explicit TemporaryText(const std::string& text)
      : path_((std::filesystem::temp_directory_path() / ("quadmatch-text-" + std::to_string(::getpid()) + ".obj"))
                  .string()) {
    std::ofstream(path_, std::ios::binary) << text;
  }
  TemporaryText(const TemporaryText&) = delete;
  TemporaryText& operator=(const TemporaryText&) = delete;
  ~TemporaryText() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// The pieces of a text, which must hold whole lines.
std::vector<std::string> pieces_of(const std::string& text) {
  const TemporaryText file(text);
  Expected<io::LineChunks> chunks = io::LineChunks::open(file.path());
  REQUIRE(chunks.has_value());
  CHECK(chunks->size() == text.size());
  std::vector<std::string> pieces;
  for (std::string joined;;) {
    const Expected<std::string_view> piece = chunks->next();
    REQUIRE(piece.has_value());
    if (piece->empty()) {
      CHECK(joined == text);
      return pieces;
    }
    pieces.emplace_back(*piece);
    joined += *piece;
  }
}

bool ends_in_open_line(const std::string& piece) {
  if (piece.back() != '\n') return true;
  const std::size_t last = piece.find_last_not_of("\r", piece.size() - 2);
  return last != piece.npos && piece[last] == '\\';
}

/// A grid of quads, with what a careless exporter may put between: `separator` divides the numbers.
std::string grid_obj(std::uint32_t size, const std::string& separator, const std::string& line_end) {
  std::string text;
  const auto line = [&](char keyword, const std::vector<std::string>& words) {
    text += keyword;
    for (const std::string& word : words) text += separator + word;
    text += line_end;
  };
  for (std::uint32_t i = 0; i <= size; ++i) {
    for (std::uint32_t j = 0; j <= size; ++j) line('v', {std::to_string(i), std::to_string(j), "-0.125"});
  }
  for (std::uint32_t i = 0; i < size; ++i) {
    for (std::uint32_t j = 0; j < size; ++j) {
      const std::uint32_t first = i * (size + 1) + j + 1;
      line('f', {std::to_string(first), std::to_string(first + 1), std::to_string(first + size + 2),
                 std::to_string(first + size + 1)});
    }
  }
  return text;
}

}  // namespace

TEST_CASE("the pieces of a file end where lines do, and are the file when joined (seed 21)") {
  std::mt19937 random(21);
  for (const std::string line_end : {"\n", "\r\n", "\\\n"}) {
    std::string text;
    while (text.size() < 1'500'000) text += std::string(random() % 90, 'x') + (random() % 8 == 0 ? line_end : "\n");
    const std::vector<std::string> pieces = pieces_of(text);
    CHECK(pieces.size() > 4);
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i) CHECK_FALSE(ends_in_open_line(pieces[i]));
  }
}

TEST_CASE("a line longer than the buffer is one piece, and so is a file of old line ends") {
  CHECK(pieces_of("a\n" + std::string(1'000'000, 'x') + "\nb\n").size() <= 3);
  std::string old_style;
  for (int i = 0; i < 100'000; ++i) old_style += "v 1 2 3\r";
  CHECK(pieces_of(old_style).size() == 1);
  CHECK(pieces_of("").empty());
}

TEST_CASE("a large OBJ reads the same from disk and memory, whatever divides its words and lines") {
  const MeshFile expected = parsed(grid_obj(120, " ", "\n"), Format::Obj);
  CHECK(expected.mesh.face_count() == 14'400);
  for (const std::string separator : {" ", "  ", "\t", " \\\n"}) {
    for (const std::string line_end : {"\n", "\r\n", "\r", " # hm\n"}) {
      CAPTURE(separator);
      CAPTURE(line_end);
      const std::string text = grid_obj(120, separator, line_end);
      CHECK(text.size() > 300'000);
      check_same_mesh(expected.mesh, parsed(text, Format::Obj).mesh);
      const TemporaryText file(text);
      const Expected<MeshFile> read = read_mesh(file.path());
      REQUIRE(read.has_value());
      check_same_mesh(expected.mesh, read->mesh);
    }
  }
}

TEST_CASE("an error far down a large file is named with its line") {
  for (const std::string separator : {" ", "\t"}) {
    const TemporaryText file(grid_obj(120, separator, "\n") + "f 1 2\n");
    const Expected<MeshFile> read = read_mesh(file.path());
    REQUIRE_FALSE(read.has_value());
    CHECK(read.error().line == 121 * 121 + 120 * 120 + 1);
    CHECK(read.error().code == ErrorCode::TooFewCorners);
  }
}
