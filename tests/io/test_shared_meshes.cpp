// Real meshes go through every format without losing a face or turning a corner.

#include <filesystem>

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

TEST_CASE("every shared mesh keeps its faces, vertices and positions in every format") {
  const std::filesystem::path folder = QUADMATCH_SHARED_MESHES;
  if (!std::filesystem::exists(folder)) {
    MESSAGE("skipped: there is no folder " << folder.string());
    return;
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    CAPTURE(entry.path().string());
    const Expected<MeshFile> file = read_mesh(entry.path().string());
    REQUIRE(file.has_value());
    for (const Format format : {Format::Obj, Format::Ply, Format::Off, Format::Usda}) {
      const std::string bytes = format_mesh(*file, format);
      const MeshFile again = parsed(bytes, format);
      check_same_mesh(file->mesh, again.mesh);
      CHECK(format_mesh(again, format) == bytes);
    }
  }
}
