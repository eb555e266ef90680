#include "usda_mesh.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "line_scanner.hpp"

namespace quadmatch::io {
namespace {

bool is_normals(const UsdaPrimvar& primvar) { return primvar.name == "normals"; }

/// The texture coordinates among the primvars: `st` by convention, else the first there is.
const UsdaPrimvar* find_texture(const UsdaMesh& mesh) {
  const UsdaPrimvar* found = nullptr;
  for (const UsdaPrimvar& primvar : mesh.primvars) {
    if (primvar.components != 2) continue;
    if (found == nullptr || primvar.name == "st") found = &primvar;
  }
  return found;
}

}  // namespace

UsdaPrimvar& UsdaMesh::primvar(std::string_view primvar_name) {
  for (UsdaPrimvar& known : primvars) {
    if (known.name == primvar_name) return known;
  }
  UsdaPrimvar& made = primvars.emplace_back();
  made.name = primvar_name;
  return made;
}

bool UsdaCollector::fail(const UsdaMesh& mesh, ErrorCode code, const std::string& message, std::uint64_t line) {
  error = {code, fmt::format("mesh {}: {}; {}", in_quotes(mesh.name), message, kMend), name_, line};
  return false;
}

bool UsdaCollector::add(const UsdaMesh& mesh) {
  if (!check_counts(mesh)) return false;
  records_.push_back({faces_.face_count(), "o", mesh.name});
  if (!add_faces(mesh)) return false;
  texture_.corner_index.resize(faces_.corner_count(), IndexedAttribute::kNoIndex);
  normals_.corner_index.resize(faces_.corner_count(), IndexedAttribute::kNoIndex);
  if (const UsdaPrimvar* const texture = find_texture(mesh)) add_primvar(mesh, *texture, texture_);
  const auto normals = std::find_if(mesh.primvars.begin(), mesh.primvars.end(), is_normals);
  if (normals != mesh.primvars.end()) add_primvar(mesh, *normals, normals_);
  if (mesh.left_handed) {
    notes_.push_back(fmt::format("mesh {} is left-handed; its faces were turned over", in_quotes(mesh.name)));
  }
  return true;
}

bool UsdaCollector::check_counts(const UsdaMesh& mesh) {
  std::uint64_t needed = 0;
  for (std::size_t f = 0; f < mesh.face_vertex_counts.size(); ++f) {
    const std::int64_t corners = mesh.face_vertex_counts[f];
    if (corners < 3) {
      return fail(mesh, ErrorCode::TooFewCorners,
                  fmt::format("a face needs at least three corners, but face {} has {}", f, corners), mesh.counts_line);
    }
    needed += static_cast<std::uint64_t>(corners);
    if (needed > kMostCorners) break;
  }
  if (needed + faces_.corner_count() > kMostCorners) {
    return fail(mesh, ErrorCode::TooLarge, "there are more than 2,147,483,647 face corners", mesh.counts_line);
  }
  if (needed != mesh.face_vertex_indices.size()) {
    return fail(mesh, ErrorCode::Syntax,
                fmt::format("faceVertexCounts asks for {} corners, but faceVertexIndices has {}", needed,
                            mesh.face_vertex_indices.size()),
                mesh.counts_line);
  }
  if (faces_.soup().vertex_count + mesh.points.size() / 3 > kMostVertices) {
    return fail(mesh, ErrorCode::TooLarge, "there are more than 4,294,967,294 points", mesh.points_line);
  }
  return true;
}

bool UsdaCollector::add_faces(const UsdaMesh& mesh) {
  PolygonSoup& soup = faces_.soup();
  const std::size_t points = mesh.points.size() / 3;
  const std::uint32_t base = soup.vertex_count;
  corners_.clear();
  std::size_t begin = 0;
  for (std::size_t f = 0; f < mesh.face_vertex_counts.size(); ++f) {
    const std::size_t size = static_cast<std::size_t>(mesh.face_vertex_counts[f]);
    for (std::size_t k = 0; k < size; ++k) {
      // A face turned over keeps its first corner.
      const std::size_t listed = begin + (mesh.left_handed ? (size - k) % size : k);
      const std::int64_t vertex = mesh.face_vertex_indices[listed];
      if (vertex < 0 || std::cmp_greater_equal(vertex, points)) {
        return fail(mesh, ErrorCode::BadIndex,
                    fmt::format("face {} names point {}, but there are only {}, counted from 0", f, vertex, points),
                    mesh.indices_line);
      }
      corners_.push_back({listed, static_cast<std::size_t>(vertex), f});
      faces_.add_corner(base + static_cast<std::uint32_t>(vertex));
    }
    faces_.close_face();
    begin += size;
  }
  for (std::size_t p = 0; p < points; ++p) {
    soup.positions.push_back({mesh.points[3 * p], mesh.points[3 * p + 1], mesh.points[3 * p + 2]});
  }
  soup.vertex_count += static_cast<std::uint32_t>(points);
  return true;
}

/// Values that do not fit the mesh are dropped with a note: connectivity is what a reader must not lose.
void UsdaCollector::add_primvar(const UsdaMesh& mesh, const UsdaPrimvar& primvar, IndexedAttribute& pool) {
  const std::size_t tuples = primvar.values.size() / primvar.components;
  const std::size_t count = primvar.indices ? primvar.indices->size() : tuples;
  const bool by_corner = primvar.interpolation == "faceVarying";
  const bool by_face = primvar.interpolation == "uniform";
  const bool constant = primvar.interpolation == "constant";
  const std::size_t expected = by_corner  ? corners_.size()
                               : by_face  ? mesh.face_vertex_counts.size()
                               : constant ? 1
                                          : mesh.points.size() / 3;
  // A negative index says that there is no value here.
  const auto in_pool = [tuples](std::int64_t index) { return std::cmp_less(index, tuples); };
  if (count != expected || tuples > IndexedAttribute::kNoIndex - pool.values.size() / pool.components - 1 ||
      (primvar.indices && !std::all_of(primvar.indices->begin(), primvar.indices->end(), in_pool))) {
    notes_.push_back(fmt::format("mesh {}: {} {} do not fit its faces and were not kept", in_quotes(mesh.name), count,
                                 in_quotes(primvar.name)));
    return;
  }
  const std::size_t base = pool.values.size() / pool.components;
  const std::size_t first_corner = pool.corner_index.size() - corners_.size();
  pool.values.insert(pool.values.end(), primvar.values.begin(), primvar.values.end());
  for (std::size_t k = 0; k < corners_.size(); ++k) {
    const Corner& corner = corners_[k];
    const std::size_t slot = by_corner ? corner.listed : by_face ? corner.face : constant ? 0 : corner.vertex;
    const std::int64_t index = primvar.indices ? (*primvar.indices)[slot] : static_cast<std::int64_t>(slot);
    if (index >= 0)
      pool.corner_index[first_corner + k] = static_cast<std::uint32_t>(base + static_cast<std::size_t>(index));
  }
}

Expected<MeshFile> UsdaCollector::finish() {
  Expected<Mesh> mesh = build_mesh(std::move(faces_.soup()), name_);
  if (!mesh) return Unexpected(std::move(mesh).error());
  MeshFile file{.mesh = std::move(*mesh),
                .format = Format::Usda,
                .path = name_,
                .face_records = std::move(records_),
                .notes = std::move(notes_)};
  if (!texture_.values.empty()) file.texture_coordinates = std::move(texture_);
  if (!normals_.values.empty()) file.normals = std::move(normals_);
  return file;
}

}  // namespace quadmatch::io
