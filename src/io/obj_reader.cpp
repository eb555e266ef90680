// Wavefront OBJ, as its specification (Alias, appendix B1) and twenty years of exporters write it.

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/mesh/large_pages.hpp>

#include "formats.hpp"
#include "line_chunks.hpp"
#include "line_scanner.hpp"
#include "obj_lines.hpp"
#include "passed_over.hpp"

namespace quadmatch::io {
namespace {

constexpr std::uint32_t kNoIndex = IndexedAttribute::kNoIndex;

/// What faces refer to: the vertices, texture coordinates or normals of the file.
struct Pool {
  const char* one;
  const char* many;
  std::uint64_t count = 0;
  /// References to elements further down, which OBJ allows, each with its line. Only those beyond all before them are
  /// kept: if any reference proves to lead nowhere, the first that does is among them.
  struct Reference {
    std::int64_t index;
    std::uint64_t line;
  };
  std::vector<Reference> forward = {};

  void note_forward(std::int64_t index, std::uint64_t line) {
    if (forward.empty() || index > forward.back().index) forward.push_back({index, line});
  }
  /// The first reference beyond the last element, if any.
  [[nodiscard]] const Reference* dangling() const {
    for (const Reference& reference : forward) {
      if (std::cmp_greater(reference.index, count)) return &reference;
    }
    return nullptr;
  }
};

class ObjReader {
 public:
  explicit ObjReader(const std::string& name) : name_(name) {}

  Expected<MeshFile> read(LineChunks& text);

 private:
  void reserve(const LineChunks& text);
  /// Read the lines of a piece of the text.
  bool read_lines();
  /// Step over all ordinary lines that stand next.
  void read_plain_lines();
  const char* read_plain_line(const char* line);
  const char* read_plain_vector(const char* here, std::uint32_t components, Pool& pool, std::vector<double>& values);
  const char* read_plain_face_line(const char* here);

  // Each reads the rest of a record; false when it failed, with the reason in error_.
  bool read_record(std::string_view keyword);
  bool read_other_record(std::string_view keyword);
  bool read_vertex();
  bool read_vertex_extras();
  bool read_texture_coordinate();
  bool read_normal();
  bool read_face();
  bool read_carried(std::string_view keyword);
  bool read_corner(std::uint32_t (&corner)[3]);
  bool take_index(Pool& pool, std::uint32_t& index);
  bool take_reals(double* values, int count, const char* element, const char* parts);

  void add_corner(const std::uint32_t (&corner)[3]);
  void widen_texture_pool(std::uint32_t components);
  void set_extra(std::size_t column, double value);
  void add_properties(MeshFile& file);
  Expected<MeshFile> assemble();
  std::optional<IndexedAttribute> take_attribute(std::uint32_t components, std::vector<double>& values,
                                                 std::vector<std::uint32_t>& corner_index, std::size_t corner_count);
  bool check_references();
  bool fail(ErrorCode code, std::string message);
  bool fail_number();
  bool fail_corner();

  LineScanner scanner_{std::string_view(), LineScanner::Continuation::Yes};
  const std::string& name_;
  Error error_;
  const char* corner_text_ = nullptr;

