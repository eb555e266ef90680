// PLY in its three encodings: vertices, faces, and the further elements of a PLY file that was read.

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "formats.hpp"
#include "ply_header.hpp"

namespace quadmatch::io {
namespace {

/// The nearest value of the type; what is no number becomes 0 in a whole one.
template <class T>
T saturated(double value) {
  if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(value);
  } else {
    if (std::isnan(value)) return 0;
    const double least = static_cast<double>(std::numeric_limits<T>::min());
    const double most = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(std::clamp(value, least, most));
  }
}

/// Writes the rows of tables: words on lines, or bytes.
class RowWriter {
 public:
  RowWriter(TextBuffer& text, PlyEncoding encoding)
      : text_(text),
        is_text_(encoding == PlyEncoding::Ascii),
        swap_((encoding == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big)) {}

  void put(ScalarType type, double value) {
    switch (type) {
      case ScalarType::Int8:
        return put_as(saturated<std::int8_t>(value));
      case ScalarType::UInt8:
        return put_as(saturated<std::uint8_t>(value));
      case ScalarType::Int16:
        return put_as(saturated<std::int16_t>(value));
      case ScalarType::UInt16:
        return put_as(saturated<std::uint16_t>(value));
      case ScalarType::Int32:
        return put_as(saturated<std::int32_t>(value));
      case ScalarType::UInt32:
        return put_as(saturated<std::uint32_t>(value));
      case ScalarType::Float32:
        return put_as(saturated<float>(value));
      case ScalarType::Float64:
        return put_as(value);
    }
  }
  /// The value, or the values, of one element.
  void put(const Property& column, std::uint32_t row) {
    if (!column.count_type) return put(column.type, column.values[row]);
    const std::uint32_t begin = column.list_starts[row];
    const std::uint32_t end = column.list_starts[row + 1];
    put(*column.count_type, end - begin);
    for (std::uint32_t i = begin; i < end; ++i) put(column.type, column.values[i]);
  }
  void end_row() {
    if (is_text_) text_ << '\n';
    row_begins_ = true;
  }

 private:
  template <class T>
  void put_as(T value) {
    if (is_text_) {
      if (!row_begins_) text_ << ' ';
      row_begins_ = false;
      if constexpr (std::is_floating_point_v<T>) {
        text_ << value;
      } else {
        text_ << std::int64_t{value};
      }
    } else {
      char bytes[sizeof value];
      std::memcpy(bytes, &value, sizeof value);
      if (swap_) std::reverse(bytes, bytes + sizeof value);
      text_ << std::string_view(bytes, sizeof value);
    }
  }

  TextBuffer& text_;
  const bool is_text_;
  const bool swap_;
  bool row_begins_ = true;
};

/// A name that stays one word in the header.
std::string word(std::string_view name) {
  std::string text(name.empty() ? "unnamed" : name);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }, '_');
  return text;
}

void declare(TextBuffer& text, const Property& column) {
  text << "property ";
  if (column.count_type) text << "list " << ply_name(*column.count_type) << ' ';
  text << ply_name(column.type) << ' ' << word(column.name) << '\n';
}

/// The type in which lists of so many values are counted: bytes wherever they do.
ScalarType count_type(std::uint32_t most) { return most < 256 ? ScalarType::UInt8 : ScalarType::UInt32; }

/// Texture coordinates as other programs read them: a face's list of two numbers for each corner; empty where no
/// corner has any, zeros where a single one lacks them.
Property texture_list(const MeshFile& file, std::uint32_t largest_face) {
  const IndexedAttribute& pool = *file.texture_coordinates;
  Property list{.name = "texcoord",
                .domain = Domain::Face,
                .type = ScalarType::Float64,
                .count_type = count_type(2 * largest_face),
                .list_starts = {0}};
  for (std::uint32_t f = 0; f < file.mesh.face_count(); ++f) {
    const std::size_t before = list.values.size();
    bool any = false;
    for (const HalfedgeId corner : file.mesh.halfedges(FaceId(f))) {
      const std::uint32_t index = pool.corner_index[corner.value];
      const bool has = index != IndexedAttribute::kNoIndex;
      any = any || has;
      for (std::uint32_t c = 0; c < 2; ++c) {
        const bool written = has && c < pool.components;
        list.values.push_back(written ? pool.values[std::size_t{index} * pool.components + c] : 0.0);
      }
    }
    if (!any) list.values.resize(before);
    list.list_starts.push_back(static_cast<std::uint32_t>(list.values.size()));
  }
  return list;
}

