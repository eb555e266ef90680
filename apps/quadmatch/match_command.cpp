// quadmatch match A B: read, match, verify, write, report.

#include <algorithm>
#include <chrono>
#include <map>

#include <fmt/format.h>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/report/report.hpp>
#include <quadmatch/verify/verify.hpp>

#include "anchor_option.hpp"
#include "command.hpp"
#include "console.hpp"
#include "dirt.hpp"
#include "html_report.hpp"
#include "inputs.hpp"
#include "match_arguments.hpp"
#include "match_report.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter = R"(The match file lists, for each matched face of A, the face of B and how it is turned,
and for each vertex its partner. Without -o it goes to standard output and the summary
to standard error; with --json or --report and no -o, there is no match file.

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

The problem is NP-hard, yet --algorithm exact finds the largest region there is and proves it
for patches of a few hundred faces and for small whole meshes after small edits, mostly within
seconds. Give it a --time-limit: when it is over, the best region so far is written, with a bound.
With --at-least K it only settles whether there is a region of K faces or more.

Exit status: 0 matched, in whole or in part; 1 nothing matched; 2 trouble.
With --at-least: 0 yes, 1 no, 2 trouble, 3 not known when the time was over.)";

template <class Choice>
CLI::Validator one_of(const std::map<std::string, Choice>& choices) {
  return CLI::IsMember(choices).description("");  // the help names them in a sentence
}

/// What was asked for, and whom to tell how far it is.
MatchOptions options_of(const MatchArguments& arguments, Progress& progress) {
  MatchOptions options = options_of(arguments);
  if (!progress.visible() && arguments.time_limit == 0) return options;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  options.progress = [&progress, began, limit = arguments.time_limit](std::size_t matched, std::size_t most) {
    progress.update(matched, most);
    return limit == 0 || std::chrono::duration<double>(Clock::now() - began).count() < limit;
  };
  return options;
}

/// Do the options of the exact search go together with the rest?
bool exact_options_fit(const MatchArguments& arguments) {
  const bool exact = arguments.algorithm == "exact";
  if (!exact && (arguments.time_limit != 0 || arguments.at_least != 0)) {
    complain(fmt::format("{} needs --algorithm exact; {} ends by itself",
                         arguments.at_least != 0 ? "--at-least" : "--time-limit", arguments.algorithm));
    return false;
  }
  if (exact && !arguments.anchors.empty()) {
    complain("--algorithm exact looks at all places and takes no --anchor; leave it out, or use regions");
    return false;
  }
  return true;
}

/// Grow from the user's anchors, laid one way round.
Expected<MatchResult> match_from(const MatchArguments& arguments, const NamedMesh& source, const NamedMesh& target,
                                 MatchOptions options, Orientation orientation) {
  const bool preserving = orientation == Orientation::Preserving;
  options.orientation = preserving ? OrientationChoice::Preserving : OrientationChoice::Reversing;
  for (const std::string& text : arguments.anchors) {
    const Expected<std::vector<UserAnchor>> anchors = parse_anchor(text, source, target, orientation);
    if (!anchors) return Unexpected(anchors.error());
    options.anchors.insert(options.anchors.end(), anchors->begin(), anchors->end());
  }
  return match(source.mesh, target.mesh, options);
}

/// An anchor of vertices or edges means other corners when the target is turned over, so each way round has its own.
Expected<MatchResult> match_as_asked(const MatchArguments& arguments, const NamedMesh& source, const NamedMesh& target,
                                     Progress& progress) {
  const MatchOptions options = options_of(arguments, progress);
  if (arguments.anchors.empty()) return match(source.mesh, target.mesh, options);
  if (options.orientation == OrientationChoice::Preserving) {
    return match_from(arguments, source, target, options, Orientation::Preserving);
  }
  Expected<MatchResult> reversing = match_from(arguments, source, target, options, Orientation::Reversing);
  if (options.orientation == OrientationChoice::Reversing) return reversing;

  Expected<MatchResult> preserving = match_from(arguments, source, target, options, Orientation::Preserving);
  if (!preserving) return reversing ? std::move(reversing) : std::move(preserving);
  if (!reversing) return preserving;
  const bool larger = reversing->match.matched_faces() > preserving->match.matched_faces();
  return larger ? std::move(reversing) : std::move(preserving);
}

MatchSide side_of(const MeshFile& file) { return {file.path, file.mesh.vertex_count(), file.mesh.face_count()}; }

/// No match leaves this program that the definition does not allow.
bool is_sound(const MeshFile& source, const MeshFile& target, const Match& match) {
  const Verdict verdict = verify(source.mesh, target.mesh, match, 1);
  if (verdict.sound()) return true;
  complain(fmt::format("internal error: the match found is not sound ({}); nothing was written, please report it",
                       verdict.faults.front().message));
  return false;
}

