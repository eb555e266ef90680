// quadmatch merge BASE OURS THEIRS -o OUT: read, match both sides or read the matches, merge, write, report.

#include <array>
#include <future>
#include <map>
#include <thread>

#include <fmt/format.h>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/use/merge.hpp>

#include "command.hpp"
#include "console.hpp"
#include "dirt.hpp"
#include "html_report.hpp"
#include "inputs.hpp"
#include "merge_report.hpp"
#include "merge_view.hpp"
#include "picture_options.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(BASE is the mesh that OURS and THEIRS were made from. OUT is BASE with the changes of both:
faces removed, added, cut and joined, vertices moved, UVs, groups, materials and all else that
was changed. How the files are numbered does not matter.

Where both sides changed what is around the same vertex, and not in the same way, or gave the
same element two values, there is a conflict. It is named, OUT holds there what --prefer says,
and the status is 1. Everywhere else OUT has the changes of both.

OUT has the order of OURS; what is new of THEIRS follows, within its object where there are
objects. A side that changed nothing gives the other one back as it is. OUT may be one of the
inputs: it is replaced when all of it is written, or not at all.

With --report and --image BASE stands beside OUT: red is what only one of them has. The report
lists conflicts, and who removed and who added what.

As a merge driver of git, with these two lines:
  git config merge.quadmatch.driver "quadmatch merge %O %A %B -o %A --as %P"
  echo '*.obj merge=quadmatch' >> .gitattributes

Examples:
  quadmatch merge base.obj mine.obj yours.obj -o merged.obj
  quadmatch merge base.obj mine.obj yours.obj -o mine.obj --prefer theirs
  quadmatch merge base.ply a.ply b.ply -o merged.ply --json
  quadmatch merge base.obj mine.obj yours.obj -o merged.obj --report merged.html

Exit status: 0 merged; 1 merged, with conflicts; 2 trouble, nothing is written.)";

const std::map<std::string, Side> kSideNames{{"ours", Side::Ours}, {"theirs", Side::Theirs}};

struct MergeArguments {
  std::string base, ours, theirs;
  std::string output;
  std::string match_ours, match_theirs;
  std::string prefer = "ours";
  std::string as;
  std::string page;  // of the HTML report, empty: none
  PictureWishes pictures;
  bool no_positions = false;
  bool origins = false;
  std::uint32_t threads = 0;
  bool json = false;
  bool quiet = false;
};

struct Inputs {
  MeshFile base, ours, theirs;
};

std::vector<std::pair<std::string, std::string>> settings_of(const MergeArguments& arguments) {
  std::vector<std::pair<std::string, std::string>> settings{{"program", "quadmatch " QUADMATCH_VERSION},
                                                            {"prefer", arguments.prefer},
                                                            {"positions", arguments.no_positions ? "false" : "true"}};
  if (!arguments.match_ours.empty()) settings.emplace_back("match_ours", arguments.match_ours);
  if (!arguments.match_theirs.empty()) settings.emplace_back("match_theirs", arguments.match_theirs);
  return settings;
}

/// The path that tells the format of a file.
const std::string& named(const MergeArguments& arguments, const std::string& path) {
  return arguments.as.empty() ? path : arguments.as;
}

bool arguments_fit(const MergeArguments& arguments) {
  std::vector<std::string> inputs{arguments.base, arguments.ours, arguments.theirs}, matches;
  for (const std::string& match : {arguments.match_ours, arguments.match_theirs}) {
    if (!match.empty()) matches.push_back(match);
  }
  inputs.insert(inputs.end(), matches.begin(), matches.end());
  if (!paths_fit(inputs, {}) || !paths_fit(matches, arguments.output)) return false;
  if (arguments.no_positions && matches.size() == 2) {
    complain("--no-positions is about matching, but both matches are given; leave it out");
    return false;
  }
  if (arguments.json && arguments.output == "-") {
    complain("--json and -o - would mix figures and the mesh on standard output; write the mesh to a file");
    return false;
  }
  const std::string& name = named(arguments, arguments.output);
  if (name != "-" && (!format_of_path(name) || name.ends_with(".usdc"))) {
    complain(fmt::format("{}: the name does not tell the format; end it in .obj, .ply, .off or .usda{}", name,
                         arguments.as.empty() ? ", or say --as NAME" : ""));
    return false;
  }
  return report_fits(arguments.page, inputs, {arguments.output}) &&
         pictures_fit(arguments.pictures, inputs, {arguments.output, arguments.page});
}

Expected<MeshFile> read_as(const MergeArguments& arguments, const std::string& path) {
  if (arguments.as.empty()) return read_mesh(path);
  const Expected<FileBytes> bytes = read_file(path);
  if (!bytes) return Unexpected(bytes.error());
  Expected<MeshFile> file = parse_mesh(bytes->view(), display_name(path), format_of_path(arguments.as));
  if (file) file->path = path;
  return file;
}

