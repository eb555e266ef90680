// A pipeline of oneTBB: files come in by path, are read beside each other, and are kept in the order they came in, some
// hundreds at a time.

#include "fill_library.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <filesystem>
#include <new>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <quadmatch/io/read_mesh.hpp>

#include "console.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

using Clock = std::chrono::steady_clock;

/// Meshes in a transaction: a commit waits for the disk, and a killed run loses one.
constexpr std::size_t kTogether = 250;

struct Work {
  const FoundFile* file = nullptr;
  bool known = false;  ///< the library has it as it was before
};

/// All that the library keeps of a file; its number comes later.
LibraryMesh examined(const std::string& folder, const FoundFile& found) {
  LibraryMesh mesh{.file = found};
  try {
    const Expected<MeshFile> file = read_mesh((std::filesystem::path(folder) / found.path).string());
    if (!file) {
      // The path stands beside it; what is left names the line, if there is one.
      mesh.error = file.error().line == 0 ? file.error().message
                                          : fmt::format("line {}: {}", file.error().line, file.error().message);
      return mesh;
    }
    mesh.vertices = file->mesh.vertex_count();
    mesh.faces = file->mesh.face_count();
    mesh.signature = signature_of(file->mesh, LibraryStore::kValues);
  } catch (const std::bad_alloc&) {
    mesh.error = "there is not enough memory for this mesh";
  }
  return mesh;
}

/// The files to read, and the count of those that are as they were.
Expected<std::vector<Work>> files_to_read(LibraryStore& store, const FoundFiles& files, const FillOptions& options,
                                          FillCounts& counts) {
  std::vector<Work> to_read;
  for (const FoundFile& file : files.meshes) {
    const Expected<std::optional<LibraryMesh>> kept = store.find(file.path);
    if (!kept) return Unexpected(kept.error());
    const bool same = *kept && (*kept)->file.size == file.size && (*kept)->file.modified == file.modified;
    if (same && !options.anew) {
      ++counts.unchanged;
    } else {
      to_read.push_back({&file, kept->has_value()});
    }
  }
  return to_read;
}

/// Forget what the folder has no longer.
Expected<void> remove_gone(LibraryStore& store, const FoundFiles& files, FillCounts& counts) {
  const Expected<std::vector<std::string>> paths = store.paths();
  if (!paths) return Unexpected(paths.error());
  if (Expected<void> begun = store.begin(); !begun) return begun;
  for (const std::string& path : *paths) {
    const auto place =
        std::lower_bound(files.meshes.begin(), files.meshes.end(), path,
                         [](const FoundFile& file, const std::string& name) { return file.path < name; });
    if (place != files.meshes.end() && place->path == path) continue;
    if (Expected<void> removed = store.remove(path); !removed) return removed;
    ++counts.removed;
  }
  return store.commit();
}

/// Keeps meshes, some hundreds in a transaction.
class Keeper {
 public:
  Keeper(LibraryStore& store, const std::vector<Work>& work, FillCounts& counts, bool quiet)
      : store_(&store), work_(&work), counts_(&counts), progress_(!quiet) {}

  [[nodiscard]] bool stopped() const { return stop_; }
  [[nodiscard]] const Expected<void>& outcome() const { return outcome_; }

  void keep(const LibraryMesh& mesh) {
    if (stop_) return;
    if (done_ % kTogether == 0) check(store_->begin());
    if (!stop_) check(store_->record(mesh));
    if (stop_) return;
    count(mesh, (*work_)[done_].known);
    ++done_;
    if (done_ % kTogether == 0 || done_ == work_->size()) check(store_->commit());
    if (progress_.visible()) progress_.line(progress_text());
  }

 private:
  void check(const Expected<void>& done) {
    if (done) return;
    outcome_ = done;
    stop_ = true;
  }

  void count(const LibraryMesh& mesh, bool known) {
    counts_->added += known ? 0 : 1;
    counts_->changed += known ? 1 : 0;
    if (!mesh.error) return;
    if (counts_->broken == 0) counts_->first_broken = fmt::format("{}: {}", mesh.file.path, *mesh.error);
    ++counts_->broken;
  }

  [[nodiscard]] std::string progress_text() const {
    const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
    const double rate = static_cast<double>(done_) / std::max(seconds, 1e-3);
    return fmt::format("{} of {} read; {:.0f} files/s, {:.0f} s left", grouped(done_),
                       counted(work_->size(), "new or changed file"), rate,
                       static_cast<double>(work_->size() - done_) / rate);
  }

  LibraryStore* store_;
  const std::vector<Work>* work_;
  FillCounts* counts_;
  Progress progress_;
  Expected<void> outcome_;
  std::atomic<bool> stop_ = false;
  std::size_t done_ = 0;
  Clock::time_point began_ = Clock::now();
};

}  // namespace

Expected<FillCounts> fill_library(LibraryStore& store, const FoundFiles& files, const FillOptions& options) {
  FillCounts counts;
  if (Expected<void> removed = remove_gone(store, files, counts); !removed) return Unexpected(removed.error());
  const Expected<std::vector<Work>> work = files_to_read(store, files, options, counts);
  if (!work) return Unexpected(work.error());
  Keeper keeper(store, *work, counts, options.quiet);
  std::size_t next = 0;
  const auto take = [&](tbb::flow_control& flow) -> std::size_t {
    if (next < work->size() && !keeper.stopped()) return next++;
    flow.stop();
    return 0;
  };
  const auto read = [&](std::size_t k) { return examined(store.folder(), *(*work)[k].file); };
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, options.threads);
  tbb::task_arena arena(static_cast<int>(options.threads));
  arena.execute([&] {
    tbb::parallel_pipeline(
        options.threads, tbb::make_filter<void, std::size_t>(tbb::filter_mode::serial_in_order, take) &
                             tbb::make_filter<std::size_t, LibraryMesh>(tbb::filter_mode::parallel, read) &
                             tbb::make_filter<LibraryMesh, void>(tbb::filter_mode::serial_in_order,
                                                                 [&](const LibraryMesh& mesh) { keeper.keep(mesh); }));
  });
  if (!keeper.outcome()) return Unexpected(keeper.outcome().error());
  return counts;
}

}  // namespace quadmatch::cli
