// quadmatch find MESH LIBRARY: which meshes of a library share connectivity with a mesh, and how much of it.

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>

#include <fmt/format.h>

#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/match/matcher.hpp>

#include "command.hpp"
#include "console.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "library/relatives.hpp"
#include "matching.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(Signatures of what lies around extraordinary vertices name the meshes that have most in
common with this one; these are then matched with it, and stand in the order of how much
of both is the same. Neither numbering nor positions count, and a mirror image is found too.

Examples:
  quadmatch find chair.obj models.sqlite      after quadmatch index models -o models.sqlite
  quadmatch find chair.obj models.sqlite --no-match --top 100    in milliseconds, by signatures

Exit status: 0 there are relatives; 1 there are none; 2 trouble.)";

struct FindArguments {
  std::string mesh, library;
  std::uint32_t top = 5;
  bool no_match = false;
  bool json = false;
  bool quiet = false;
};

/// A mesh of the library beside the one it is compared with.
struct Found {
  Relative relative;
  std::optional<std::uint32_t> matched = {};  ///< faces; none where the two were not matched
  std::uint32_t faces = 0;                    ///< of the other, as it is now
  std::string note = {};                      ///< why they were not

  [[nodiscard]] bool related() const { return matched ? *matched > 0 : relative.weight > 0; }
};

struct FindReport {
  std::uint32_t faces = 0;
  std::int64_t meshes = 0;  ///< in the library
  std::string folder;
  std::vector<Found> found;
  double reading = 0, ranking = 0, matching = 0;  ///< milliseconds
};

/// Of all faces of both, what share is the same.
double same_share(const Found& found, std::uint32_t faces) {
  const double same = found.matched.value_or(0);
  return same / (static_cast<double>(faces) + found.faces - same);
}

/// Match the mesh with one of the library. Where it cannot be, `note` says why.
Expected<void> match_with(const Mesh& mesh, const std::string& path, Found& found) {
  const Expected<MeshFile> other = read_mesh(path);
  if (!other) {
    std::error_code unknown;
    found.note = std::filesystem::exists(path, unknown) ? other.error().message : "the file is gone";
    return {};
  }
  const Match same = match(mesh, other->mesh).match;
  if (Expected<void> sound = check_sound(mesh, other->mesh, same); !sound) return sound;
  found.matched = static_cast<std::uint32_t>(same.matched_faces());
  found.faces = other->mesh.face_count();
  return {};
}

/// Match all that were found, and put those in the lead that have most in common. What cannot be matched follows.
Expected<void> match_found(const Mesh& mesh, const LibraryStore& store, bool quiet, std::vector<Found>& found) {
  Progress progress(!quiet);
  for (Found& each : found) {
    const std::string path = (std::filesystem::path(store.folder()) / each.relative.mesh.file.path).string();
    progress.stage("matching " + path);
    if (Expected<void> done = match_with(mesh, path, each); !done) return done;
  }
  const std::uint32_t faces = mesh.face_count();
  std::stable_sort(found.begin(), found.end(), [faces](const Found& one, const Found& other) {
    return std::tuple(one.matched.has_value(), same_share(one, faces)) >
           std::tuple(other.matched.has_value(), same_share(other, faces));
  });
  return {};
}

Expected<FindReport> find_in_library(const FindArguments& arguments, const Mesh& mesh, FindReport report) {
  Stopwatch stopwatch;
  const Expected<std::unique_ptr<LibraryStore>> store = LibraryStore::open_to_read(arguments.library);
  if (!store) return Unexpected(store.error());
  const Expected<std::int64_t> meshes = (*store)->mesh_count();
  if (!meshes) return Unexpected(meshes.error());
  const Signature asked = signature_of(mesh, kAskedValues);
  Expected<std::vector<Relative>> relatives = find_relatives(**store, asked, mesh.face_count(), arguments.top);
  if (!relatives) return Unexpected(relatives.error());
  for (Relative& relative : *relatives) {
    const std::uint32_t faces = relative.mesh.faces;
    report.found.push_back({.relative = std::move(relative), .faces = faces});
  }
  report.ranking = stopwatch.lap();
  if (!arguments.no_match) {
    if (Expected<void> done = match_found(mesh, **store, arguments.quiet, report.found); !done) {
      return Unexpected(done.error());
    }
  }
  std::erase_if(report.found, [](const Found& each) { return !each.related() && each.note.empty(); });
  report.matching = stopwatch.lap();
  report.faces = mesh.face_count();
  report.meshes = *meshes;
  report.folder = (*store)->folder();
  return report;
}

