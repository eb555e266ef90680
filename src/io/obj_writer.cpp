// Wavefront OBJ: vertices, texture coordinates and normals first, then the faces with the records between them.

#include <cmath>

#include "formats.hpp"

namespace quadmatch::io {
namespace {

/// A vertex colour or weight, by the name under which readers file it.
const Property* find_vertex_scalar(const MeshFile& file, std::string_view name) {
  for (const Property& property : file.properties) {
    const bool scalar = property.domain == Domain::Vertex && !property.count_type;
    if (scalar && property.name == name && property.values.size() == file.mesh.vertex_count()) return &property;
  }
  return nullptr;
}

/// OBJ's colours run from 0 to 1; those kept in bytes run to 255.
double colour_value(const Property& property, std::uint32_t vertex) {
  const double value = property.values[vertex];
  return property.type == ScalarType::UInt8 ? value / 255 : value;
}

/// The columns behind the coordinates: the colour if it is whole, else the weight.
std::vector<const Property*> find_extras(const MeshFile& file) {
  const Property* const red = find_vertex_scalar(file, "red");
  const Property* const green = find_vertex_scalar(file, "green");
  const Property* const blue = find_vertex_scalar(file, "blue");
  const Property* const alpha = find_vertex_scalar(file, "alpha");
  if (red != nullptr && green != nullptr && blue != nullptr) {
    if (alpha != nullptr) return {red, green, blue, alpha};
    return {red, green, blue};
  }
  if (const Property* const weight = find_vertex_scalar(file, "w")) return {weight};
  return {};
}

void write_vertices(TextBuffer& text, const MeshFile& file) {
  const std::vector<const Property*> extras = find_extras(file);
  const std::span<const Point> positions = file.mesh.positions();
  for (std::uint32_t v = 0; v < file.mesh.vertex_count(); ++v) {
    const Point point = positions.empty() ? Point{} : positions[v];
    text << "v " << point[0] << ' ' << point[1] << ' ' << point[2];
    for (const Property* const extra : extras) text << ' ' << colour_value(*extra, v);
    text << '\n';
  }
}

void write_pool(TextBuffer& text, std::string_view keyword, const IndexedAttribute& pool) {
  for (std::size_t i = 0; i < pool.values.size(); ++i) {
    if (i % pool.components == 0) text << keyword;
    text << ' ' << pool.values[i];
    if ((i + 1) % pool.components == 0) text << '\n';
  }
}

void write_corner(TextBuffer& text, const MeshFile& file, HalfedgeId corner) {
  const auto index_in = [corner](const std::optional<IndexedAttribute>& pool) {
    return pool ? pool->corner_index[corner.value] : IndexedAttribute::kNoIndex;
  };
  const std::uint32_t texture = index_in(file.texture_coordinates);
  const std::uint32_t normal = index_in(file.normals);
  text << ' ' << file.mesh.origin(corner).value + 1;
  if (texture != IndexedAttribute::kNoIndex) text << '/' << texture + 1;
  if (normal == IndexedAttribute::kNoIndex) return;
  text << (texture == IndexedAttribute::kNoIndex ? "//" : "/") << normal + 1;
}

/// A text at the end of a line. A backslash there would continue the line; a blank behind it is no part of the text.
std::string ending_its_line(std::string_view text) {
  std::string line = one_line(text);
  if (!line.empty() && line.back() == '\\') line += ' ';
  return line;
}

/// Writes the records that stand between faces, in their order, as far as they belong before a given face.
class RecordWriter {
 public:
  explicit RecordWriter(const MeshFile& file) : file_(file) {}

  void write_before(TextBuffer& text, std::uint32_t face) {
    while (true) {
      const bool record = record_ < file_.face_records.size() && file_.face_records[record_].first_face <= face;
      const bool carried =
          file_.format == Format::Obj && carried_ < file_.carried.size() && file_.carried[carried_].before_face <= face;
      if (carried && (!record || file_.carried[carried_].before_record <= record_)) {
        text << ending_its_line(file_.carried[carried_++].text) << '\n';
      } else if (record) {
        const FaceRecord& next = file_.face_records[record_++];
        text << next.keyword << (next.value.empty() ? "" : " ") << ending_its_line(next.value) << '\n';
      } else {
        return;
      }
    }
  }

 private:
  const MeshFile& file_;
  std::size_t record_ = 0;
  std::size_t carried_ = 0;
};

}  // namespace

std::string format_obj(const MeshFile& file) {
  TextBuffer text;
  text.reserve(std::size_t{file.mesh.vertex_count()} * 32 + std::size_t{file.mesh.halfedge_count()} * 8);
  for (const std::string& comment : file.comments) text << "# " << one_line(comment) << '\n';
  for (const std::string& library : file.material_libraries) text << "mtllib " << ending_its_line(library) << '\n';
  write_vertices(text, file);
  if (file.texture_coordinates) write_pool(text, "vt", *file.texture_coordinates);
  if (file.normals) write_pool(text, "vn", *file.normals);

  RecordWriter records(file);
  for (std::uint32_t f = 0; f < file.mesh.face_count(); ++f) {
    records.write_before(text, f);
    text << 'f';
    for (const HalfedgeId corner : file.mesh.halfedges(FaceId(f))) write_corner(text, file, corner);
    text << '\n';
  }
  records.write_before(text, file.mesh.face_count());
  return std::move(text).take();
}

}  // namespace quadmatch::io