  FaceGatherer faces_;
  Pool vertices_{"vertex", "vertices"};
  Pool texture_{"texture coordinate", "texture coordinates"};
  Pool normals_{"normal", "normals"};
  std::uint32_t texture_components_ = 1;
  std::vector<double> texture_values_;
  std::vector<double> normal_values_;
  /// Per corner, filled up to the last corner that has an index.
  std::vector<std::uint32_t> corner_texture_;
  std::vector<std::uint32_t> corner_normal_;
  /// w, red, green, blue, alpha of the vertices, filled up to the last that has it.
  std::vector<double> extras_[5];
  std::size_t coloured_ = 0;
  std::vector<FaceRecord> face_records_;
  std::vector<CarriedRecord> carried_;
  std::vector<std::string> material_libraries_;
  std::vector<std::string> comments_;
  PassedOver passed_over_;
};

constexpr const char* kExtraNames[] = {"w", "red", "green", "blue", "alpha"};

/// Make room for what a large file probably holds, judged by samples of it: growing step by step would copy it all
/// twice. Room that is not used costs no memory, only addresses.
void ObjReader::reserve(const LineChunks& text) {
  constexpr std::size_t kSamples = 64;
  constexpr std::size_t kSampleSize = 2048;
  if (text.size() < 4 * kSamples * kSampleSize) return;
  std::size_t vertices = 0, texture = 0, normals = 0, faces = 0;
  for (std::size_t i = 0; i < kSamples; ++i) {
    const std::string sample = text.sample(i * (text.size() / kSamples), kSampleSize);
    for (std::size_t at = 0; at + 2 < sample.size(); ++at) {
      if (sample[at] != '\n') continue;
      vertices += sample[at + 1] == 'v' && sample[at + 2] == ' ';
      texture += sample[at + 1] == 'v' && sample[at + 2] == 't';
      normals += sample[at + 1] == 'v' && sample[at + 2] == 'n';
      faces += sample[at + 1] == 'f';
    }
  }
  // A twentieth more than the samples promise.
  const std::size_t scale = text.size() / kSampleSize / kSamples + 1;
  const auto estimate = [scale](std::size_t seen) { return seen * scale + seen * scale / 20; };
  reserve_on_large_pages(faces_.soup().positions, estimate(vertices));
  reserve_on_large_pages(faces_.soup().corners, 4 * estimate(faces));
  reserve_on_large_pages(texture_values_, 2 * estimate(texture));
  reserve_on_large_pages(normal_values_, 3 * estimate(normals));
  if (texture > 0) reserve_on_large_pages(corner_texture_, 4 * estimate(faces));
  if (normals > 0) reserve_on_large_pages(corner_normal_, 4 * estimate(faces));
}

bool ObjReader::fail(ErrorCode code, std::string message) {
  error_ = {code, std::move(message), name_, scanner_.line()};
  return false;
}

bool ObjReader::fail_number() {
  return fail(ErrorCode::BadNumber,
              fmt::format("{} is not a finite number; {}", in_quotes(scanner_.peek_token()), kMend));
}

bool ObjReader::fail_corner() {
  return fail(ErrorCode::BadNumber, fmt::format("{} is not a corner; write v, v/vt, v//vn or v/vt/vn",
                                                in_quotes(scanner_.peek_token(corner_text_))));
}

bool ObjReader::take_reals(double* values, int count, const char* element, const char* parts) {
  for (int i = 0; i < count; ++i) {
    if (scanner_.take_real(values[i])) continue;
    if (!scanner_.data_ends()) return fail_number();
    return fail(ErrorCode::Syntax,
                fmt::format("a {} needs {}, but this line has only {}; {}", element, parts, i, kMend));
  }
  return true;
}

bool ObjReader::read_vertex() {
  Point& point = faces_.soup().positions.emplace_back();
  if (!take_reals(point.data(), 3, "vertex", "three coordinates")) return false;
  ++vertices_.count;
  return scanner_.data_ends() || read_vertex_extras();
}

/// `w`, or the widespread colours `r g b` and `r g b a`.
bool ObjReader::read_vertex_extras() {
  double values[4] = {};
  int count = 0;
  for (; count < 4 && !scanner_.data_ends(); ++count) {
    if (!scanner_.take_real(values[count])) return fail_number();
  }
  if (count == 2 || !scanner_.data_ends()) {
    return fail(ErrorCode::Syntax, fmt::format("a vertex has 3 numbers, 4 with a weight, 6 with a colour or 7 with an "
                                               "alpha too, but not {}; {}",
                                               count == 2 ? "5" : "more", kMend));
  }
  if (count == 1) {
    set_extra(0, values[0]);
    return true;
  }
  for (int i = 0; i < count; ++i) set_extra(static_cast<std::size_t>(i) + 1, values[i]);
  ++coloured_;
  return true;
}

/// For the latest vertex; those before it that have none get 1, the default of a weight and the colour white.
void ObjReader::set_extra(std::size_t column, double value) {
  extras_[column].resize(vertices_.count - 1, 1.0);
  extras_[column].push_back(value);
}

bool ObjReader::read_texture_coordinate() {
  double values[3] = {};
  if (!take_reals(values, 1, "texture coordinate", "a number")) return false;
  std::uint32_t count = 1;
  for (; count < 3 && !scanner_.data_ends(); ++count) {
    if (!scanner_.take_real(values[count])) return fail_number();
  }
  if (!scanner_.data_ends()) {
    return fail(ErrorCode::Syntax, fmt::format("a texture coordinate has at most three numbers; {}", kMend));
  }
  if (count > texture_components_) widen_texture_pool(count);
  texture_values_.insert(texture_values_.end(), values, values + texture_components_);
  ++texture_.count;
  return true;
}

/// Texture coordinates of fewer numbers than others are filled with zeros, their default in OBJ.
void ObjReader::widen_texture_pool(std::uint32_t components) {
  std::vector<double> wider(texture_.count * components, 0.0);
  for (std::size_t i = 0; i < texture_.count; ++i) {
    for (std::uint32_t c = 0; c < texture_components_; ++c) {
      wider[i * components + c] = texture_values_[i * texture_components_ + c];
    }
  }
  texture_values_ = std::move(wider);
  texture_components_ = components;
}

bool ObjReader::read_normal() {
  double values[3] = {};
  if (!take_reals(values, 3, "normal", "three numbers")) return false;
  if (!scanner_.data_ends()) return fail(ErrorCode::Syntax, fmt::format("a normal has three numbers; {}", kMend));
  normal_values_.insert(normal_values_.end(), values, values + 3);
  ++normals_.count;
  return true;
}

/// An index as the file writes it, from 1, or from the latest element backwards; from 0 in `index`.
bool ObjReader::take_index(Pool& pool, std::uint32_t& index) {
  std::int64_t written = 0;
  if (!scanner_.take_prefix_integer(written)) return fail_corner();
  if (written > 0) {
    if (std::cmp_greater(written, pool.count)) pool.note_forward(written, scanner_.line());
    index = static_cast<std::uint32_t>(written - 1);
    return true;
  }
  if (written == 0) {
    return fail(ErrorCode::BadIndex, fmt::format("{} 0 is named, but OBJ counts from 1; {}", pool.one, kMend));
  }
  if (std::cmp_greater(-written, pool.count)) {
    return fail(ErrorCode::BadIndex, fmt::format("{} {} is named, but only {} {} stand above this line; {}", pool.one,
                                                 written, pool.count, pool.many, kMend));
  }
  index = static_cast<std::uint32_t>(static_cast<std::int64_t>(pool.count) + written);
  return true;
}

/// v, v/vt, v//vn or v/vt/vn, and the same with nothing after the last slash.
bool ObjReader::read_corner(std::uint32_t (&corner)[3]) {
  corner_text_ = scanner_.here();
  corner[1] = corner[2] = kNoIndex;
  if (!take_index(vertices_, corner[0])) return false;
  if (scanner_.take('/')) {
    const auto index_follows = [this] { return *scanner_.here() != '/' && !LineScanner::ends_token(*scanner_.here()); };
    if (index_follows() && !take_index(texture_, corner[1])) return false;
    if (scanner_.take('/') && index_follows() && !take_index(normals_, corner[2])) return false;
  }
  return LineScanner::ends_token(*scanner_.here()) || fail_corner();
}

void ObjReader::add_corner(const std::uint32_t (&corner)[3]) {
  if (corner[1] != kNoIndex) {
    if (corner_texture_.size() < faces_.corner_count()) corner_texture_.resize(faces_.corner_count(), kNoIndex);
    corner_texture_.push_back(corner[1]);
  }
  if (corner[2] != kNoIndex) {
    if (corner_normal_.size() < faces_.corner_count()) corner_normal_.resize(faces_.corner_count(), kNoIndex);
    corner_normal_.push_back(corner[2]);
  }
  faces_.add_corner(corner[0]);
}

bool ObjReader::read_face() {
  std::uint32_t corner[3];
  while (!scanner_.data_ends()) {
    if (!read_corner(corner)) return false;
    add_corner(corner);
  }
  if (faces_.open_corners() < 3) {
    return fail(ErrorCode::TooFewCorners, fmt::format("a face needs at least three corners, but this one has {}; {}",
                                                      faces_.open_corners(), kMend));
  }
  if (faces_.corner_count() > kMostCorners) {
    return fail(ErrorCode::TooLarge, "the mesh has more than 2,147,483,647 face corners; split it");
  }
  faces_.close_face();
  return true;
}

/// `l` and `p`: kept as text. Indices are made absolute, since the vertices around them will be elsewhere when the
/// file is written again.
bool ObjReader::read_carried(std::string_view keyword) {
  std::string text(keyword);
  std::uint32_t corner[3];
  while (!scanner_.data_ends()) {
    if (!read_corner(corner)) return false;
    text += fmt::format(" {}", corner[0] + 1ULL);
    if (corner[1] != kNoIndex) text += fmt::format("/{}", corner[1] + 1ULL);
  }
  carried_.push_back({faces_.face_count(), static_cast<std::uint32_t>(face_records_.size()), std::move(text)});
  return true;
}

bool ObjReader::read_record(std::string_view keyword) {
  if (keyword == "v") return read_vertex();
  if (keyword == "f") return read_face();
  if (keyword == "vt") return read_texture_coordinate();
  if (keyword == "vn") return read_normal();
  return keyword.empty() || read_other_record(keyword);
}

bool ObjReader::read_other_record(std::string_view keyword) {
  if (keyword == "o" || keyword == "g" || keyword == "s" || keyword == "usemtl") {
    face_records_.push_back({faces_.face_count(), std::string(keyword), scanner_.take_rest_of_line()});
  } else if (keyword == "mtllib") {
    material_libraries_.push_back(scanner_.take_rest_of_line());
  } else if (keyword == "l" || keyword == "p") {
    return read_carried(keyword);
  } else {
    passed_over_.add(keyword);
  }
  return true;
}

bool ObjReader::check_references() {
  const Pool* first_pool = nullptr;
  const Pool::Reference* first = nullptr;
  for (const Pool* pool : {&vertices_, &texture_, &normals_}) {
    const Pool::Reference* const found = pool->dangling();
    if (found == nullptr || (first != nullptr && first->line <= found->line)) continue;
    first = found;
    first_pool = pool;
  }
  if (first == nullptr) return true;
  fail(ErrorCode::BadIndex, fmt::format("{} {} is named, but the file has only {} {}; {}", first_pool->one,
                                        first->index, first_pool->count, first_pool->many, kMend));
  error_.line = first->line;
  return false;
}

void ObjReader::add_properties(MeshFile& file) {
  for (std::size_t column = 0; column < std::size(extras_); ++column) {
    if (extras_[column].empty()) continue;
    extras_[column].resize(vertices_.count, 1.0);
    file.properties.push_back({.name = kExtraNames[column],
                               .domain = Domain::Vertex,
                               .type = ScalarType::Float64,
                               .values = std::move(extras_[column])});
  }
  if (coloured_ > 0 && coloured_ < vertices_.count) {
    file.notes.push_back(fmt::format("{} of {} vertices have no colour and are taken as white",
                                     vertices_.count - coloured_, vertices_.count));
  }
}

std::optional<IndexedAttribute> ObjReader::take_attribute(std::uint32_t components, std::vector<double>& values,
                                                          std::vector<std::uint32_t>& corner_index,
                                                          std::size_t corner_count) {
  if (values.empty()) return std::nullopt;
  corner_index.resize(corner_count, kNoIndex);
  return IndexedAttribute{components, std::move(values), std::move(corner_index)};
}

const char* ObjReader::read_plain_vector(const char* here, std::uint32_t components, Pool& pool,
                                         std::vector<double>& values) {
  double read[3];
  const char* const next = read_plain_reals(here, read, components);
  if (next == nullptr) return nullptr;
  for (std::uint32_t c = 0; c < components; ++c) values.push_back(read[c]);
  ++pool.count;
  return next;
}

const char* ObjReader::read_plain_face_line(const char* here) {
  const auto limit = [](const Pool& pool) { return static_cast<std::uint32_t>(std::min(pool.count, kMostVertices)); };
  PlainFace face;
  const char* const next = read_plain_face(here, {limit(vertices_), limit(texture_), limit(normals_)}, face);
  if (next == nullptr || faces_.corner_count() + face.size > kMostCorners) return nullptr;
  const std::size_t before = faces_.corner_count();
  for (std::uint32_t k = 0; k < face.size; ++k) faces_.add_corner(face.vertex[k]);
  if (face.has_texture) {
    corner_texture_.resize(before, kNoIndex);
    for (std::uint32_t k = 0; k < face.size; ++k) corner_texture_.push_back(face.texture[k]);
  }
  if (face.has_normals) {
    corner_normal_.resize(before, kNoIndex);
    for (std::uint32_t k = 0; k < face.size; ++k) corner_normal_.push_back(face.normal[k]);
  }
  faces_.close_face();
  return next;
}

const char* ObjReader::read_plain_line(const char* line) {
  if (line[0] == 'f') return read_plain_face_line(line + 1);
  if (line[0] != 'v') return nullptr;
  if (line[1] == 't') return read_plain_vector(line + 2, texture_components_, texture_, texture_values_);
  if (line[1] == 'n') return read_plain_vector(line + 2, 3, normals_, normal_values_);
  Point point;
  const char* const next = read_plain_reals(line + 1, point.data(), 3);
  if (next == nullptr) return nullptr;
  faces_.soup().positions.push_back(point);
  ++vertices_.count;
  return next;
}

void ObjReader::read_plain_lines() {
  const char* const end = scanner_.end();
  const char* here = scanner_.here();
  std::uint64_t lines = 0;
  while (here < end) {
    const char* const next = read_plain_line(here);
    if (next == nullptr) break;
    here = next;
    ++lines;
  }
  scanner_.skip_lines(here, lines);
}

bool ObjReader::read_lines() {
  for (read_plain_lines(); !scanner_.at_end(); read_plain_lines()) {
    if (!scanner_.data_ends() && !read_record(scanner_.take_token())) return false;
    if (*scanner_.here() == '#') comments_.push_back(scanner_.take_comment());
    scanner_.next_line();
  }
  return true;
}

Expected<MeshFile> ObjReader::read(LineChunks& text) {
  reserve(text);
  bool empty = true;
  while (true) {
    const Expected<std::string_view> piece = text.next();
    if (!piece) return Unexpected(piece.error());
    if (piece->empty()) break;
    if (std::exchange(empty, false)) {
      scanner_ = LineScanner(*piece, LineScanner::Continuation::Yes);
    } else {
      scanner_.continue_with(*piece);
    }
    if (!read_lines()) return Unexpected(std::move(error_));
  }
  if (empty) return empty_file(name_);
  if (vertices_.count > kMostVertices) {
    fail(ErrorCode::TooLarge, "the mesh has more than 4,294,967,294 vertices; split it");
    return Unexpected(std::move(error_));
  }
  if (!check_references()) return Unexpected(std::move(error_));
  return assemble();
}

Expected<MeshFile> ObjReader::assemble() {
  faces_.soup().vertex_count = static_cast<std::uint32_t>(vertices_.count);
  Expected<Mesh> mesh = build_mesh(std::move(faces_.soup()), name_);
  if (!mesh) return Unexpected(std::move(mesh).error());
  const std::size_t corners = mesh->halfedge_count();
  MeshFile file{.mesh = std::move(*mesh),
                .format = Format::Obj,
                .path = name_,
                .texture_coordinates = take_attribute(texture_components_, texture_values_, corner_texture_, corners),
                .normals = take_attribute(3, normal_values_, corner_normal_, corners),
                .face_records = std::move(face_records_),
                .material_libraries = std::move(material_libraries_),
                .carried = std::move(carried_),
                .comments = std::move(comments_)};
  add_properties(file);
  passed_over_.append_notes("record", file.notes);
  return file;
}

}  // namespace

Expected<MeshFile> read_obj(LineChunks text, const std::string& name) { return ObjReader(name).read(text); }

}  // namespace quadmatch::io