std::string share_text(double share) { return fmt::format("{:.1f} %", 100 * share); }

std::string as_text(const FindArguments& arguments, const FindReport& report) {
  if (report.found.empty()) {
    return fmt::format("none of {} in {} has anything in common with {}\n",
                       counted(static_cast<std::uint64_t>(report.meshes), "mesh", "meshes"), arguments.library,
                       display_name(arguments.mesh));
  }
  std::vector<std::vector<std::string>> rows{{"mesh", "faces", "signature", "of this", "of that", ""}};
  for (const Found& each : report.found) {
    const Relative& relative = each.relative;
    rows.push_back({(std::filesystem::path(report.folder) / relative.mesh.file.path).string(), grouped(each.faces),
                    share_text(relative.common), each.matched ? percent(*each.matched, report.faces) : "-",
                    each.matched ? percent(*each.matched, each.faces) : "-", each.note});
  }
  if (std::all_of(report.found.begin(), report.found.end(), [](const Found& each) { return each.note.empty(); })) {
    for (std::vector<std::string>& row : rows) row.pop_back();
  }
  return table(rows);
}

Json as_json(const Found& each, std::size_t rank, const FindReport& report) {
  const Relative& relative = each.relative;
  Json row{{"rank", rank},
           {"path", (std::filesystem::path(report.folder) / relative.mesh.file.path).string()},
           {"faces", each.faces},
           {"signature", {{"common", relative.common}, {"of_this", relative.of_this}, {"of_that", relative.of_other}}}};
  row["matched_faces"] = each.matched ? Json(*each.matched) : Json();
  row["of_this"] = each.matched ? Json(static_cast<double>(*each.matched) / report.faces) : Json();
  row["of_that"] = each.matched ? Json(static_cast<double>(*each.matched) / each.faces) : Json();
  row["note"] = each.note.empty() ? Json() : Json(each.note);
  return row;
}

std::string as_json(const FindArguments& arguments, const FindReport& report) {
  Json found = Json::array();
  for (const Found& each : report.found) found.push_back(as_json(each, found.size() + 1, report));
  return json_text({{"mesh", arguments.mesh},
                    {"faces", report.faces},
                    {"library", arguments.library},
                    {"meshes", report.meshes},
                    {"found", found},
                    {"milliseconds",
                     {{"reading", rounded(report.reading)},
                      {"ranking", rounded(report.ranking)},
                      {"matching", rounded(report.matching)}}}});
}

int run_find(const FindArguments& arguments) {
  Stopwatch stopwatch;
  const std::optional<MeshFile> file = read_input(arguments.mesh, !arguments.quiet);
  if (!file) return kTrouble;
  FindReport read;
  read.reading = stopwatch.lap();
  const Expected<FindReport> report = find_in_library(arguments, file->mesh, read);
  if (!report) return complain(report.error());
  if (arguments.json && !print(as_json(arguments, *report))) return kTrouble;
  if (!arguments.json && !arguments.quiet && !print(as_text(arguments, *report))) return kTrouble;
  return report->found.empty() ? kDifferent : kSame;
}

}  // namespace

void add_find_command(CLI::App& program, Action& chosen) {
  FindArguments* arguments = nullptr;
  CLI::App* const verb = add_verb(program, "find", "Find the meshes of a library that share connectivity with a mesh",
                                  arguments, run_find, chosen);
  verb->footer(kFooter);
  verb->add_option("MESH", arguments->mesh, "Mesh; - reads standard input")->required()->type_name("FILE");
  verb->add_option("LIBRARY", arguments->library, "Library that quadmatch index made")->required()->type_name("FILE");
  verb->add_option("--top", arguments->top, "How many meshes are named, and matched with this one")
      ->type_name("N")
      ->check(CLI::Range(1U, 100000U).description(""))
      ->capture_default_str();
  verb->add_flag("--no-match", arguments->no_match, "Compare signatures only: milliseconds, and estimates");
  verb->add_flag("--json", arguments->json, "Print what was found as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print neither table nor warnings");
}

}  // namespace quadmatch::cli
