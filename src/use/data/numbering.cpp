#include "numbering.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "carried_lines.hpp"
#include "scalar_types.hpp"

namespace quadmatch::use {
namespace {

std::vector<VertexId> unused_vertices(const Mesh& mesh) {
  PerVertex<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const VertexId v : mesh.corners()) used[v] = 1;
  std::vector<VertexId> unused;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (used[VertexId(v)] == 0) unused.emplace_back(v);
  }
  return unused;
}

/// The elements 0 ... count - 1 by where they come from; those from nowhere last.
template <class Id, class PerId>
std::vector<Id> by_origin(const PerId& origins) {
  std::vector<Id> order;
  for (std::uint32_t i = 0; i < origins.size(); ++i) order.emplace_back(i);
  // The id of nothing is the greatest of all.
  std::stable_sort(order.begin(), order.end(), [&](Id a, Id b) { return origins[a] < origins[b]; });
  return order;
}

/// The corner that lies on the first corner of the source's face.
HalfedgeId first_corner(const Mesh& source, const Mesh& target, const Correspondence& from, FaceId face) {
  if (from.faces[face].valid()) {
    for (const HalfedgeId h : target.halfedges(face)) {
      if (from.corners[h] == source.first(from.faces[face])) return h;
    }
  }
  return target.first(face);
}

/// The corners of the result: which of the file's each is.
std::vector<HalfedgeId> corner_order(const Mesh& mesh, const Numbering& numbering) {
  std::vector<HalfedgeId> corners;
  corners.reserve(mesh.halfedge_count());
  for (const HalfedgeId first : numbering.first_corners) {
    HalfedgeId h = first;
    do {
      corners.push_back(h);
      h = mesh.next(h);
    } while (h != first);
  }
  return corners;
}

template <class Id>
Property reordered(const Property& property, const std::vector<Id>& order) {
  Property result{property.name, property.domain, property.type, property.count_type, {}, {}};
  result.values.reserve(property.values.size());
  if (property.count_type) result.list_starts = {0};
  for (const Id id : order) {
    if (!property.count_type) {
      result.values.push_back(property.values[id.value]);
      continue;
    }
    const auto values = property.values.begin();
    result.values.insert(result.values.end(), values + property.list_starts[id.value],
                         values + property.list_starts[id.value + 1]);
    result.list_starts.push_back(static_cast<std::uint32_t>(result.values.size()));
  }
  return result;
}

void reorder(std::optional<IndexedAttribute>& attribute, const std::vector<HalfedgeId>& corners) {
  if (!attribute) return;
  std::vector<std::uint32_t> indices;
  indices.reserve(corners.size());
  for (const HalfedgeId h : corners) indices.push_back(attribute->corner_index[h.value]);
  attribute->corner_index = std::move(indices);
}

template <class Id>
std::vector<std::uint32_t> places_of(const std::vector<Id>& order) {
  std::vector<std::uint32_t> places(order.size());
  for (std::uint32_t place = 0; place < order.size(); ++place) places[order[place].value] = place;
  return places;
}

/// Lines between faces go where the face below them goes.
void renumber_lines(MeshFile& file, const std::vector<std::uint32_t>& new_vertex,
                    const std::vector<std::uint32_t>& new_face) {
  const auto vertex = [&](std::uint32_t v) { return v < new_vertex.size() ? new_vertex[v] : v; };
  const auto texture = [](std::uint32_t entry) { return entry; };
  for (CarriedRecord& line : file.carried) {
    line.text = renumbered_line(line.text, vertex, texture);
    if (line.before_face < new_face.size()) line.before_face = new_face[line.before_face];
  }
  std::stable_sort(file.carried.begin(), file.carried.end(),
                   [](const CarriedRecord& a, const CarriedRecord& b) { return a.before_face < b.before_face; });
}

PolygonSoup soup_in_order(const Mesh& mesh, const Numbering& numbering, const std::vector<HalfedgeId>& corners,
                          const std::vector<std::uint32_t>& new_vertex) {
  PolygonSoup soup;
  soup.vertex_count = mesh.vertex_count();
  if (!mesh.positions().empty()) {
    for (const VertexId v : numbering.vertices) soup.positions.push_back(mesh.positions()[v.value]);
  }
  soup.corners.reserve(corners.size());
  for (const HalfedgeId h : corners) soup.corners.emplace_back(new_vertex[mesh.origin(h).value]);
  if (mesh.all_quads()) return soup;
  soup.face_starts = {0};
  for (const FaceId f : numbering.faces) soup.face_starts.push_back(soup.face_starts.back() + mesh.size(f));
  return soup;
}

}  // namespace

void renumber_further(FurtherElement& element, const std::vector<std::uint32_t>& new_vertex,
                      std::vector<std::string>& notes) {
  constexpr std::array<std::string_view, 6> kNames{"vertex1", "vertex2", "vertex_index", "vertex_indices", "v1", "v2"};
  bool any = false;
  for (Property& property : element.properties) {
    if (!is_whole(property.type) || std::find(kNames.begin(), kNames.end(), property.name) == kNames.end()) continue;
    any = true;
    for (double& value : property.values) {
      if (value >= 0 && value < static_cast<double>(new_vertex.size())) {
        value = new_vertex[static_cast<std::size_t>(value)];
      }
    }
    property.type = holding_both(property.type, ScalarType::Int32);
  }
  if (any) return;
  notes.push_back(
      fmt::format("the elements {} were left as they are; if they name vertices or faces, then by the "
                  "numbers from before",
                  element.name));
}

Numbering as_it_is(const Mesh& target) {
  Numbering numbering;
  for (std::uint32_t v = 0; v < target.vertex_count(); ++v) numbering.vertices.emplace_back(v);
  for (std::uint32_t f = 0; f < target.face_count(); ++f) {
    numbering.faces.emplace_back(f);
    numbering.first_corners.push_back(target.first(FaceId(f)));
  }
  return numbering;
}

Numbering like_source(const Mesh& source, const Mesh& target, const Correspondence& from) {
  PerVertex<VertexId> origins = from.partners;
  const std::vector<VertexId> theirs = unused_vertices(source);
  const std::vector<VertexId> own = unused_vertices(target);
  for (std::size_t k = 0; theirs.size() == own.size() && k < own.size(); ++k) origins[own[k]] = theirs[k];

  Numbering numbering{by_origin<VertexId>(origins), by_origin<FaceId>(from.faces), {}};
  for (const FaceId f : numbering.faces) numbering.first_corners.push_back(first_corner(source, target, from, f));
  return numbering;
}

Expected<MeshFile> renumbered(MeshFile file, const Numbering& numbering) {
  const std::vector<HalfedgeId> corners = corner_order(file.mesh, numbering);
  const std::vector<std::uint32_t> new_vertex = places_of(numbering.vertices);
  const std::vector<std::uint32_t> new_face = places_of(numbering.faces);
  for (Property& property : file.properties) {
    if (property.domain == Domain::Vertex) property = reordered(property, numbering.vertices);
    if (property.domain == Domain::Face) property = reordered(property, numbering.faces);
    if (property.domain == Domain::Corner) property = reordered(property, corners);
  }
  reorder(file.texture_coordinates, corners);
  reorder(file.normals, corners);
  renumber_lines(file, new_vertex, new_face);
  for (FurtherElement& element : file.further_elements) renumber_further(element, new_vertex, file.notes);
  Expected<Mesh> mesh = Mesh::build(soup_in_order(file.mesh, numbering, corners, new_vertex));
  if (!mesh) return Unexpected(mesh.error());
  file.mesh = *std::move(mesh);
  return file;
}

}  // namespace quadmatch::use
