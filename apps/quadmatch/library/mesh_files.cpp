#include "mesh_files.hpp"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/io/read_mesh.hpp>

namespace quadmatch::cli {
namespace {

namespace fs = std::filesystem;

/// Put a file where it belongs. @param name  as seen from the folder.
void sort_in(const fs::directory_entry& entry, std::string name, FoundFiles& found) {
  std::error_code failed;
  if (!entry.is_regular_file(failed)) {
    found.closed += failed ? 1 : 0;
    return;
  }
  if (!format_of_path(name)) {
    ++found.others;
    return;
  }
  FoundFile file{std::move(name), entry.file_size(failed)};
  if (!failed) {
    const fs::file_time_type modified = entry.last_write_time(failed);
    file.modified = std::chrono::duration_cast<std::chrono::nanoseconds>(modified.time_since_epoch()).count();
  }
  if (failed) {
    ++found.closed;
  } else {
    found.meshes.push_back(std::move(file));
  }
}

/// One folder, not what is in its folders. @param prefix  its path as seen from the first one, empty or with a slash.
void walk(const fs::path& folder, const std::string& prefix, FoundFiles& found,
          std::vector<std::pair<fs::path, std::string>>& to_walk, std::error_code& failed) {
  fs::directory_iterator entries(folder, failed);
  for (; !failed && entries != fs::directory_iterator(); entries.increment(failed)) {
    std::string name = prefix + entries->path().filename().string();
    std::error_code unknown;
    if (entries->is_directory(unknown) && !entries->is_symlink(unknown)) {
      to_walk.emplace_back(entries->path(), name + "/");
    } else {
      sort_in(*entries, std::move(name), found);
    }
  }
}

}  // namespace

Expected<FoundFiles> find_mesh_files(const std::string& folder) {
  FoundFiles found;
  std::vector<std::pair<fs::path, std::string>> to_walk;
  std::error_code failed;
  walk(folder, "", found, to_walk, failed);
  if (failed) {
    return Unexpected(Error{ErrorCode::CannotRead,
                            fmt::format("cannot be indexed: {}; name a folder of meshes", failed.message()), folder});
  }
  while (!to_walk.empty()) {
    const auto [path, prefix] = std::move(to_walk.back());
    to_walk.pop_back();
    walk(path, prefix, found, to_walk, failed);
    found.closed += failed ? 1 : 0;
  }
  std::sort(found.meshes.begin(), found.meshes.end(),
            [](const FoundFile& one, const FoundFile& other) { return one.path < other.path; });
  return found;
}

}  // namespace quadmatch::cli