/// Do work on its own thread, if there may be several.
template <class Work>
auto beside(const MergeArguments& arguments, Work work) {
  const std::uint32_t threads = arguments.threads == 0 ? std::thread::hardware_concurrency() : arguments.threads;
  return std::async(threads > 1 ? std::launch::async : std::launch::deferred, std::move(work));
}

/// The three meshes, or a complaint as if one had been read after the other.
std::optional<Inputs> read_all(const MergeArguments& arguments) {
  auto theirs = beside(arguments, [&] { return read_as(arguments, arguments.theirs); });
  auto ours = beside(arguments, [&] { return read_as(arguments, arguments.ours); });
  std::array<Expected<MeshFile>, 3> files{read_as(arguments, arguments.base), ours.get(), theirs.get()};
  for (const Expected<MeshFile>& file : files) {
    if (!file) {
      complain(file.error());
      return std::nullopt;
    }
    if (arguments.quiet) continue;
    for (const std::string& note : file->notes) warn(fmt::format("{}: {}", display_name(file->path), note));
    const std::string dirt = describe_dirt(file->mesh, "matching");
    if (!dirt.empty()) warn(fmt::format("{}: {}", display_name(file->path), dirt));
  }
  return Inputs{*std::move(files[0]), *std::move(files[1]), *std::move(files[2])};
}

MatchSide side_of(const MeshFile& file) { return {file.path, file.mesh.vertex_count(), file.mesh.face_count()}; }

/// The match of a file, if it is of these meshes; else one found here.
Expected<Match> match_of(const MergeArguments& arguments, const std::string& path, const MeshFile& base,
                         const MeshFile& side) {
  if (path.empty()) {
    MatchOptions options;
    options.positions = !arguments.no_positions;
    return match_side(base.mesh, side.mesh, options);
  }
  Expected<MatchFile> file = read_match(path);
  if (!file) return Unexpected(file.error());
  if (Expected<void> fitting = fits(*file, side_of(base), side_of(side)); !fitting) {
    if (fitting.error().path.empty()) fitting.error().path = display_name(path);
    return Unexpected(fitting.error());
  }
  return std::move(file->match);
}

/// What the merge remarked on, and what the format of OUT may not hold.
void warn_of_remarks(const MergeArguments& arguments, const Inputs& inputs, const Merged& merged) {
  for (std::size_t k = inputs.ours.notes.size(); k < merged.file.notes.size(); ++k) warn(merged.file.notes[k]);
  const std::string& name = named(arguments, arguments.output);
  const Format format = name == "-" ? Format::Obj : *format_of_path(name);
  if (format == inputs.ours.format) return;
  warn(fmt::format("{}: another format than that of OURS; what it has no place for is not written",
                   display_name(arguments.output)));
}

bool tell(const MergeArguments& arguments, const MergeSummary& summary) {
  if (arguments.json) return print(as_json(summary));
  if (arguments.quiet) return true;
  if (arguments.output != "-") return print(as_text(summary));
  fmt::print(stderr, "{}", as_text(summary));
  return true;
}

/// Write as the path, or as the name that stands for it, says.
Expected<void> write(const MergeArguments& arguments, const MeshFile& file) {
  if (arguments.as.empty()) return write_mesh(arguments.output, file);
  return replace_file(arguments.output, format_mesh(file, *format_of_path(arguments.as)));
}

MergeSummary summarize(const MergeArguments& arguments, const Inputs& inputs, const Merged& merged) {
  MergeSummary summary;
  summary.base = arguments.base;
  summary.ours = arguments.ours;
  summary.theirs = arguments.theirs;
  summary.base_faces = inputs.base.mesh.face_count();
  summary.ours_faces = inputs.ours.mesh.face_count();
  summary.theirs_faces = inputs.theirs.mesh.face_count();
  summary.prefer = kSideNames.at(arguments.prefer);
  count_origins(merged, summary);
  summary.report = merged.report;
  if (arguments.origins) summary.origins = merged.face_origins;
  summary.settings = settings_of(arguments);
  summary.output = arguments.output;
  return summary;
}

