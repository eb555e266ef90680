// Mesh: a MeshFile of the library, its arrays seen without a copy; read and write.

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"

namespace quadmatch::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::int64_t, py::array::c_style>;

constexpr std::int64_t kMostVertices = std::numeric_limits<std::int32_t>::max();

/// Named data of vertices or faces as Python gives them: name, numeric type, one value for each element.
using NamedData = std::vector<std::tuple<std::string, ScalarType, Numbers>>;
/// A pool of texture coordinates (#tuples by components), and the tuple of each corner or -1.
using PoolData = std::optional<std::pair<Numbers, Indices>>;

/// What a mesh is made of, checked for shape by the package around us.
struct Arrays {
  std::optional<Numbers> positions;  // #V by 3
  std::int64_t vertex_count;
  Indices corners;
  std::optional<Indices> face_starts;  // none: quads
};

template <class Value>
std::span<const Value> span_of(const py::array_t<Value, py::array::c_style>& array) {
  return {array.data(), static_cast<std::size_t>(array.size())};
}

Unexpected<Error> refuse(ErrorCode code, std::string message) { return Unexpected(Error{code, std::move(message)}); }

/// Is none of them infinite or not a number? Their exponents alone say so, and in a form that compilers do several at a
/// time.
bool all_finite(std::span<const double> numbers) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63U, kExponentStep = std::uint64_t{1} << 52U;
  std::uint64_t carried = 0;  // an exponent of all ones overflows into the place of the sign
  for (const double number : numbers) carried |= (std::bit_cast<std::uint64_t>(number) & ~kSign) + kExponentStep;
  return (carried & kSign) == 0;
}

Expected<std::vector<Point>> points_of(std::span<const double> numbers) {
  if (!all_finite(numbers)) {
    const auto wrong = std::find_if_not(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
    return refuse(ErrorCode::BadNumber,
                  fmt::format("a coordinate of vertex v{} is not a finite number; correct it, or give None for the "
                              "positions",
                              (wrong - numbers.begin()) / 3));
  }
  // Three numbers in a row are a point; a vector that is made of them is not filled with zeros before.
  const Point* const first = reinterpret_cast<const Point*>(numbers.data());
  return std::vector<Point>(first, first + numbers.size() / 3);
}

/// Where the faces start, as 32-bit numbers.
Expected<std::vector<std::uint32_t>> starts_of(std::span<const std::int64_t> offsets, std::size_t corners) {
  std::vector<std::uint32_t> starts;
  starts.reserve(offsets.size());
  for (const std::int64_t offset : offsets) {
    if (offset < 0 || static_cast<std::uint64_t>(offset) > corners) {
      return refuse(
          ErrorCode::BadIndex,
          fmt::format("offset {} is outside the {} indices; offsets run from 0 to their number", offset, corners));
    }
    starts.push_back(static_cast<std::uint32_t>(offset));
  }
  return starts;
}

/// The face that a corner belongs to.
std::size_t face_at(const std::vector<std::uint32_t>& starts, std::size_t corner) {
  if (starts.empty()) return corner / 4;
  return static_cast<std::size_t>(std::upper_bound(starts.begin(), starts.end(), corner) - starts.begin()) - 1;
}

/// @pre  some index is no vertex.
Error wrong_index(std::span<const std::int64_t> indices, std::int64_t vertex_count,
                  const std::vector<std::uint32_t>& starts) {
  const auto outside = [vertex_count](std::int64_t index) { return index < 0 || index >= vertex_count; };
  const auto wrong = std::find_if(indices.begin(), indices.end(), outside);
  const std::size_t face = face_at(starts, static_cast<std::size_t>(wrong - indices.begin()));
  return {ErrorCode::BadIndex,
          *wrong < 0 ? fmt::format("face f{} names vertex {}, but vertices count from 0", face, *wrong)
                     : fmt::format("face f{} names vertex {}, but there are only {} vertices, counted from 0", face,
                                   *wrong, vertex_count)};
}

Expected<std::vector<VertexId>> corners_of(std::span<const std::int64_t> indices, std::int64_t vertex_count,
                                           const std::vector<std::uint32_t>& starts) {
  std::vector<VertexId> corners(indices.size());
  bool outside = false;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    outside |= static_cast<std::uint64_t>(indices[k]) >= static_cast<std::uint64_t>(vertex_count);
    corners[k] = VertexId(static_cast<std::uint32_t>(indices[k]));
  }
  if (outside) return Unexpected(wrong_index(indices, vertex_count, starts));
  return corners;
}

