// OFF (Geomview): counts, then a vertex and a face on each line. The keyword's prefix says what vertices carry.

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "formats.hpp"
#include "line_scanner.hpp"

namespace quadmatch::io {
namespace {

/// Stands for a number that a vertex does not have while others do.
constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

class OffReader {
 public:
  OffReader(const FileBytes& bytes, const std::string& name)
      : scanner_(bytes, LineScanner::Continuation::No), name_(name) {}
  Expected<MeshFile> read();

 private:
  bool read_keyword();
  bool read_counts();
  bool read_vertex();
  bool read_colour(std::uint32_t vertex);
  bool read_face();
  bool skip_to_data(const char* what);
  bool take_coordinate(double& value);
  void end_line();
  void skip_empty_lines();
  MeshFile assemble(Mesh mesh);
  bool fail(ErrorCode code, std::string message) {
    error_ = {code, std::move(message), name_, scanner_.line()};
    return false;
  }
  bool fail_number(const char* kind) {
    return fail(ErrorCode::BadNumber, fmt::format("{} is not {}; {}", in_quotes(scanner_.peek_token()), kind, kMend));
  }

  LineScanner scanner_;
  const std::string& name_;
  Error error_;
  bool has_normals_ = false;
  bool has_texture_ = false;
  std::uint32_t vertex_count_ = 0;
  std::uint32_t face_count_ = 0;
  FaceGatherer faces_;
  /// x, y, z of normals; red, green, blue, alpha; s, t: one number for each vertex, or none.
  std::vector<double> normals_[3];
  std::vector<double> colours_[4];
  std::vector<double> texture_[2];
  std::uint32_t coloured_faces_ = 0;
  std::vector<std::string> comments_;
};

/// Go to the next line, keeping a comment.
void OffReader::end_line() {
  if (scanner_.data_ends() && *scanner_.here() == '#') comments_.push_back(scanner_.take_comment());
  scanner_.next_line();
}

/// Go to the next line that holds data.
void OffReader::skip_empty_lines() {
  while (!scanner_.at_end() && scanner_.data_ends()) end_line();
}

bool OffReader::skip_to_data(const char* what) {
  skip_empty_lines();
  return !scanner_.at_end() ||
         fail(ErrorCode::Truncated, fmt::format("the file ends before {}; export the mesh again", what));
}

/// OFF, with ST for texture coordinates, C for colours and N for normals in front. It may be missing.
bool OffReader::read_keyword() {
  if (!skip_to_data("its counts")) return false;
  std::string_view prefix = scanner_.peek_token();
  if (prefix.size() < 3 || prefix.substr(prefix.size() - 3) != "OFF") {
    if (is_digit(*scanner_.here())) return true;
    return fail(ErrorCode::Syntax, "an OFF file begins with the word 'OFF'; check the name or export the mesh again");
  }
  const std::string_view keyword = scanner_.take_token();
  prefix.remove_suffix(3);
  if (has_texture_ = prefix.substr(0, 2) == "ST"; has_texture_) prefix.remove_prefix(2);
  if (prefix.substr(0, 1) == "C") prefix.remove_prefix(1);  // colours are known by what is left of a vertex line
  if (has_normals_ = prefix.substr(0, 1) == "N"; has_normals_) prefix.remove_prefix(1);
  if (!prefix.empty()) {
    return fail(ErrorCode::UnknownFormat,
                fmt::format("{} files are not understood; export the mesh with three coordinates as OFF, COFF or NOFF",
                            in_quotes(keyword)));
  }
  if (!scanner_.data_ends() && scanner_.peek_token() == "BINARY") {
    return fail(ErrorCode::UnknownFormat, "this is a binary OFF file; export it as text");
  }
  return skip_to_data("its counts");
}

bool OffReader::read_counts() {
  std::uint32_t* const counts[] = {&vertex_count_, &face_count_};
  for (std::uint32_t* const count : counts) {
    std::int64_t written = 0;
    if (!scanner_.take_integer(written) || written < 0) return fail_number("a count of vertices or faces");
    if (std::cmp_greater(written, kMostVertices)) {
      return fail(ErrorCode::TooLarge, "the mesh has more than 4,294,967,294 vertices or faces; split it");
    }
    *count = static_cast<std::uint32_t>(written);
  }
  std::int64_t edges = 0;  // some leave it out, many do not count, and nobody needs it
  if (!scanner_.data_ends() && !scanner_.take_integer(edges)) return fail_number("a count of edges");
  return true;
}

bool OffReader::take_coordinate(double& value) {
  if (scanner_.take_real(value)) return true;
  if (!scanner_.data_ends()) return fail_number("a finite number");
  return fail(ErrorCode::Syntax, fmt::format("vertex {} of {} has too few numbers; {}", faces_.soup().positions.size(),
                                             vertex_count_, kMend));
}

bool OffReader::read_vertex() {
  std::vector<Point>& positions = faces_.soup().positions;
  const std::uint32_t vertex = static_cast<std::uint32_t>(positions.size());
  for (double& coordinate : positions.emplace_back()) {
    if (!take_coordinate(coordinate)) return false;
  }
  for (std::vector<double>& column : normals_) {
    if (has_normals_ && !take_coordinate(column.emplace_back())) return false;
  }
  if (!scanner_.data_ends() && !read_colour(vertex)) return false;
  return scanner_.data_ends() ||
         fail(ErrorCode::Syntax, fmt::format("vertex {} has more numbers than {} knows; {}", vertex + 1,
                                             has_texture_ ? "STOFF" : "OFF", kMend));
}

/// What is left of a vertex line: three or four numbers of a colour, and two of a texture coordinate if announced.
bool OffReader::read_colour(std::uint32_t vertex) {
  double values[6] = {};
  std::size_t count = 0;
  for (; count < 6 && !scanner_.data_ends(); ++count) {
    if (!scanner_.take_real(values[count])) return fail_number("a finite number");
  }
  const std::size_t texture = has_texture_ ? 2 : 0;
  const std::size_t colour = count < texture ? 5 : count - texture;
  if (colour != 0 && colour != 3 && colour != 4) {
    return fail(ErrorCode::Syntax, fmt::format("vertex {} has {} numbers after its coordinates, which are neither a "
                                               "colour nor announced by the first line; {}",
                                               vertex + 1, count, kMend));
  }
  for (std::size_t i = 0; i < colour; ++i) {
    colours_[i].resize(vertex, kMissing);
    colours_[i].push_back(values[i]);
  }
  for (std::size_t i = 0; i < texture; ++i) {
    texture_[i].resize(vertex, kMissing);
    texture_[i].push_back(values[colour + i]);
  }
  return true;
}

bool OffReader::read_face() {
  std::int64_t corners = 0;
  if (!scanner_.take_integer(corners) || corners < 0) return fail_number("a count of corners");
  if (corners < 3) {
    return fail(ErrorCode::TooFewCorners,
                fmt::format("a face needs at least three corners, but this one has {}; {}", corners, kMend));
  }
  for (std::int64_t i = 0; i < corners; ++i) {
    std::int64_t index = 0;
    if (scanner_.data_ends()) {
      return fail(ErrorCode::Syntax, fmt::format("the face has only {} of its {} corners; {}", i, corners, kMend));
    }
    if (!scanner_.take_integer(index)) return fail_number("the number of a vertex");
    if (index < 0 || std::cmp_greater_equal(index, vertex_count_)) {
      return fail(ErrorCode::BadIndex, fmt::format("vertex {} is named, but the file has only {} vertices, counted "
                                                   "from 0; {}",
                                                   index, vertex_count_, kMend));
    }
    faces_.add_corner(static_cast<std::uint32_t>(index));
  }
  if (faces_.corner_count() > kMostCorners) {
    return fail(ErrorCode::TooLarge, "the mesh has more than 2,147,483,647 face corners; split it");
  }
  faces_.close_face();
  if (scanner_.data_ends()) return true;
  ++coloured_faces_;  // a colour, or an index into a map of them: passed over with the rest of the line
  return true;
}

Expected<MeshFile> OffReader::read() {
  if (!read_keyword() || !read_counts()) return Unexpected(std::move(error_));
  end_line();
  for (std::uint32_t v = 0; v < vertex_count_; ++v, end_line()) {
    skip_empty_lines();
    if (scanner_.at_end()) {
      fail(ErrorCode::Truncated,
           fmt::format("the file ends before vertex {} of {}; export the mesh again", v + 1, vertex_count_));
      return Unexpected(std::move(error_));
    }
    if (!read_vertex()) return Unexpected(std::move(error_));
  }
  faces_.soup().vertex_count = vertex_count_;
  for (std::uint32_t f = 0; f < face_count_; ++f, end_line()) {
    skip_empty_lines();
    if (scanner_.at_end()) {
      fail(ErrorCode::Truncated,
           fmt::format("the file ends before face {} of {}; export the mesh again", f + 1, face_count_));
      return Unexpected(std::move(error_));
    }
    if (!read_face()) return Unexpected(std::move(error_));
  }
  skip_empty_lines();
  Expected<Mesh> mesh = build_mesh(std::move(faces_.soup()), name_);
  if (!mesh) return Unexpected(std::move(mesh).error());
  return assemble(std::move(*mesh));
}

/// Colours are bytes where all are whole and some exceed 1, the greatest intensity otherwise.
ScalarType colour_type(const std::vector<double> (&colours)[4]) {
  bool whole = true, large = false;
  for (const std::vector<double>& column : colours) {
    for (const double value : column) {
      if (std::isnan(value)) continue;
      whole = whole && value >= 0 && value <= 255 && value == std::floor(value);
      large = large || value > 1;
    }
  }
  return whole && large ? ScalarType::UInt8 : ScalarType::Float64;
}

MeshFile OffReader::assemble(Mesh mesh) {
  MeshFile file{.mesh = std::move(mesh), .format = Format::Off, .path = name_, .comments = std::move(comments_)};
  const auto add = [&](const char* name, ScalarType type, std::vector<double>& values, double fallback) {
    if (values.empty()) return;
    values.resize(vertex_count_, kMissing);
    std::replace_if(
        values.begin(), values.end(), [](double value) { return std::isnan(value); }, fallback);
    file.properties.push_back({.name = name, .domain = Domain::Vertex, .type = type, .values = std::move(values)});
  };
  constexpr const char* kNormals[] = {"nx", "ny", "nz"};
  constexpr const char* kColours[] = {"red", "green", "blue", "alpha"};
  constexpr const char* kTexture[] = {"s", "t"};
  const ScalarType colours = colour_type(colours_);
  const double white = colours == ScalarType::UInt8 ? 255 : 1;
  for (std::size_t i = 0; i < 3; ++i) add(kNormals[i], ScalarType::Float64, normals_[i], 0);
  for (std::size_t i = 0; i < 4; ++i) add(kColours[i], colours, colours_[i], white);
  for (std::size_t i = 0; i < 2; ++i) add(kTexture[i], ScalarType::Float64, texture_[i], 0);
  if (coloured_faces_ > 0) {
    file.notes.push_back(fmt::format("the colours of {} faces were not kept", coloured_faces_));
  }
  if (!scanner_.at_end()) {
    file.notes.push_back("there is more data than the counts declare; it was passed over");
  }
  return file;
}

}  // namespace

Expected<MeshFile> read_off(const FileBytes& bytes, const std::string& name) { return OffReader(bytes, name).read(); }

}  // namespace quadmatch::io
