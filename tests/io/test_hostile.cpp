// Every prefix of a file, and thousands of damaged ones: each is read, or refused in one line.

#include <random>

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

struct Sample {
  const char* name;
  Format format;
  std::string bytes;
};

std::vector<Sample> samples() {
  const MeshFile full = parsed(kFullObj, Format::Obj);
  const MeshFile ply = parsed(kPly, Format::Ply);
  return {{"OBJ", Format::Obj, std::string(kFullObj)},
          {"PLY ascii", Format::Ply, std::string(kPly)},
          {"PLY little-endian", Format::Ply, format_mesh(ply, Format::Ply, {.ply = PlyEncoding::LittleEndian})},
          {"PLY big-endian", Format::Ply, format_mesh(ply, Format::Ply, {.ply = PlyEncoding::BigEndian})},
          {"OFF", Format::Off,
           "STCNOFF\n3 1 3\n0 0 0 0 0 1 1 .5 0 1 0 0\n1 0 0 0 0 1 0 0 0 1 1 0\n"
           "1 1 0 0 0 1 0 0 0.25 1 1 1\n3 0 1 2 1 0 0\n# end\n"},
          {"USD", Format::Usda, std::string(kUsda)},
          {"USD written", Format::Usda, format_mesh(full, Format::Usda)}};
}

void check_error(const Error& error) {
  CHECK_FALSE(error.message.empty());
  for (const char c : error.describe()) {
    if (c < ' ' || c > '~') FAIL_CHECK("a message holds a byte that is not printable: " << error.message);
  }
}

/// Read bytes; what is read must be written and read again as the same mesh.
void feed(const std::string& bytes, Format format) {
  const Expected<MeshFile> file = parse_mesh(bytes, "mesh", format);
  if (!file) return check_error(file.error());
  const Expected<MeshFile> again = parse_mesh(format_mesh(*file, format), "again", format);
  if (!again) {
    FAIL_CHECK("what was written cannot be read: " << again.error().describe());
    return;
  }
  CHECK(again->mesh.vertex_count() == file->mesh.vertex_count());
  CHECK(std::equal(file->mesh.corners().begin(), file->mesh.corners().end(), again->mesh.corners().begin(),
                   again->mesh.corners().end()));
}

void feed_match(const std::string& bytes) {
  const Expected<MatchFile> file = parse_match(bytes, "match");
  if (!file) return check_error(file.error());
  const std::string written = format_match(*file);
  const Expected<MatchFile> again = parse_match(written, "again");
  REQUIRE(again.has_value());
  CHECK(format_match(*again) == written);
}

/// A few bytes changed, removed, doubled or replaced by what such files are made of.
std::string damaged(std::string bytes, std::mt19937& random) {
  constexpr std::string_view kPieces[] = {"-", "0",   "9999999999", "/",  "\\\n",       "\n", "\r",
                                          " ", "nan", "1e999",      "#",  "[",          "]",  "(",
                                          ")", "{",   "}",          "\"", "4294967295", "v",  "f"};
  for (std::size_t count = 1 + random() % 4; count > 0; --count) {
    const std::size_t at = random() % (bytes.size() + 1);
    const std::size_t length = random() % 8;
    switch (random() % 5) {
      case 0:
        if (at < bytes.size()) bytes[at] = static_cast<char>(random());
        break;
      case 1:
        bytes.erase(at, length);
        break;
      case 2:
        bytes.insert(at, bytes.substr(at, length));
        break;
      case 3:
        bytes.insert(at, kPieces[random() % std::size(kPieces)]);
        break;
      default:
        bytes.replace(at, std::min<std::size_t>(length, bytes.size() - at), kPieces[random() % std::size(kPieces)]);
    }
  }
  return bytes;
}

}  // namespace

TEST_CASE("every prefix of a mesh file is read or refused in one line") {
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    for (std::size_t size = 0; size <= sample.bytes.size(); ++size) {
      CAPTURE(size);
      feed(sample.bytes.substr(0, size), sample.format);
    }
  }
}

TEST_CASE("damaged mesh files are read or refused in one line (seed 11)") {
  std::mt19937 random(11);
  for (const Sample& sample : samples()) {
    CAPTURE(sample.name);
    for (int i = 0; i < 2000; ++i) {
      CAPTURE(i);
      feed(damaged(sample.bytes, random), sample.format);
    }
  }
}

TEST_CASE("every prefix of a match file, and damaged ones, are read or refused in one line (seed 12)") {
  const std::string text(kMatch);
  for (std::size_t size = 0; size <= text.size(); ++size) feed_match(text.substr(0, size));
  std::mt19937 random(12);
  for (int i = 0; i < 5000; ++i) {
    CAPTURE(i);
    feed_match(damaged(text, random));
  }
}

TEST_CASE("random bytes are refused in one line by every reader (seed 13)") {
  std::mt19937 random(13);
  for (int i = 0; i < 500; ++i) {
    std::string bytes(random() % 200, '\0');
    for (char& c : bytes) c = static_cast<char>(random());
    for (const Format format : {Format::Obj, Format::Ply, Format::Off, Format::Usda}) feed(bytes, format);
    feed("ply\nformat binary_little_endian 1.0\nelement face 9\nproperty list int int vertex_indices\nend_header\n" +
             bytes,
         Format::Ply);
    feed("#usda 1.0\n" + bytes, Format::Usda);
    feed_match(bytes);
  }
}