/// From what Python gives to what the library takes, without a word to Python.
Expected<Mesh> build(std::optional<std::span<const double>> positions, std::int64_t vertex_count,
                     std::span<const std::int64_t> indices, std::optional<std::span<const std::int64_t>> offsets) {
  if (indices.empty()) return refuse(ErrorCode::Empty, "there are no faces; give the mesh with its faces");
  if (vertex_count > kMostVertices || indices.size() > static_cast<std::size_t>(kMostVertices)) {
    return refuse(ErrorCode::TooLarge, "the mesh has more than 2,147,483,647 vertices or face corners; split it");
  }
  PolygonSoup soup{.vertex_count = static_cast<std::uint32_t>(vertex_count)};
  if (offsets) {
    Expected<std::vector<std::uint32_t>> starts = starts_of(*offsets, indices.size());
    if (!starts) return Unexpected(starts.error());
    soup.face_starts = *std::move(starts);
  }
  Expected<std::vector<VertexId>> corners = corners_of(indices, vertex_count, soup.face_starts);
  if (!corners) return Unexpected(corners.error());
  soup.corners = *std::move(corners);
  if (positions) {
    Expected<std::vector<Point>> points = points_of(*positions);
    if (!points) return Unexpected(points.error());
    soup.positions = *std::move(points);
  }
  return Mesh::build(std::move(soup));
}

Expected<Mesh> build(const Arrays& arrays) {
  std::optional<std::span<const double>> positions;
  if (arrays.positions) positions = span_of(*arrays.positions);
  std::optional<std::span<const std::int64_t>> offsets;
  if (arrays.face_starts) offsets = span_of(*arrays.face_starts);
  const std::span<const std::int64_t> indices = span_of(arrays.corners);
  const py::gil_scoped_release released;
  return build(positions, arrays.vertex_count, indices, offsets);
}

void add_data(MeshFile& file, Domain domain, const NamedData& data) {
  for (const auto& [name, type, values] : data) {
    Property property{.name = name, .domain = domain, .type = type};
    property.values.assign(values.data(), values.data() + values.size());
    file.properties.push_back(std::move(property));
  }
}

IndexedAttribute pool_of(const std::pair<Numbers, Indices>& data) {
  const auto& [values, indices] = data;
  IndexedAttribute pool{.components = static_cast<std::uint32_t>(values.shape(1))};
  pool.values.assign(values.data(), values.data() + values.size());
  for (const std::int64_t index : span_of(indices)) {
    pool.corner_index.push_back(index < 0 ? IndexedAttribute::kNoIndex : static_cast<std::uint32_t>(index));
  }
  return pool;
}

MeshHandle make_mesh(std::string name, std::optional<Numbers> positions, std::int64_t vertex_count, Indices corners,
                     std::optional<Indices> face_starts, const NamedData& vertex_data, const NamedData& face_data,
                     const PoolData& texture_coordinates) {
  Expected<Mesh> mesh = build(Arrays{std::move(positions), vertex_count, std::move(corners), std::move(face_starts)});
  if (!mesh) {
    mesh.error().path = name;
    raise(mesh.error());
  }
  auto file = std::make_shared<MeshFile>(MeshFile{.mesh = *std::move(mesh), .path = std::move(name)});
  add_data(*file, Domain::Vertex, vertex_data);
  add_data(*file, Domain::Face, face_data);
  if (texture_coordinates) file->texture_coordinates = pool_of(*texture_coordinates);
  return file;
}

MeshHandle read(const std::string& path) {
  Expected<MeshFile> file = [&] {
    const py::gil_scoped_release released;
    return read_mesh(path);
  }();
  MeshHandle handle = std::make_shared<MeshFile>(taken(std::move(file)));
  if (handle->mesh.vertex_count() > kMostVertices) {
    raise({ErrorCode::TooLarge, "the mesh has more than 2,147,483,647 vertices; split it", path});
  }
  return handle;
}

void write(const std::string& path, const MeshFile& file, PlyEncoding ply) {
  const Expected<void> written = [&] {
    const py::gil_scoped_release released;
    return write_mesh(path, file, {.ply = ply});
  }();
  if (!written) raise(written.error());
}

const MeshFile& mesh_of(const py::object& self) { return *self.cast<MeshHandle>(); }

