#include "pair_files.hpp"

#include <filesystem>
#include <map>
#include <system_error>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/write_mesh.hpp>

namespace quadmatch {
namespace {

std::vector<VertexPair> vertex_map(const Pair& pair) {
  std::map<VertexId, VertexId> images;
  for (const FacePair& faces : pair.region) {
    for (std::uint32_t corner = 0; corner < 4; ++corner) {
      const std::uint32_t image = image_corner(Orientation::Preserving, faces.rotation, corner, 4);
      images.emplace(pair.source.corners[4 * faces.source.value + corner],
                     pair.target.corners[4 * faces.target.value + image]);
    }
  }
  std::vector<VertexPair> vertices;
  for (const auto& [source, target] : images) vertices.push_back({source, target});
  return vertices;
}

}  // namespace

Expected<void> write_pair(const std::string& folder, const std::string& name, const Pair& pair) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) return Unexpected(Error{ErrorCode::CannotWrite, problem.message(), folder});
  MatchFile match;
  for (const bool is_source : {true, false}) {
    const PolygonSoup& soup = is_source ? pair.source : pair.target;
    const std::string file = name + (is_source ? "-source.obj" : "-target.obj");
    Expected<Mesh> mesh = Mesh::build(soup);
    if (!mesh) return Unexpected(mesh.error());
    (is_source ? match.source : match.target) = {file, mesh->vertex_count(), mesh->face_count()};
    const std::string path = (std::filesystem::path(folder) / file).string();
    if (Expected<void> written = write_mesh(path, {.mesh = *std::move(mesh)}); !written) return written;
  }
  if (pair.region.empty()) return {};
  match.match.regions.push_back({.faces = pair.region});
  match.match.vertices = vertex_map(pair);
  return write_match((std::filesystem::path(folder) / (name + "-match.json")).string(), match);
}

}  // namespace quadmatch
