// quadmatch match A B: read, match, verify, write, report.

#include <fmt/format.h>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/report/report.hpp>

#include "command.hpp"
#include "console.hpp"
#include "html_report.hpp"
#include "inputs.hpp"
#include "match_report.hpp"
#include "matching.hpp"
#include "pair_match.hpp"
#include "picture_options.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter = R"(The match file lists, for each matched face of A, the face of B and how it is turned,
and for each vertex its partner. Without -o it goes to standard output and the summary
to standard error; with --json, --report or --image and no -o, there is no match file.

An anchor is a place you know to be the same; growth starts there. Count from 0:
  --anchor 12:0=90:1    corner 0 of face 12 lies on corner 1 of face 90
  --anchor 5-6=31-30    the edge from vertex 5 to 6 lies on the edge from 31 to 30
  --anchor 5=31         vertex 5 lies on vertex 31; the alignment is found
With an anchor and --orientation auto both ways round are tried, and the larger match kept.

Examples:
  quadmatch match bear.obj bear_without_ears.obj -o bears.json
  quadmatch match left_shoe.obj right_shoe.obj -o shoes.json --orientation reversing
  quadmatch match a.ply b.usda --json | jq .matched_faces
  quadmatch match patch.obj edited.obj -o best.json --algorithm exact --time-limit 10
  quadmatch match a.obj b.obj -o m.json --report m.html    then open m.html in a browser
  quadmatch match a.obj b.obj --image ab.png --animation ab.webp --image-size 960x480

The problem is NP-hard, yet --algorithm exact finds the largest region there is and proves it
for patches of a few hundred faces and for small whole meshes after small edits, mostly within
seconds. Give it a --time-limit: when it is over, the best region so far is written, with a bound.
With --at-least K it only settles whether there is a region of K faces or more.

Exit status: 0 matched, in whole or in part; 1 nothing matched; 2 trouble.
With --at-least: 0 yes, 1 no, 2 trouble, 3 not known when the time was over.)";

struct MatchArguments {
  std::string source, target;
  std::string output;
  std::string page;  // of the HTML report, empty: none
  PictureWishes pictures;
  MatchingArguments matching;
  std::uint32_t threads = 0;
  bool json = false;
  bool quiet = false;
};

int status_of(const MatchReport& report) {
  if (!report.optimality || report.optimality->decision == Decision::NotAsked) {
    return report.matched_faces() > 0 ? kSame : kDifferent;
  }
  switch (report.optimality->decision) {
    case Decision::Yes:
      return kSame;
    case Decision::No:
      return kDifferent;
    default:
      return kUnknown;
  }
}

/// Where the match file goes: a file, - for standard output, or nowhere where only figures or pictures were asked for.
std::string match_output(const MatchArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return arguments.json || !arguments.page.empty() || arguments.pictures.any() ? "" : "-";
}

/// A report and a film replay them.
bool keeps_waves(const MatchArguments& arguments) {
  return arguments.matching.waves || !arguments.page.empty() || !arguments.pictures.animation.empty();
}

/// Figures go to standard output, and a summary wherever the match file does not.
bool tell(const MatchArguments& arguments, const MatchReport& report) {
  if (arguments.json) return print(as_json(report));
  if (arguments.quiet) return true;
  if (match_output(arguments) != "-") return print(as_text(report));
  fmt::print(stderr, "{}", as_text(report));
  return true;
}

bool write_page(const MatchArguments& arguments, const InputPair& inputs, const Match& match,
                const MatchReport& report) {
  const ReportText text{.title = report_title(arguments.source, arguments.target),
                        .program = "quadmatch " QUADMATCH_VERSION,
                        .figures = figures_of(report),
                        .changes = unmatched_areas(inputs.source.mesh, inputs.target.mesh, match)};
  const Expected<void> written = write_report(arguments.page, inputs.source, inputs.target, match, text);
  if (!written) complain(written.error());
  return written.has_value();
}