py::object positions(const py::object& self) {
  const std::span<const Point> points = mesh_of(self).mesh.positions();
  if (points.empty()) return py::none();
  return view_of(py::dtype::of<double>(), points.data(), points.size(), 3, self);
}

py::array corners(const py::object& self) {
  const std::span<const VertexId> all = mesh_of(self).mesh.corners();
  return ids_view(all.data(), all.size(), self);
}

py::array offsets(const MeshFile& file) {
  std::vector<std::int32_t> starts;
  starts.reserve(file.mesh.face_count() + std::size_t{1});
  for (std::uint32_t f = 0; f < file.mesh.face_count(); ++f) {
    starts.push_back(static_cast<std::int32_t>(file.mesh.first(FaceId(f)).value));
  }
  starts.push_back(static_cast<std::int32_t>(file.mesh.halfedge_count()));
  return owned(std::move(starts));
}

/// Name -> values, or (offsets, values) for lists.
py::dict data_of(const py::object& self, Domain domain) {
  py::dict data;
  for (const Property& property : mesh_of(self).properties) {
    if (property.domain != domain) continue;
    const py::array values = numbers_view(property.values, 0, self);
    if (!property.count_type) {
      data[py::str(property.name)] = values;
    } else {
      data[py::str(property.name)] =
          py::make_tuple(ids_view(property.list_starts.data(), property.list_starts.size(), self), values);
    }
  }
  return data;
}

py::object pool_view(const py::object& self, const std::optional<IndexedAttribute>& pool) {
  if (!pool) return py::none();
  return py::make_tuple(numbers_view(pool->values, pool->components, self),
                        ids_view(pool->corner_index.data(), pool->corner_index.size(), self));
}

std::vector<std::tuple<std::uint32_t, std::string, std::string>> records_of(const MeshFile& file) {
  std::vector<std::tuple<std::uint32_t, std::string, std::string>> records;
  for (const FaceRecord& record : file.face_records) {
    records.emplace_back(record.first_face, record.keyword, record.value);
  }
  return records;
}

}  // namespace

void bind_mesh(py::module_& module) {
  py::enum_<ScalarType>(module, "ScalarType")
      .value("int8", ScalarType::Int8)
      .value("uint8", ScalarType::UInt8)
      .value("int16", ScalarType::Int16)
      .value("uint16", ScalarType::UInt16)
      .value("int32", ScalarType::Int32)
      .value("uint32", ScalarType::UInt32)
      .value("float32", ScalarType::Float32)
      .value("float64", ScalarType::Float64);
  py::enum_<PlyEncoding>(module, "PlyEncoding")
      .value("ascii", PlyEncoding::Ascii)
      .value("little", PlyEncoding::LittleEndian)
      .value("big", PlyEncoding::BigEndian);

  py::class_<MeshFile, MeshHandle>(module, "Mesh")
      .def(py::init(&make_mesh), py::arg("name"), py::arg("positions"), py::arg("vertex_count"), py::arg("corners"),
           py::arg("face_starts"), py::arg("vertex_data"), py::arg("face_data"), py::arg("texture_coordinates"))
      .def_property_readonly("path", [](const MeshFile& file) { return py::bytes(file.path); })
      .def_property_readonly("notes", [](const MeshFile& file) { return file.notes; })
      .def_property_readonly("vertex_count", [](const MeshFile& file) { return file.mesh.vertex_count(); })
      .def_property_readonly("face_count", [](const MeshFile& file) { return file.mesh.face_count(); })
      .def_property_readonly("edge_count", [](const MeshFile& file) { return file.mesh.edge_count(); })
      .def_property_readonly("all_quads", [](const MeshFile& file) { return file.mesh.all_quads(); })
      .def_property_readonly("positions", &positions)
      .def_property_readonly("corners", &corners)
      .def_property_readonly("offsets", &offsets)
      .def_property_readonly("vertex_data", [](const py::object& self) { return data_of(self, Domain::Vertex); })
      .def_property_readonly("face_data", [](const py::object& self) { return data_of(self, Domain::Face); })
      .def_property_readonly("texture_coordinates",
                             [](const py::object& self) { return pool_view(self, mesh_of(self).texture_coordinates); })
      .def_property_readonly("normals", [](const py::object& self) { return pool_view(self, mesh_of(self).normals); })
      .def_property_readonly("face_records", &records_of);

  module.def("read", &read, py::arg("path"));
  module.def("write", &write, py::arg("path"), py::arg("mesh"), py::arg("ply"));
}

}  // namespace quadmatch::python
