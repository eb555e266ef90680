#include "mesh_blocks.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/analysis/vertex_code.hpp>

namespace quadmatch::report {
namespace {

constexpr double kGrid = 65535.0;
/// A face whose edges are shorter than so many steps would look crumpled.
constexpr double kFewestSteps = 8.0;
/// Nothing beyond can be drawn with 32-bit numbers.
constexpr double kFarthest = 1e30;

/// A coordinate that can be drawn.
double drawn(double coordinate) { return std::abs(coordinate) < kFarthest ? coordinate : 0.0; }

/// Of twenty edges with a length one is at most so long.
double short_edge(const Mesh& mesh) {
  std::vector<double> lengths;
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    const Point& a = mesh.positions()[mesh.origin(HalfedgeId(h)).value];
    const Point& b = mesh.positions()[mesh.tip(HalfedgeId(h)).value];
    const double length = std::hypot(drawn(a[0]) - drawn(b[0]), drawn(a[1]) - drawn(b[1]), drawn(a[2]) - drawn(b[2]));
    if (length > 0) lengths.push_back(length);
  }
  if (lengths.empty()) return 0;
  const auto place = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 20);
  std::nth_element(lengths.begin(), place, lengths.end());
  return *place;
}

/// The box of all vertices, and how finely it must be divided.
void measure(const Mesh& mesh, MeshHeader& header) {
  std::array<double, 3> high = {};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    header.low[axis] = high[axis] = drawn(mesh.positions().front()[axis]);
  }
  for (const Point& point : mesh.positions()) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      header.low[axis] = std::min(header.low[axis], drawn(point[axis]));
      high[axis] = std::max(high[axis], drawn(point[axis]));
    }
  }
  double longest = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) longest = std::max(longest, high[axis] - header.low[axis]);
  header.step = longest / kGrid;
  const bool fine = short_edge(mesh) >= kFewestSteps * header.step;
  header.precision = fine ? Precision::Grid : Precision::Float32;
}

Packer positions_of(const Mesh& mesh, const MeshHeader& header) {
  Packer packer;
  for (const Point& point : mesh.positions()) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double offset = drawn(point[axis]) - header.low[axis];
      if (header.precision == Precision::Float32) {
        packer.add_float32(static_cast<float>(offset));
      } else {
        packer.add_uint16(static_cast<std::uint16_t>(header.step > 0 ? std::lround(offset / header.step) : 0));
      }
    }
  }
  return packer;
}

Packer sizes_of(const Mesh& mesh) {
  Packer packer;
  if (mesh.all_quads()) return packer;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) packer.add(mesh.size(FaceId(f)));
  return packer;
}

/// As steps from one to the next, which are short where a file goes on where it was; in files of random order, where
/// they are not, as so many bits each.
Packer corners_of(const Mesh& mesh, MeshHeader& header) {
  Packer steps;
  std::vector<std::uint32_t> numbers;
  numbers.reserve(mesh.corners().size());
  std::uint32_t before = 0;
  for (const VertexId corner : mesh.corners()) {
    steps.add_step(before, corner.value);
    numbers.push_back(before = corner.value);
  }
  const auto width = static_cast<std::uint32_t>(std::bit_width(mesh.vertex_count() | 1U));
  if (steps.bytes().size() <= numbers.size() * width / 8) return steps;
  header.corner_bits = width;
  Packer packed;
  packed.add_packed(numbers, width);
  return packed;
}

/// A bit for each half-edge: is it the one that names an edge of the skeleton?
Packer lines_of(const Mesh& mesh, const ArcGraph& separatrices) {
  std::vector<bool> on_line(mesh.halfedge_count(), false);
  for (const Spoke& spoke : separatrices.spokes) {
    Dart dart = spoke.start;
    for (std::uint32_t walked = 1;; ++walked) {
      on_line[mesh.edge(dart.halfedge).value] = true;
      if (walked == spoke.length) break;
      dart = straight_ahead(mesh, dart);
    }
  }
  Packer packer;
  packer.add_bits(on_line);
  return packer;
}

