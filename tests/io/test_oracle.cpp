// tinyobjloader reads the same files: same vertices, same faces.

#include <filesystem>

#include <tiny_obj_loader.h>

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

struct Oracle {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
};

Oracle load(const std::string& path) {
  Oracle oracle;
  std::vector<tinyobj::material_t> materials;
  std::string warning, error;
  constexpr bool kTriangulate = false;
  REQUIRE(tinyobj::LoadObj(&oracle.attributes, &oracle.shapes, &materials, &warning, &error, path.c_str(), nullptr,
                           kTriangulate));
  return oracle;
}

/// Every corner of every face: its vertex and its texture coordinate.
std::vector<std::pair<int, int>> corners_of(const Oracle& oracle) {
  std::vector<std::pair<int, int>> corners;
  for (const tinyobj::shape_t& shape : oracle.shapes) {
    for (const tinyobj::index_t& index : shape.mesh.indices)
      corners.emplace_back(index.vertex_index, index.texcoord_index);
  }
  return corners;
}

std::vector<std::pair<int, int>> corners_of(const MeshFile& file) {
  std::vector<std::pair<int, int>> corners;
  for (std::uint32_t h = 0; h < file.mesh.halfedge_count(); ++h) {
    const int texture = file.texture_coordinates ? static_cast<int>(file.texture_coordinates->corner_index[h]) : -1;
    corners.emplace_back(static_cast<int>(file.mesh.origin(HalfedgeId(h)).value), texture);
  }
  return corners;
}

}  // namespace

TEST_CASE("the shared meshes are the same to tinyobjloader") {
  const std::filesystem::path folder = QUADMATCH_SHARED_MESHES;
  if (!std::filesystem::exists(folder)) {
    MESSAGE("skipped: there is no folder " << folder.string());
    return;
  }
  int compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    CAPTURE(entry.path().string());
    const Expected<MeshFile> file = read_mesh(entry.path().string());
    REQUIRE(file.has_value());
    const Oracle oracle = load(entry.path().string());
    CHECK(oracle.attributes.vertices.size() == 3 * std::size_t{file->mesh.vertex_count()});
    bool same_positions = true;
    for (std::size_t i = 0; i < oracle.attributes.vertices.size(); ++i) {
      const double difference = oracle.attributes.vertices[i] - file->mesh.positions()[i / 3][i % 3];
      same_positions = same_positions && std::abs(difference) <= 1e-9 * (1 + std::abs(oracle.attributes.vertices[i]));
    }
    CHECK(same_positions);
    CHECK(corners_of(oracle) == corners_of(*file));
    ++compared;
  }
  CHECK(compared > 0);
}
