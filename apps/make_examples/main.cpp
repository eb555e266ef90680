// make_examples FOLDER: write the models that the project ships.

#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>

#include <quadmatch/io/write_mesh.hpp>

#include "examples.hpp"

namespace {

constexpr int kTrouble = 2;

int write_all(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem) {
    std::fprintf(stderr, "%s: cannot make the folder: %s\n", folder.c_str(), problem.message().c_str());
    return kTrouble;
  }
  for (const quadmatch::Example& example : quadmatch::make_examples()) {
    const std::string path = (folder / example.name).string();
    if (const auto written = quadmatch::write_mesh(path, example.file); !written) {
      std::fprintf(stderr, "%s\n", written.error().describe().c_str());
      return kTrouble;
    }
    std::printf("%s: %u vertices, %u faces\n", path.c_str(), example.file.mesh.vertex_count(),
                example.file.mesh.face_count());
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Write quadmatch's example models, the same bytes every time", "make_examples");
  std::string folder;
  app.add_option("FOLDER", folder, "where they go; made if it is missing")->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : kTrouble;
  }
  return write_all(folder);
}
