// OFF (Geomview): positions, and the colours and normals that its keyword announces.

#include <algorithm>
#include <initializer_list>

#include "formats.hpp"

namespace quadmatch::io {
namespace {

/// These scalars of the vertices, or nothing unless all of them are there.
std::vector<const Property*> find_all(const MeshFile& file, std::initializer_list<std::string_view> names) {
  std::vector<const Property*> found;
  for (const std::string_view name : names) {
    const auto property = std::find_if(file.properties.begin(), file.properties.end(), [name](const Property& p) {
      return p.domain == Domain::Vertex && !p.count_type && p.name == name;
    });
    if (property == file.properties.end()) return {};
    found.push_back(&*property);
  }
  return found;
}

}  // namespace

std::string format_off(const MeshFile& file) {
  const std::vector<const Property*> normals = find_all(file, {"nx", "ny", "nz"});
  std::vector<const Property*> colours = find_all(file, {"red", "green", "blue", "alpha"});
  if (colours.empty()) colours = find_all(file, {"red", "green", "blue"});
  const std::vector<const Property*> texture = find_all(file, {"s", "t"});
  std::vector<const Property*> columns = normals;
  columns.insert(columns.end(), colours.begin(), colours.end());
  columns.insert(columns.end(), texture.begin(), texture.end());

  TextBuffer text;
  text << (texture.empty() ? "" : "ST") << (colours.empty() ? "" : "C") << (normals.empty() ? "" : "N") << "OFF\n";
  for (const std::string& comment : file.comments) text << "# " << one_line(comment) << '\n';
  text << file.mesh.vertex_count() << ' ' << file.mesh.face_count() << ' ' << file.mesh.edge_count() << '\n';
  const std::span<const Point> positions = file.mesh.positions();
  for (std::uint32_t v = 0; v < file.mesh.vertex_count(); ++v) {
    const Point point = positions.empty() ? Point{} : positions[v];
    text << point[0] << ' ' << point[1] << ' ' << point[2];
    for (const Property* const column : columns) text << ' ' << column->values[v];
    text << '\n';
  }
  for (std::uint32_t f = 0; f < file.mesh.face_count(); ++f) {
    text << file.mesh.size(FaceId(f));
    for (const HalfedgeId corner : file.mesh.halfedges(FaceId(f))) text << ' ' << file.mesh.origin(corner).value;
    text << '\n';
  }
  return std::move(text).take();
}

}  // namespace quadmatch::io