/// Vertex and code of every extraordinary fan, ascending.
Packer extraordinary_of(const Mesh& mesh, const PerFan<VertexCode>& codes) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
  for (std::uint32_t p = 0; p < mesh.fan_count(); ++p) {
    if (codes[FanId(p)].extraordinary()) found.emplace_back(mesh.vertex(FanId(p)).value, codes[FanId(p)].value);
  }
  std::sort(found.begin(), found.end());
  Packer packer;
  packer.add(found.size());
  std::uint32_t before = 0;
  for (const auto& [vertex, code] : found) {
    packer.add_step(before, vertex);
    packer.add(code);
    before = vertex;
  }
  return packer;
}

/// Vertices where two traces cross.
Packer crossings_of(const Mesh& mesh, const ArcGraph& skeleton, const PerFan<VertexCode>& codes) {
  std::vector<std::uint32_t> vertices;
  for (const FanId node : skeleton.nodes) {
    if (!codes[node].extraordinary() && !mesh.is_boundary(node)) vertices.push_back(mesh.vertex(node).value);
  }
  std::sort(vertices.begin(), vertices.end());
  Packer packer;
  packer.add_list(vertices);
  return packer;
}

Packer seams_of(const Mesh& mesh) {
  std::vector<std::uint32_t> ends;
  for (const Seam& seam : mesh.seams()) {
    ends.push_back(seam.from.value);
    ends.push_back(seam.to.value);
  }
  Packer packer;
  packer.add_list(ends);
  return packer;
}

/// 0 object, 1 group, 2 material; none for records of other kinds.
std::optional<std::uint32_t> kind_of(const std::string& keyword) {
  if (keyword == "o") return 0;
  if (keyword == "g") return 1;
  if (keyword == "usemtl") return 2;
  return std::nullopt;
}

/// From which face on which name holds, as what.
Packer records_of(const MeshFile& file, std::vector<std::string>& names) {
  std::map<std::string, std::uint32_t> number_of;
  Packer packer;
  std::uint32_t before = 0;
  for (const FaceRecord& record : file.face_records) {
    const std::optional<std::uint32_t> kind = kind_of(record.keyword);
    if (!kind) continue;
    const auto [place, is_new] = number_of.emplace(record.value, static_cast<std::uint32_t>(names.size()));
    if (is_new) names.push_back(record.value);
    packer.add_step(before, record.first_face);
    packer.add(*kind);
    packer.add(place->second);
    before = record.first_face;
  }
  return packer;
}

}  // namespace

MeshHeader add_mesh(Blocks& blocks, const std::string& side, const MeshFile& file) {
  const Mesh& mesh = file.mesh;
  MeshHeader header{.path = file.path,
                    .vertices = mesh.vertex_count(),
                    .faces = mesh.face_count(),
                    .corners = mesh.halfedge_count(),
                    .all_quads = mesh.all_quads()};
  if (!mesh.positions().empty()) measure(mesh, header);
  const PerFan<VertexCode> codes = vertex_codes(mesh);
  const Tracing tracing = trace_skeleton(mesh, codes);
  blocks.add(side + ".positions", positions_of(mesh, header));
  blocks.add(side + ".sizes", sizes_of(mesh));
  blocks.add(side + ".corners", corners_of(mesh, header));
  blocks.add(side + ".skeleton", lines_of(mesh, tracing.separatrices));
  blocks.add(side + ".extraordinary", extraordinary_of(mesh, codes));
  blocks.add(side + ".crossings", crossings_of(mesh, tracing.skeleton, codes));
  blocks.add(side + ".seams", seams_of(mesh));
  blocks.add(side + ".records", records_of(file, header.names));
  return header;
}

}  // namespace quadmatch::report
