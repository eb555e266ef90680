#pragma once
/// Reading from text in tests, and comparing what was read.

#include <doctest/doctest.h>

#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>

namespace quadmatch::test {

/// The mesh in a text that must be in order.
inline MeshFile parsed(std::string_view text, Format format) {
  Expected<MeshFile> file = parse_mesh(text, "mesh", format);
  if (!file) FAIL(file.error().describe());
  return std::move(*file);
}

/// The error in a text that must not be in order.
inline Error error_of(std::string_view text, Format format) {
  const Expected<MeshFile> file = parse_mesh(text, "mesh", format);
  REQUIRE_FALSE(file.has_value());
  return file.error();
}

inline std::string complaint(std::string_view text, Format format) { return error_of(text, format).describe(); }

/// The vertices of a face, counted from 0.
inline std::vector<std::uint32_t> face(const MeshFile& file, std::uint32_t number) {
  std::vector<std::uint32_t> vertices;
  for (const HalfedgeId h : file.mesh.halfedges(FaceId(number))) vertices.push_back(file.mesh.origin(h).value);
  return vertices;
}

using Corners = std::vector<std::uint32_t>;

/// Same vertices, faces and positions, bit by bit.
inline void check_same_mesh(const Mesh& one, const Mesh& other) {
  CHECK(one.vertex_count() == other.vertex_count());
  REQUIRE(one.face_count() == other.face_count());
  REQUIRE(one.halfedge_count() == other.halfedge_count());
  for (std::uint32_t f = 0; f < one.face_count(); ++f) CHECK(one.size(FaceId(f)) == other.size(FaceId(f)));
  CHECK(std::equal(one.corners().begin(), one.corners().end(), other.corners().begin()));
  REQUIRE(one.positions().size() == other.positions().size());
  CHECK(std::equal(one.positions().begin(), one.positions().end(), other.positions().begin()));
}

inline const Property* find_property(const MeshFile& file, std::string_view name) {
  for (const Property& property : file.properties) {
    if (property.name == name) return &property;
  }
  return nullptr;
}

/// Two quads side by side, as OBJ with every kind of record.
inline constexpr std::string_view kFullObj =
    "# two quads\n"
    "mtllib skin.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0.1\nv 2 1 1e-3\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "vn 0 0 1\n"
    "o body\n"
    "g left arm\n"
    "usemtl skin\n"
    "s 1\n"
    "f 1/1/1 2/2/1 3/3/1 4/4/1\n"
    "l 1 2 3\n"
    "s off\n"
    "f 2//1 5 6/3 3\n"
    "p 6\n"
    "o empty\n";

/// The same two quads in the other formats, with what those can carry.
inline constexpr std::string_view kPly =
    "ply\nformat ascii 1.0\ncomment two quads\nobj_info by hand\n"
    "element vertex 6\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"
    "element face 2\nproperty list uchar int vertex_indices\nproperty short part\nproperty list uchar float texcoord\n"
    "element edge 1\nproperty int vertex1\nproperty int vertex2\nproperty list uchar double weights\n"
    "end_header\n"
    "0 0 0 0\n1 0 0 10\n1 1 0 20\n0 1 0 30\n2 0 0.1 40\n2 1 1e-3 255\n"
    "4 0 1 2 3 -7 8 0 0 1 0 1 1 0 1\n4 1 4 5 2 300 0\n"
    "0 1 2 0.25 1e300\n";

inline constexpr std::string_view kOff =
    "OFF\n# two quads\n6 2 7\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0.1\n2 1 1e-3\n4 0 1 2 3\n4 1 4 5 2\n";

inline constexpr std::string_view kUsda =
    "#usda 1.0\n(\n    defaultPrim = \"model\"\n    doc = \"\"\"two\nquads\"\"\"\n)\n\n"
    "def Xform \"model\" (\n    prepend apiSchemas = [\"Foo\"]\n)\n{\n"
    "    double3 xformOp:translate = (1, 2, 3)\n"
    "    uniform token[] xformOpOrder = [\"xformOp:translate\"]\n"
    "    def Mesh \"body\"\n    {\n"
    "        float3[] extent = [(0, 0, 0), (2, 1, 0.1)]\n"
    "        int[] faceVertexCounts = [4, 4]\n"
    "        int[] faceVertexIndices = [0, 1, 2, 3, 1, 4, 5, 2]\n"
    "        point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (2, 0, 0.1), (2, 1, 1e-3)]\n"
    "        texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (\n"
    "            interpolation = \"faceVarying\"\n        )\n"
    "        int[] primvars:st:indices = [0, 1, 2, 3, 0, 1, 2, 3]\n"
    "        normal3f[] normals = [(0, 0, 1), (0, 0, 1), (0, 0, 1), (0, 0, 1), (0, 0, 1), (0, 0, 1)]\n"
    "        rel material:binding = </model/Skin>\n"
    "    }\n}\n";

inline constexpr std::string_view kMatch =
    "{\"format\": \"quadmatch.match/1\",\n"
    " \"source\": {\"path\": \"a.obj\", \"vertices\": 1070, \"faces\": 1042},\n"
    " \"target\": {\"path\": \"b.obj\", \"vertices\": 1071, \"faces\": 1043},\n"
    " \"regions\": [{\"orientation\": \"preserving\", \"faces\": [[0, 17, 2], [1, 4, 0]]}],\n"
    " \"vertices\": [[0, 5], [1, 9]]}\n";

}  // namespace quadmatch::test