void warn_of_dirt(const MeshFile& file) {
  const std::string dirt = describe_dirt(file.mesh, "matching");
  if (!dirt.empty()) warn(fmt::format("{}: {}", display_name(file.path), dirt));
}

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

/// Where the match file goes: a file, - for standard output, or nowhere where only figures or a page were asked for.
std::string match_output(const MatchArguments& arguments) {
  if (!arguments.output.empty()) return arguments.output;
  return arguments.json || !arguments.page.empty() ? "" : "-";
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

/// The page and the match file, as far as they were asked for; both are named in the report.
bool write_outputs(const MatchArguments& arguments, const InputPair& inputs, MatchResult& result, MatchReport& report) {
  if (!arguments.page.empty()) {
    if (!write_page(arguments, inputs, result.match, report)) return false;
    report.page = arguments.page;
  }
  const std::string output = match_output(arguments);
  if (output.empty()) return true;
  if (!arguments.waves) {
    for (Region& region : result.match.regions) region.waves.clear();  // kept for the page alone
  }
  const MatchFile file{side_of(inputs.source), side_of(inputs.target), std::move(result.match), report.settings,
                       result.optimality};
  const Expected<void> written = write_match(output, file);
  if (!written) complain(written.error());
  if (output != "-") report.output = output;
  return written.has_value();
}

int run_match(const MatchArguments& arguments) {
  if (!exact_options_fit(arguments)) return kTrouble;
  if (!paths_fit({arguments.source, arguments.target}, arguments.output) ||
      !report_fits(arguments.page, {arguments.source, arguments.target}, arguments.output)) {
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
  Expected<MatchResult> result = match_as_asked(arguments, {source->mesh, display_name(arguments.source)},
                                                {target->mesh, display_name(arguments.target)}, progress);
  if (!result) return complain(result.error());
  times.matching = stopwatch.lap();
  progress.stage("verifying");
  if (!is_sound(*source, *target, result->match)) return kTrouble;
  times.verifying = stopwatch.lap();

  progress.clear();

  MatchReport report = report_match(source->mesh, target->mesh, *result, !arguments.anchors.empty());
  report.source.path = arguments.source;
  report.target.path = arguments.target;
  report.settings = settings_of(arguments);
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
  verb->add_option(
          "--algorithm", arguments->algorithm,
          "regions: many anchors, many regions, belief by evidence. The paper's, of one region: lazy-greedy, the "
          "largest compatible component first; greedy, every face that fits, wave by wave. exact: the largest region, "
          "proved, for small meshes")
      ->check(one_of(algorithm_choices()))
      ->type_name("NAME")
      ->capture_default_str();
  verb->add_option("--orientation", arguments->orientation,
                   "preserving, reversing (a mirror image), or auto: reversing where preserving leaves much unmatched")
      ->check(one_of(orientation_choices()))
      ->type_name("NAME")
      ->capture_default_str();
  verb->add_option("--anchor", arguments->anchors,
                   "These are the same, whatever else says so (see below); the paper's algorithms grow from the first")
      ->type_name("PLACE=PLACE")
      ->allow_extra_args(false);
  verb->add_option("--min-confidence", arguments->least_confidence,
                   "Leave out regions of which a smaller share of the extraordinary vertices agrees, 0 to 1")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->type_name("SHARE")
      ->capture_default_str();
  verb->add_option("--min-region", arguments->least_region, "Leave out regions of fewer faces")
      ->type_name("FACES")
      ->capture_default_str();
  verb->add_option("--threads", arguments->threads,
                   "Read the two meshes at the same time if 2 or more; 0: as many as there are processors")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--rounds", arguments->rounds, "The paper's algorithms: rounds of colouring at most for anchors")
      ->type_name("K")
      ->capture_default_str();
  verb->add_flag("--arc-lengths", arguments->arc_lengths,
                 "The paper's algorithms: colour by the lengths of skeleton arcs too");
  verb->add_flag("--no-positions", arguments->no_positions, "Connectivity alone: never look at where vertices are");
  verb->add_option("--without", arguments->without,
                   "For experiments: leave out stages of regions, of equal-parts, seams, ties, slides, ventures, "
                   "slivers, islands, restarts, acceptance, doubts")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(stage_choices()))
      ->type_name("STAGE,...");
  verb->add_option("--time-limit", arguments->time_limit, "exact: stop after so long, with the best region so far")
      ->check(CLI::Range(0.001, 1e9).description(""))
      ->type_name("SECONDS");
  verb->add_option(
          "--at-least", arguments->at_least,
          "exact: only settle whether there is a region of so many faces or more; the answer is the exit status")
      ->check(CLI::Range(1U, 0xffffffffU).description(""))
      ->type_name("FACES");
  verb->add_flag("--waves", arguments->waves, "Keep the order of growth, wave by wave, in the match file");
  verb->add_flag("--json", arguments->json, "Print the figures as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print neither summary nor warnings");
}

}  // namespace quadmatch::cli
