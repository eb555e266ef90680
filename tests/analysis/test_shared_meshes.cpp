// The real meshes, where their collection stands beside the project.

#include <algorithm>
#include <filesystem>

#include <quadmatch/analysis/connectivity_hash.hpp>
#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/verify/verify.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

namespace fs = std::filesystem;

/// All meshes of the collection, in order; empty, and said so, where there is none.
std::vector<fs::path> collection() {
  const fs::path folder = QUADMATCH_SHARED_MESHES;
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) {
    MESSAGE("skipped: no collection of meshes at " << folder.string());
    return files;
  }
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.path().extension() == ".obj") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  CHECK_FALSE(files.empty());
  return files;
}

PolygonSoup soup_of(const Mesh& mesh) {
  PolygonSoup soup;
  soup.vertex_count = mesh.vertex_count();
  soup.corners.assign(mesh.corners().begin(), mesh.corners().end());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) soup.face_starts.push_back(mesh.first(FaceId(f)).value);
  soup.face_starts.push_back(mesh.halfedge_count());
  return soup;
}

Mesh read(const fs::path& path) {
  Expected<MeshFile> file = read_mesh(path.string());
  REQUIRE_MESSAGE(file.has_value(), path.string());
  return std::move(file->mesh);
}

TEST_CASE("isomorphism, hash: every real mesh is the same as its renumbered self") {
  for (const fs::path& path : collection()) {
    CAPTURE(path.string());
    const Mesh mesh = read(path);
    const Mesh copy = test::build(shapes::renumbered(soup_of(mesh), 1).soup);
    const IsomorphismResult result = find_isomorphism(mesh, copy, IsomorphismKind::Preserving);
    REQUIRE(result.isomorphism.has_value());
    CHECK(verify(mesh, copy, result.isomorphism->match).sound());
    CHECK(result.isomorphism->match.matched_faces() == mesh.face_count());
    CHECK(connectivity_hash(copy) == connectivity_hash(mesh));
  }
}

TEST_CASE("isomorphism, hash: two real meshes with the same hash are isomorphic, two with different ones are not") {
  std::vector<Mesh> meshes;
  std::vector<Digest> hashes;
  for (const fs::path& path : collection()) {
    meshes.push_back(read(path));
    hashes.push_back(connectivity_hash(meshes.back()).unoriented());
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CHECK(find_isomorphism(meshes[i], meshes[j]).isomorphism.has_value() == (hashes[i] == hashes[j]));
    }
  }
}

}  // namespace
}  // namespace quadmatch
