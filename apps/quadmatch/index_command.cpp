// quadmatch index FOLDER -o LIBRARY: the signatures of a folder's meshes, for `find`.

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <thread>

#include <malloc.h>

#include <fmt/format.h>

#include "command.hpp"
#include "console.hpp"
#include "json.hpp"
#include "library/fill_library.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(Meshes are the files ending in .obj, .ply, .off and .usda, in the folder and all folders
in it; other files are counted and left alone. A mesh that cannot be read is kept with the
reason and does not stop the rest: it is read again when its file changes.

The same command brings a library up to date: files of another size or time are read
again, those that are gone are forgotten. It may be killed whenever you like and goes on
where it was. A library belongs to one folder.

Examples:
  quadmatch index models -o models.sqlite
  quadmatch find chair.obj models.sqlite
  sqlite3 models.sqlite "SELECT path, error FROM meshes WHERE error IS NOT NULL"

Exit status: 0 all meshes are in the library; 1 some cannot be read; 2 trouble, run it again.)";

struct IndexArguments {
  std::string folder, library;
  std::uint32_t threads = 0;
  bool anew = false;
  bool json = false;
  bool quiet = false;
};

/// What there is to say in the end.
struct IndexReport {
  FillCounts counts;
  std::int64_t meshes = 0, broken = 0;
  std::uint64_t others = 0, closed = 0, bytes = 0;
  double milliseconds = 0;
};

/// A whole path without links, so that a library knows its folder however it is named.
Expected<std::string> whole_path(const std::string& folder) {
  std::error_code failed;
  const std::filesystem::path path = std::filesystem::canonical(folder, failed);
  if (!failed) return path.string();
  return Unexpected(Error{ErrorCode::CannotRead,
                          fmt::format("cannot be indexed: {}; name a folder of meshes", failed.message()), folder});
}

/// A disk that is not mounted looks like an empty folder; a library is not emptied for that.
Expected<void> refuse_empty(LibraryStore& store, const FoundFiles& files) {
  if (!files.meshes.empty()) return {};
  const Expected<std::int64_t> meshes = store.mesh_count();
  if (!meshes) return Unexpected(meshes.error());
  if (*meshes == 0) return {};
  return Unexpected(Error{ErrorCode::CannotRead,
                          fmt::format("there is no mesh in this folder now, but {} in the library; see that the disk "
                                      "is there, or remove the library",
                                      counted(static_cast<std::uint64_t>(*meshes), "mesh", "meshes")),
                          store.folder()});
}

Expected<IndexReport> index_folder(const IndexArguments& arguments) {
  Stopwatch stopwatch;
  IndexReport report;
  const Expected<std::string> folder = whole_path(arguments.folder);
  if (!folder) return Unexpected(folder.error());
  const Expected<FoundFiles> files = find_mesh_files(*folder);
  if (!files) return Unexpected(files.error());
  const Expected<std::unique_ptr<LibraryStore>> store = LibraryStore::open(arguments.library, *folder);
  if (!store) return Unexpected(store.error());
  if (Expected<void> sound = refuse_empty(**store, *files); !sound) return Unexpected(sound.error());
  const FillOptions options{
      .threads = arguments.threads != 0 ? arguments.threads : std::max(1U, std::thread::hardware_concurrency()),
      .anew = arguments.anew,
      .quiet = arguments.quiet};
  const Expected<FillCounts> counts = fill_library(**store, *files, options);
  if (!counts) return Unexpected(counts.error());
  const Expected<std::int64_t> meshes = (*store)->mesh_count();
  if (!meshes) return Unexpected(meshes.error());
  const Expected<std::int64_t> broken = (*store)->broken_count();
  if (!broken) return Unexpected(broken.error());
  std::error_code unknown;
  report = {
      *counts, *meshes, *broken, files->others, files->closed, std::filesystem::file_size(arguments.library, unknown),
      0};
  report.milliseconds = stopwatch.lap();
  return report;
}

std::string as_text(const IndexArguments& arguments, const IndexReport& report) {
  const FillCounts& counts = report.counts;
  Lines lines;
  lines.add("meshes", fmt::format("{} in the library", grouped(static_cast<std::uint64_t>(report.meshes))));
  lines.add("files", fmt::format("{} added, {} changed, {} unchanged, {} gone", grouped(counts.added),
                                 grouped(counts.changed), grouped(counts.unchanged), grouped(counts.removed)));
  if (report.others > 0) lines.add("no meshes", counted(report.others, "other file"));
  if (report.closed > 0) lines.add("closed", counted(report.closed, "file or folder", "files or folders"));
  if (report.broken > 0) {
    lines.add("broken",
              fmt::format("{} cannot be read", counted(static_cast<std::uint64_t>(report.broken), "mesh", "meshes")));
  }
  if (counts.broken > 0) lines.add("", counts.first_broken);
  lines.add("time", duration(report.milliseconds));
  const std::uint64_t rows = static_cast<std::uint64_t>(report.meshes + report.broken);
  lines.add("written", fmt::format("{}: {}, {} a mesh", arguments.library, byte_size(report.bytes),
                                   byte_size(rows == 0 ? 0 : report.bytes / rows)));
  return lines.render();
}

std::string as_json(const IndexArguments& arguments, const IndexReport& report) {
  return json_text({{"library", arguments.library},
                    {"meshes", report.meshes},
                    {"broken", report.broken},
                    {"added", report.counts.added},
                    {"changed", report.counts.changed},
                    {"unchanged", report.counts.unchanged},
                    {"gone", report.counts.removed},
                    {"other_files", report.others},
                    {"closed", report.closed},
                    {"bytes", report.bytes},
                    {"milliseconds", rounded(report.milliseconds)}});
}

int run_index(const IndexArguments& arguments) {
  ::mallopt(M_TRIM_THRESHOLD, 1 << 18);  // threads give back what a large mesh needed
  const Expected<IndexReport> report = index_folder(arguments);
  if (!report) return complain(report.error());
  if (arguments.json && !print(as_json(arguments, *report))) return kTrouble;
  if (!arguments.json && !arguments.quiet && !print(as_text(arguments, *report))) return kTrouble;
  return report->broken > 0 || report->closed > 0 ? kDifferent : kSame;
}

}  // namespace

void add_index_command(CLI::App& program, Action& chosen) {
  IndexArguments* arguments = nullptr;
  CLI::App* const verb = add_verb(program, "index", "Make a library of a folder's meshes, or bring it up to date",
                                  arguments, run_index, chosen);
  verb->footer(kFooter);
  verb->add_option("FOLDER", arguments->folder, "Folder of meshes, and of folders of them")
      ->required()
      ->type_name("FOLDER");
  verb->add_option("-o,--output", arguments->library, "Library to make, or to bring up to date (a SQLite database)")
      ->required()
      ->type_name("FILE");
  verb->add_option("--threads", arguments->threads, "Files at a time; 0: as many as there are processors")
      ->type_name("N")
      ->check(CLI::Range(0U, 4096U).description(""))
      ->capture_default_str();
  verb->add_flag("--anew", arguments->anew, "Read unchanged files too");
  verb->add_flag("--json", arguments->json, "Print the counts as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print neither summary nor progress");
}

}  // namespace quadmatch::cli