class PlyWriter {
 public:
  PlyWriter(const MeshFile& file, PlyEncoding encoding) : file_(file), encoding_(encoding) {
    for (std::uint32_t f = 0; f < file.mesh.face_count(); ++f) {
      largest_face_ = std::max(largest_face_, file.mesh.size(FaceId(f)));
    }
    if (file.mesh.vertex_count() > 0x80000000U) index_type_ = ScalarType::UInt32;
    const bool has_list = std::any_of(file.properties.begin(), file.properties.end(), [](const Property& property) {
      return property.domain == Domain::Face && property.name == "texcoord";
    });
    if (file.texture_coordinates && !has_list) texture_.push_back(texture_list(file, largest_face_));
  }

  std::string write() {
    write_header();
    RowWriter rows(text_, encoding_);
    write_vertices(rows);
    write_faces(rows);
    for (const FurtherElement& element : file_.further_elements) {
      for (std::uint32_t row = 0; row < element.count; ++row) {
        for (const Property& column : element.properties) rows.put(column, row);
        rows.end_row();
      }
    }
    return std::move(text_).take();
  }

 private:
  void write_header();
  void write_vertices(RowWriter& rows);
  void write_faces(RowWriter& rows);
  [[nodiscard]] std::vector<const Property*> columns_of(Domain domain) const {
    std::vector<const Property*> columns;
    for (const Property& property : file_.properties) {
      if (property.domain == domain) columns.push_back(&property);
    }
    if (domain == Domain::Face && !texture_.empty()) columns.push_back(&texture_.front());
    return columns;
  }

  const MeshFile& file_;
  const PlyEncoding encoding_;
  std::uint32_t largest_face_ = 0;
  ScalarType index_type_ = ScalarType::Int32;
  std::vector<Property> texture_;  // one or none
  TextBuffer text_;
};

void PlyWriter::write_header() {
  constexpr const char* kFormats[] = {"ascii", "binary_little_endian", "binary_big_endian"};
  text_ << "ply\nformat " << kFormats[static_cast<std::size_t>(encoding_)] << " 1.0\n";
  for (const std::string& comment : file_.comments) text_ << "comment " << one_line(comment) << '\n';
  if (file_.format == Format::Ply) {
    for (const CarriedRecord& record : file_.carried) text_ << one_line(record.text) << '\n';
  }
  text_ << "element vertex " << file_.mesh.vertex_count() << '\n';
  for (const char axis : {'x', 'y', 'z'}) text_ << "property " << ply_name(file_.position_type) << ' ' << axis << '\n';
  for (const Property* const column : columns_of(Domain::Vertex)) declare(text_, *column);
  text_ << "element face " << file_.mesh.face_count() << "\nproperty list " << ply_name(count_type(largest_face_))
        << ' ' << ply_name(index_type_) << " vertex_indices\n";
  for (const Property* const column : columns_of(Domain::Face)) declare(text_, *column);
  for (const FurtherElement& element : file_.further_elements) {
    text_ << "element " << word(element.name) << ' ' << element.count << '\n';
    for (const Property& column : element.properties) declare(text_, column);
  }
  text_ << "end_header\n";
}

void PlyWriter::write_vertices(RowWriter& rows) {
  const std::vector<const Property*> columns = columns_of(Domain::Vertex);
  const std::span<const Point> positions = file_.mesh.positions();
  for (std::uint32_t v = 0; v < file_.mesh.vertex_count(); ++v) {
    for (const double coordinate : positions.empty() ? Point{} : positions[v])
      rows.put(file_.position_type, coordinate);
    for (const Property* const column : columns) rows.put(*column, v);
    rows.end_row();
  }
}

void PlyWriter::write_faces(RowWriter& rows) {
  const std::vector<const Property*> columns = columns_of(Domain::Face);
  const ScalarType counts = count_type(largest_face_);
  for (std::uint32_t f = 0; f < file_.mesh.face_count(); ++f) {
    rows.put(counts, file_.mesh.size(FaceId(f)));
    for (const HalfedgeId corner : file_.mesh.halfedges(FaceId(f))) {
      rows.put(index_type_, file_.mesh.origin(corner).value);
    }
    for (const Property* const column : columns) rows.put(*column, f);
    rows.end_row();
  }
}

}  // namespace

std::string format_ply(const MeshFile& file, PlyEncoding encoding) { return PlyWriter(file, encoding).write(); }

}  // namespace quadmatch::io
