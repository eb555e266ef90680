#include "inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/io/read_mesh.hpp>

#include "console.hpp"

namespace quadmatch::cli {

std::optional<MeshFile> read_input(const std::string& path, bool remarks) {
  Expected<MeshFile> file = read_mesh(path);
  if (!file) {
    complain(file.error());
    return std::nullopt;
  }
  if (remarks) {
    for (const std::string& note : file->notes) warn(fmt::format("{}: {}", display_name(path), note));
  }
  return *std::move(file);
}

bool paths_fit(const std::vector<std::string>& inputs, const std::string& output) {
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    complain("standard input (-) can be read only once; write one of the meshes to a file");
    return false;
  }
  if (output.empty() || output == "-") return true;
  for (const std::string& input : inputs) {
    std::error_code missing;  // then it is not the same file
    if (input == "-" || !std::filesystem::equivalent(input, output, missing)) continue;
    complain(fmt::format("{}: this is an input and would be overwritten; choose another name for -o", output));
    return false;
  }
  return true;
}

std::string display_name(const std::string& path) { return path == "-" ? "standard input" : path; }

}  // namespace quadmatch::cli