/// The page and the picture, as far as they were asked for: the base beside the result, matched anew.
bool write_views(const MergeArguments& arguments, const Inputs& inputs, const Match& to_ours, const Match& to_theirs,
                 Merged& merged, MergeSummary& summary) {
  if (arguments.page.empty() && !arguments.pictures.any()) return true;
  MeshFile& result = merged.file;
  result.path = arguments.output == "-" ? "standard output" : arguments.output;
  MatchOptions options;
  options.positions = !arguments.no_positions;
  const Match match = match_side(inputs.base.mesh, result.mesh, options);
  if (!arguments.page.empty()) {
    const ReportText text =
        report_text(summary, inputs.base.mesh, result.mesh, merged.face_origins, to_ours, to_theirs);
    const Expected<void> written = write_report(arguments.page, inputs.base, result, match, text);
    if (!written) complain(written.error());
    if (!written) return false;
    summary.page = arguments.page;
  }
  summary.pictures = arguments.pictures.files();
  return write_pictures(arguments.pictures, inputs.base, result, match);
}

int run_merge(const MergeArguments& arguments) {
  if (!arguments_fit(arguments)) return kTrouble;
  Progress progress(!arguments.quiet);
  Stopwatch stopwatch;
  MergeTimes times;
  progress.stage(fmt::format("reading {}, {} and {}", display_name(arguments.base), display_name(arguments.ours),
                             display_name(arguments.theirs)));
  const std::optional<Inputs> inputs = read_all(arguments);
  if (!inputs) return kTrouble;
  times.reading = stopwatch.lap();

  progress.stage("matching");
  auto beside_us =
      beside(arguments, [&] { return match_of(arguments, arguments.match_theirs, inputs->base, inputs->theirs); });
  const Expected<Match> to_ours = match_of(arguments, arguments.match_ours, inputs->base, inputs->ours);
  const Expected<Match> to_theirs = beside_us.get();
  if (!to_ours) return complain(to_ours.error());
  if (!to_theirs) return complain(to_theirs.error());
  times.matching = stopwatch.lap();

  progress.stage("merging");
  Expected<Merged> merged = merge(inputs->base, inputs->ours, inputs->theirs, *to_ours, *to_theirs,
                                  {.prefer = kSideNames.at(arguments.prefer)});
  if (!merged) {
    merged.error().path = display_name(merged.error().path);
    return complain(merged.error());
  }
  times.merging = stopwatch.lap();

  MergeSummary summary = summarize(arguments, *inputs, *merged);
  if (!write_views(arguments, *inputs, *to_ours, *to_theirs, *merged, summary)) return kTrouble;
  stopwatch.lap();
  progress.stage(fmt::format("writing {}", arguments.output));
  if (Expected<void> written = write(arguments, merged->file); !written) return complain(written.error());
  times.writing = stopwatch.lap();
  progress.clear();

  if (!arguments.quiet) warn_of_remarks(arguments, *inputs, *merged);
  summary.times = times;
  if (!tell(arguments, summary)) return kTrouble;
  return summary.report.clean() ? kSame : kDifferent;
}

}  // namespace

void add_merge_command(CLI::App& program, Action& chosen) {
  MergeArguments* arguments = nullptr;
  CLI::App* const verb =
      add_verb(program, "merge", "Bring two edits of one mesh together", arguments, run_merge, chosen);
  verb->footer(kFooter);
  verb->add_option("BASE", arguments->base, "Mesh that both sides were made from; - reads standard input")
      ->required()
      ->type_name("FILE");
  verb->add_option("OURS", arguments->ours, "One edit of it")->required()->type_name("FILE");
  verb->add_option("THEIRS", arguments->theirs, "The other")->required()->type_name("FILE");
  verb->add_option("-o,--output", arguments->output,
                   "Mesh to write, in the format of its ending; - writes OBJ to standard output")
      ->required()
      ->type_name("FILE");
  add_report_option(*verb, arguments->page);
  add_picture_options(*verb, arguments->pictures, false);
  verb->add_option("--prefer", arguments->prefer, "What OUT holds where edits meet: ours or theirs")
      ->check(CLI::IsMember(kSideNames).description(""))
      ->type_name("SIDE")
      ->capture_default_str();
  verb->add_option("--match-ours", arguments->match_ours,
                   "Match file from BASE to OURS; without it they are matched here")
      ->type_name("FILE");
  verb->add_option("--match-theirs", arguments->match_theirs, "The same from BASE to THEIRS")->type_name("FILE");
  verb->add_option("--as", arguments->as,
                   "All files are of the format of this name, whatever they are called; git's %P")
      ->type_name("NAME");
  verb->add_flag("--no-positions", arguments->no_positions, "Match by connectivity alone");
  verb->add_option("--threads", arguments->threads,
                   "Read and match the two sides at the same time if 2 or more; 0: as many as there are processors")
      ->type_name("N")
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "Print the figures as JSON");
  verb->add_flag("--origins", arguments->origins,
                 "In the JSON, of each face of OUT its number in BASE, OURS and THEIRS, or null");
  verb->add_flag("--quiet", arguments->quiet, "Print neither summary nor warnings");
}

}  // namespace quadmatch::cli
