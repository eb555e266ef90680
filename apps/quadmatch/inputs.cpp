#include "inputs.hpp"

#include <algorithm>
#include <filesystem>
#include <future>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/io/read_mesh.hpp>

#include "console.hpp"

namespace quadmatch::cli {

namespace {

/// The mesh, or a complaint.
std::optional<MeshFile> accepted(Expected<MeshFile> file, bool remarks) {
  if (!file) {
    complain(file.error());
    return std::nullopt;
  }
  if (remarks) {
    for (const std::string& note : file->notes) warn(fmt::format("{}: {}", display_name(file->path), note));
  }
  return *std::move(file);
}

}  // namespace

std::optional<MeshFile> read_input(const std::string& path, bool remarks) { return accepted(read_mesh(path), remarks); }

std::optional<InputPair> read_inputs(const std::string& source, const std::string& target, bool remarks,
                                     std::uint32_t threads) {
  if (threads == 0) threads = std::thread::hardware_concurrency();
  const std::launch when = threads > 1 ? std::launch::async : std::launch::deferred;
  std::future<Expected<MeshFile>> other = std::async(when, [&] { return read_mesh(target); });
  std::optional<MeshFile> first = accepted(read_mesh(source), remarks);
  if (!first) return std::nullopt;
  std::optional<MeshFile> second = accepted(other.get(), remarks);
  if (!second) return std::nullopt;
  return InputPair{*std::move(first), *std::move(second)};
}

bool paths_fit(const std::vector<std::string>& inputs, const std::string& output, const char* option) {
  if (std::count(inputs.begin(), inputs.end(), "-") > 1) {
    complain("standard input (-) can be read only once; write one of the meshes to a file");
    return false;
  }
  if (output.empty() || output == "-") return true;
  for (const std::string& input : inputs) {
    std::error_code missing;  // then it is not the same file
    if (input == "-" || !std::filesystem::equivalent(input, output, missing)) continue;
    complain(fmt::format("{}: this is an input and would be overwritten; choose another name for {}", output, option));
    return false;
  }
  return true;
}

bool same_file(const std::string& a, const std::string& b) {
  namespace fs = std::filesystem;
  std::error_code failure;  // then the names differ, or writing will say what is wrong
  return fs::weakly_canonical(fs::absolute(a), failure) == fs::weakly_canonical(fs::absolute(b), failure) && !failure;
}

}  // namespace quadmatch::cli
