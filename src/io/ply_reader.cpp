// PLY (Turk 1994): the vertices and faces of its tables; all else is kept as properties.

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "formats.hpp"
#include "ply_body.hpp"
#include "ply_header.hpp"

namespace quadmatch::io {
namespace {

class PlyReader {
 public:
  PlyReader(PlyHeader header, PlyBody body, const std::string& name)
      : header_(std::move(header)), body_(std::move(body)), name_(name) {}
  Expected<MeshFile> read();

 private:
  PlyTable* find_table(std::string_view element);
  bool take_positions(PlyTable& vertices);
  bool take_faces(PlyTable& faces);
  bool take_face(const PlyTable& faces, const Property& indices, std::uint32_t face);
  bool fail(ErrorCode code, std::string message, std::uint64_t line = 0) {
    error_ = {code, std::move(message), name_, line};
    return false;
  }
  MeshFile assemble(Mesh mesh);

  PlyHeader header_;
  PlyBody body_;
  const std::string& name_;
  Error error_;
  FaceGatherer faces_;
  ScalarType position_type_ = ScalarType::Float64;
  std::vector<std::string> notes_;
};

PlyTable* PlyReader::find_table(std::string_view element) {
  for (PlyTable& table : body_.tables) {
    if (table.name == element) return &table;
  }
  return nullptr;
}

/// x, y and z. A file without them is a mesh without positions.
bool PlyReader::take_positions(PlyTable& vertices) {
  std::optional<Property> axes[3];
  std::size_t found = 0;
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis] = vertices.take(std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1));
    if (axes[axis] && axes[axis]->count_type) {
      return fail(ErrorCode::Syntax, fmt::format("a coordinate of the vertices is a list; {}", kMend));
    }
    found += axes[axis] ? 1 : 0;
  }
  faces_.soup().vertex_count = vertices.count;
  if (found < 3) {
    notes_.push_back(found == 0 ? "the vertices have no positions" : "the vertices lack a coordinate, taken as 0");
  }
  if (found == 0) return true;

  std::vector<Point>& positions = faces_.soup().positions;
  positions.resize(vertices.count, Point{});
  std::optional<ScalarType> type;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (!axes[axis]) continue;
    type = type && *type != axes[axis]->type ? ScalarType::Float64 : axes[axis]->type;
    for (std::uint32_t v = 0; v < vertices.count; ++v) {
      positions[v][axis] = axes[axis]->values[v];
      if (!std::isfinite(positions[v][axis])) {
        return fail(ErrorCode::BadNumber, fmt::format("a coordinate of vertex {} is not a finite number; {}", v, kMend),
                    vertices.line_of_row(v));
      }
    }
  }
  position_type_ = *type;
  return true;
}

bool PlyReader::take_faces(PlyTable& faces) {
  std::optional<Property> indices = faces.take("vertex_indices");
  if (!indices) indices = faces.take("vertex_index");
  if (!indices || !indices->count_type || is_real(indices->type)) {
    return fail(ErrorCode::Syntax, fmt::format("the faces have no list 'vertex_indices' of whole numbers; {}", kMend));
  }
  faces_.soup().corners.reserve(indices->values.size());
  for (std::uint32_t f = 0; f < faces.count; ++f) {
    if (!take_face(faces, *indices, f)) return false;
  }
  return true;
}

bool PlyReader::take_face(const PlyTable& faces, const Property& indices, std::uint32_t face) {
  const std::uint32_t begin = indices.list_starts[face];
  const std::uint32_t end = indices.list_starts[face + 1];
  if (end - begin < 3) {
    return fail(ErrorCode::TooFewCorners,
                fmt::format("a face needs at least three corners, but face {} has {}; {}", face, end - begin, kMend),
                faces.line_of_row(face));
  }
  if (end > kMostCorners) {
    return fail(ErrorCode::TooLarge, "the mesh has more than 2,147,483,647 face corners; split it");
  }
  for (std::uint32_t i = begin; i < end; ++i) {
    const double index = indices.values[i];
    if (index < 0 || index >= faces_.soup().vertex_count) {
      return fail(ErrorCode::BadIndex,
                  fmt::format("face {} names vertex {:.0f}, but the file has only {} vertices, "
                              "counted from 0; {}",
                              face, index, faces_.soup().vertex_count, kMend),
                  faces.line_of_row(face));
    }
    faces_.add_corner(static_cast<std::uint32_t>(index));
  }
  faces_.close_face();
  return true;
}

MeshFile PlyReader::assemble(Mesh mesh) {
  MeshFile file{.mesh = std::move(mesh),
                .format = Format::Ply,
                .path = name_,
                .position_type = position_type_,
                .comments = std::move(header_.comments),
                .notes = std::move(notes_)};
  for (std::string& info : header_.object_infos) {
    file.carried.push_back({.before_face = 0, .before_record = 0, .text = "obj_info " + info});
  }
  for (PlyTable& table : body_.tables) {
    const Domain domain = table.name == "vertex" ? Domain::Vertex
                          : table.name == "face" ? Domain::Face
                                                 : Domain::Further;
    for (Property& column : table.columns) column.domain = domain;
    if (domain == Domain::Further) {
      file.further_elements.push_back({std::move(table.name), table.count, std::move(table.columns)});
    } else {
      for (Property& column : table.columns) file.properties.push_back(std::move(column));
    }
  }
  if (body_.data_left) file.notes.push_back("there is more data than the header declares; it was passed over");
  return file;
}

Expected<MeshFile> PlyReader::read() {
  PlyTable* const vertices = find_table("vertex");
  PlyTable* const faces = find_table("face");
  const bool strips = find_table("tristrips") != nullptr;
  if (vertices != nullptr && !take_positions(*vertices)) return Unexpected(std::move(error_));
  if (faces != nullptr && faces->count > 0 && !take_faces(*faces)) return Unexpected(std::move(error_));
  if (strips && faces_.face_count() == 0) {
    fail(ErrorCode::Empty, "the file has triangle strips but no faces; export the mesh with polygons");
    return Unexpected(std::move(error_));
  }
  Expected<Mesh> mesh = build_mesh(std::move(faces_.soup()), name_);
  if (!mesh) return Unexpected(std::move(mesh).error());
  return assemble(std::move(*mesh));
}

}  // namespace

Expected<MeshFile> read_ply(const FileBytes& bytes, const std::string& name) {
  LineScanner scanner(bytes, LineScanner::Continuation::No);
  Expected<PlyHeader> header = read_ply_header(scanner, name);
  if (!header) return Unexpected(std::move(header).error());
  Expected<PlyBody> body = read_ply_body(scanner, *header, name);
  if (!body) return Unexpected(std::move(body).error());
  return PlyReader(std::move(*header), std::move(*body), name).read();
}

}  // namespace quadmatch::io
