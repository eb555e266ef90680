// USD text: the mesh as one prim, or one prim for each object where objects share no vertices.

#include <algorithm>
#include <limits>
#include <set>

#include "formats.hpp"

namespace quadmatch::io {
namespace {

/// Faces and vertices that follow each other in the file and become one prim.
struct Part {
  std::string name;
  std::uint32_t first_face = 0, end_face = 0;
  std::uint32_t first_vertex = 0, end_vertex = 0;
};

/// A name as USD allows it: letters, digits and underscores, no digit in front.
std::string identifier(std::string_view name) {
  std::string text(name.empty() ? "mesh" : name);
  for (char& c : text) {
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!letter && !(c >= '0' && c <= '9')) c = '_';
  }
  return text.front() >= '0' && text.front() <= '9' ? "_" + text : text;
}

/// The parts that begin with `o` records; one for all where there are none, or where they cannot be kept apart:
/// prims do not share points.
std::vector<Part> find_parts(const MeshFile& file) {
  const std::uint32_t faces = file.mesh.face_count();
  std::vector<Part> parts;
  for (const FaceRecord& record : file.face_records) {
    if (record.keyword != "o") continue;
    if (!parts.empty()) parts.back().end_face = record.first_face;
    parts.push_back({.name = identifier(record.value), .first_face = record.first_face, .end_face = faces});
  }
  const std::string whole_name = parts.empty() ? "mesh" : parts.front().name;
  const Part whole{whole_name, 0, faces, 0, file.mesh.vertex_count()};
  if (parts.empty() || parts.front().first_face != 0) return {whole};

  std::uint32_t end = 0;
  for (Part& part : parts) {
    part.first_vertex = end;
    for (std::uint32_t f = part.first_face; f < part.end_face; ++f) {
      for (const HalfedgeId corner : file.mesh.halfedges(FaceId(f))) {
        const std::uint32_t vertex = file.mesh.origin(corner).value;
        if (vertex < part.first_vertex) return {whole};
        end = std::max(end, vertex + 1);
      }
    }
    part.end_vertex = end;
  }
  parts.back().end_vertex = file.mesh.vertex_count();
  std::set<std::string> taken;  // siblings need different names
  for (Part& part : parts) {
    while (!taken.insert(part.name).second) part.name += '_';
  }
  return parts;
}

class UsdaWriter {
 public:
  explicit UsdaWriter(const MeshFile& file) : file_(file) {}
  std::string write();

 private:
  void write_part(const Part& part);
  void write_points(const Part& part);
  void write_pool(const Part& part, const IndexedAttribute& pool, std::string_view type, std::string_view name);
  [[nodiscard]] std::vector<HalfedgeId> corners_of(const Part& part) const;

  const MeshFile& file_;
  TextBuffer text_;
};

std::vector<HalfedgeId> UsdaWriter::corners_of(const Part& part) const {
  std::vector<HalfedgeId> corners;
  for (std::uint32_t f = part.first_face; f < part.end_face; ++f) {
    for (const HalfedgeId corner : file_.mesh.halfedges(FaceId(f))) corners.push_back(corner);
  }
  return corners;
}

void UsdaWriter::write_points(const Part& part) {
  const std::span<const Point> positions = file_.mesh.positions();
  text_ << "    point3f[] points = [";
  for (std::uint32_t v = part.first_vertex; v < part.end_vertex; ++v) {
    const Point point = positions.empty() ? Point{} : positions[v];
    text_ << (v == part.first_vertex ? "(" : ", (") << point[0] << ", " << point[1] << ", " << point[2] << ')';
  }
  text_ << "]\n";
}

/// The values that corners of this part use, from the first to the last of them, with an index for each corner; -1
/// where it has none.
void UsdaWriter::write_pool(const Part& part, const IndexedAttribute& pool, std::string_view type,
                            std::string_view name) {
  const std::vector<HalfedgeId> corners = corners_of(part);
  std::uint32_t first = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t end = 0;
  for (const HalfedgeId corner : corners) {
    const std::uint32_t index = pool.corner_index[corner.value];
    if (index == IndexedAttribute::kNoIndex) continue;
    first = std::min(first, index);
    end = std::max(end, index + 1);
  }
  if (end == 0) return;
  const std::uint32_t written = name == "st" ? 2 : 3;
  text_ << "    " << type << " primvars:" << name << " = [";
  for (std::uint32_t i = first; i < end; ++i) {
    text_ << (i == first ? "(" : ", (");
    for (std::uint32_t c = 0; c < written; ++c) {
      const double value = c < pool.components ? pool.values[std::size_t{i} * pool.components + c] : 0.0;
      text_ << (c == 0 ? "" : ", ") << value;
    }
    text_ << ')';
  }
  text_ << "] (\n        interpolation = \"faceVarying\"\n    )\n    int[] primvars:" << name << ":indices = [";
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::uint32_t index = pool.corner_index[corners[k].value];
    const bool none = index == IndexedAttribute::kNoIndex;
    text_ << (k == 0 ? "" : ", ") << (none ? std::int64_t{-1} : std::int64_t{index - first});
  }
  text_ << "]\n";
}

void UsdaWriter::write_part(const Part& part) {
  text_ << "\ndef Mesh \"" << part.name << "\"\n{\n    uniform token subdivisionScheme = \"none\"\n"
        << "    int[] faceVertexCounts = [";
  for (std::uint32_t f = part.first_face; f < part.end_face; ++f) {
    text_ << (f == part.first_face ? "" : ", ") << file_.mesh.size(FaceId(f));
  }
  text_ << "]\n    int[] faceVertexIndices = [";
  bool begins = true;
  for (const HalfedgeId corner : corners_of(part)) {
    text_ << (begins ? "" : ", ") << file_.mesh.origin(corner).value - part.first_vertex;
    begins = false;
  }
  text_ << "]\n";
  write_points(part);
  if (file_.texture_coordinates) write_pool(part, *file_.texture_coordinates, "texCoord2f[]", "st");
  if (file_.normals) write_pool(part, *file_.normals, "normal3f[]", "normals");
  text_ << "}\n";
}

std::string UsdaWriter::write() {
  text_ << "#usda 1.0\n";
  for (const std::string& comment : file_.comments) text_ << "# " << one_line(comment) << '\n';
  for (const Part& part : find_parts(file_)) write_part(part);
  return std::move(text_).take();
}

}  // namespace

std::string format_usda(const MeshFile& file) { return UsdaWriter(file).write(); }

}  // namespace quadmatch::io
