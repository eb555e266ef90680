// Which format it is, and the reader for it.

#include <quadmatch/io/read_mesh.hpp>

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "formats.hpp"
#include "line_scanner.hpp"

namespace quadmatch {
namespace {

constexpr const char* kKnownFormats = "give it one of the endings .obj, .ply, .off, .usda";

/// Is this the keyword an OFF file begins with: OFF, after the letters that say what its vertices carry?
bool is_off_keyword(std::string_view word) { return word.size() >= 3 && word.substr(word.size() - 3) == "OFF"; }

/// The format that the first word of a file which is no comment stands for.
std::optional<Format> format_of_bytes(const FileBytes& bytes) {
  const std::string_view text = bytes.view();
  if (text.substr(0, 5) == "#usda" || text.substr(0, 8) == "PXR-USDC") return Format::Usda;
  io::LineScanner scanner(bytes, io::LineScanner::Continuation::No);
  while (!scanner.at_end() && scanner.data_ends()) scanner.next_line();
  const std::string_view word = scanner.at_end() ? std::string_view() : scanner.take_token();
  if (word == "ply") return Format::Ply;
  if (is_off_keyword(word)) return Format::Off;
  constexpr std::string_view kObjKeywords[] = {"v", "vt", "vn", "vp", "f", "o", "g", "s", "usemtl", "mtllib", "l", "p"};
  if (std::find(std::begin(kObjKeywords), std::end(kObjKeywords), word) != std::end(kObjKeywords)) return Format::Obj;
  return std::nullopt;
}

Expected<MeshFile> read_bytes(const FileBytes& bytes, const std::string& name, std::optional<Format> format) {
  if (bytes.size() == 0) return io::empty_file(name);
  if (!format) format = format_of_bytes(bytes);
  if (!format) {
    return Unexpected(Error{ErrorCode::UnknownFormat,
                            fmt::format("neither the name nor the first word tells the format; {}", kKnownFormats),
                            name});
  }
  switch (*format) {
    case Format::Obj:
      return io::read_obj(io::LineChunks(bytes), name);
    case Format::Ply:
      return io::read_ply(bytes, name);
    case Format::Off:
      return io::read_off(bytes, name);
    case Format::Usda:
      break;
  }
  return io::read_usda(bytes, name);
}

}  // namespace

std::optional<Format> format_of_path(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return std::nullopt;
  std::string ending(path.substr(dot + 1));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (ending == "obj") return Format::Obj;
  if (ending == "ply") return Format::Ply;
  if (ending == "off") return Format::Off;
  if (ending == "usda" || ending == "usd" || ending == "usdc") return Format::Usda;
  return std::nullopt;
}

Expected<MeshFile> read_mesh(const std::string& path) {
  if (format_of_path(path) == Format::Obj) {
    Expected<io::LineChunks> text = io::LineChunks::open(path);
    if (!text) return Unexpected(std::move(text).error());
    return io::read_obj(std::move(*text), path);
  }
  const Expected<FileBytes> bytes = read_file(path);
  if (!bytes) return Unexpected(bytes.error());
  const bool standard = path == "-";
  Expected<MeshFile> file = read_bytes(*bytes, standard ? "standard input" : path, format_of_path(path));
  if (file && standard) file->path = path;
  return file;
}

Expected<MeshFile> parse_mesh(std::string_view bytes, const std::string& name, std::optional<Format> format) {
  return read_bytes(FileBytes(bytes), name, format);
}

Expected<MeshFile> parse_mesh(const FileBytes& bytes, const std::string& name, std::optional<Format> format) {
  return read_bytes(bytes, name, format);
}

namespace io {

Unexpected<Error> empty_file(const std::string& name) {
  return Unexpected(Error{ErrorCode::Empty, "the file is empty; export the mesh again", name});
}

Expected<Mesh> build_mesh(PolygonSoup soup, const std::string& name) {
  if (soup.corners.empty()) {
    return Unexpected(Error{ErrorCode::Empty, "the file has no faces; export the mesh with its faces", name});
  }
  Expected<Mesh> mesh = Mesh::build(std::move(soup));
  if (!mesh) mesh.error().path = name;
  return mesh;
}

}  // namespace io
}  // namespace quadmatch
