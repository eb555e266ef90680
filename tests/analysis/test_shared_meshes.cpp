// The real meshes, where their collection stands beside the project.

#include <algorithm>
#include <filesystem>
#include <set>

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

TEST_CASE("isomorphism, hash: every real mesh is its renumbered self by both, and by the hash no other") {
  std::set<Digest> met;
  std::size_t meshes = 0;
  for (const fs::path& path : collection()) {
    CAPTURE(path.string());
    Expected<MeshFile> file = read_mesh(path.string());
    REQUIRE(file.has_value());
    const Mesh& mesh = file->mesh;
    const Mesh copy = test::build(shapes::renumbered(soup_of(mesh), 1).soup);
    const IsomorphismResult result = find_isomorphism(mesh, copy, IsomorphismKind::Preserving);
    REQUIRE(result.isomorphism.has_value());
    CHECK(verify(mesh, copy, result.isomorphism->match).sound());
    CHECK(result.isomorphism->match.matched_faces() == mesh.face_count());
    const ConnectivityHash hash = connectivity_hash(mesh);
    CHECK(connectivity_hash(copy) == hash);
    met.insert(hash.unoriented());
    ++meshes;
  }
  // Left and right shoe are mirror images, one body stands in the collection in several poses; the rest are different.
  CHECK(met.size() <= meshes);
}

}  // namespace
}  // namespace quadmatch