/// The page, the pictures and the match file, as far as they were asked for; all are named in the report.
bool write_outputs(const MatchArguments& arguments, const InputPair& inputs, MatchResult& result, MatchReport& report) {
  if (!arguments.page.empty()) {
    if (!write_page(arguments, inputs, result.match, report)) return false;
    report.page = arguments.page;
  }
  if (!write_pictures(arguments.pictures, inputs.source, inputs.target, result.match)) return false;
  report.pictures = arguments.pictures.files();
  const std::string output = match_output(arguments);
  if (output.empty()) return true;
  if (!arguments.matching.waves) {
    for (Region& region : result.match.regions) region.waves.clear();  // kept for page and film alone
  }
  const MatchFile file{side_of(inputs.source), side_of(inputs.target), std::move(result.match), report.settings,
                       result.optimality};
  const Expected<void> written = write_match(output, file);
  if (!written) complain(written.error());
  if (output != "-") report.output = output;
  return written.has_value();
}

int run_match(const MatchArguments& arguments) {
  if (const Expected<void> fit = check_matching(arguments.matching); !fit) return complain(fit.error());
  if (!paths_fit({arguments.source, arguments.target}, {arguments.output}) ||
      !report_fits(arguments.page, {arguments.source, arguments.target}, {arguments.output}) ||
      !pictures_fit(arguments.pictures, {arguments.source, arguments.target}, {arguments.output, arguments.page})) {
    return kTrouble;
  }
  if (arguments.json && arguments.output == "-") {
    complain("--json and -o - would mix figures and match file on standard output; write the match to a file");
    return kTrouble;
  }
  Progress progress(!arguments.quiet);
  Stopwatch stopwatch;
  progress.stage(fmt::format("reading {} and {}", display_name(arguments.source), display_name(arguments.target)));
  std::optional<InputPair> inputs =
      read_inputs(arguments.source, arguments.target, !arguments.quiet, arguments.threads);
  if (!inputs) return kTrouble;
  const MeshFile* const source = &inputs->source;
  const MeshFile* const target = &inputs->target;
  Times times;
  times.reading = stopwatch.lap();
  if (!arguments.quiet) {
    warn_of_dirt(*source);
    warn_of_dirt(*target);
    stopwatch.lap();
  }

  progress.stage("matching");
  std::function<void(std::size_t, std::size_t)> watch;
  if (progress.visible())
    watch = [&progress](std::size_t matched, std::size_t most) { progress.update(matched, most); };
  Expected<MatchResult> result =
      match_as_asked(arguments.matching, {source->mesh, display_name(arguments.source)},
                     {target->mesh, display_name(arguments.target)}, keeps_waves(arguments), watch);
  if (!result) return complain(result.error());
  times.matching = stopwatch.lap();
  progress.stage("verifying");
  if (const Expected<void> sound = check_sound(source->mesh, target->mesh, result->match); !sound) {
    return complain(sound.error());
  }
  times.verifying = stopwatch.lap();

  progress.clear();

  MatchReport report = report_match(source->mesh, target->mesh, *result, !arguments.matching.anchors.empty());
  report.source.path = arguments.source;
  report.target.path = arguments.target;
  report.settings = settings_of(arguments.matching);
  stopwatch.lap();
  if (!write_outputs(arguments, *inputs, *result, report)) return kTrouble;
  times.writing = stopwatch.lap();
  report.times = times;
  if (!tell(arguments, report)) return kTrouble;
  return status_of(report);
}

}  // namespace

void add_match_command(CLI::App& program, Action& chosen) {
  MatchArguments* arguments = nullptr;
  CLI::App* const verb =
      add_verb(program, "match", "Match two meshes and write the match file", arguments, run_match, chosen);
  verb->footer(kFooter);
  verb->add_option("A", arguments->source, "Source mesh; - reads standard input")->required()->type_name("FILE");
  verb->add_option("B", arguments->target, "Target mesh")->required()->type_name("FILE");
  verb->add_option("-o,--output", arguments->output, "Match file to write (JSON); - or none: standard output")
      ->type_name("FILE");
  add_report_option(*verb, arguments->page);
  add_picture_options(*verb, arguments->pictures, true);
  add_matching_options(*verb, arguments->matching);
  verb->add_option("--threads", arguments->threads,
                   "Read the two meshes at the same time if 2 or more; 0: as many as there are processors")
      ->type_name("N")
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "Print the figures as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print neither summary nor warnings");
}

}  // namespace quadmatch::cli
