// The real meshes, where their collection stands beside the project.

#include <algorithm>
#include <filesystem>

#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/verify/verify.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

namespace fs = std::filesystem;

/// All files of the collection, in order; empty, and said so, where there is none.
std::vector<fs::path> files_in(const fs::path& folder, const char* name) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) {
    MESSAGE("skipped: no collection of meshes at " << folder.string());
    return files;
  }
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const bool wanted = name != nullptr ? entry.is_directory() : entry.path().extension() == ".obj";
    if (wanted) files.push_back(name != nullptr ? entry.path() / name : entry.path());
  }
  std::sort(files.begin(), files.end());
  CHECK_FALSE(files.empty());
  return files;
}

Mesh read(const fs::path& path) {
  Expected<MeshFile> file = read_mesh(path.string());
  REQUIRE_MESSAGE(file.has_value(), path.string());
  return std::move(file->mesh);
}

void check_all_algorithms(const Mesh& source, const Mesh& target) {
  for (const Algorithm algorithm : {Algorithm::Greedy, Algorithm::LazyGreedy, Algorithm::Regions}) {
    for (const OrientationChoice orientation : {OrientationChoice::Auto, OrientationChoice::Reversing}) {
      const MatchResult result = match(source, target, {.algorithm = algorithm, .orientation = orientation});
      const Verdict verdict = verify(source, target, result.match);
      CHECK_MESSAGE(verdict.sound(), (verdict.faults.empty() ? std::string() : verdict.faults.front().message));
      CHECK(verdict.matched_faces > 0);
    }
  }
}

TEST_CASE("every real mesh has a sound match with itself, by every algorithm, either way round") {
  for (const fs::path& path : files_in(QUADMATCH_SHARED_MESHES, nullptr)) {
    CAPTURE(path.string());
    const Mesh mesh = read(path);
    check_all_algorithms(mesh, mesh);
  }
}

TEST_CASE("every real pair has a sound match, by every algorithm, either way round") {
  for (const fs::path& path : files_in(fs::path(QUADMATCH_SHARED_MESHES) / "pairs", "a.obj")) {
    CAPTURE(path.string());
    check_all_algorithms(read(path), read(path.parent_path() / "b.obj"));
  }
}

}  // namespace
}  // namespace quadmatch
