#include "parts_diff.hpp"

#include <utility>

#include <fmt/format.h>

#include <quadmatch/report/report.hpp>

namespace quadmatch::cli {
namespace {

std::vector<std::pair<std::string, std::string>> settings_of(const DiffArguments& arguments) {
  std::vector<std::pair<std::string, std::string>> settings{
      {"program", "quadmatch " QUADMATCH_VERSION},
      {"orientation", arguments.match.orientation},
      {"positions", arguments.match.no_positions ? "false" : "true"},
      {"ignore_positions", arguments.ignore_positions ? "true" : "false"},
      {"tolerance", fmt::format("{}", arguments.tolerance)}};
  if (!arguments.match.file.empty()) settings.emplace_back("match", arguments.match.file);
  return settings;
}

/// The page and the pictures, if they were asked for. Regions that count as unmatched are shown so.
bool write_views(const DiffArguments& arguments, const InputPair& inputs, DiffSummary& summary) {
  if (arguments.page.empty() && !arguments.pictures.any()) return true;
  Match shown = summary.match;
  for (const DoubtfulRegion& doubt : summary.difference.doubtful) {
    if (doubt.left_out) shown.regions[doubt.region].faces.clear();
  }
  std::erase_if(shown.regions, [](const Region& region) { return region.faces.empty(); });
  if (!arguments.page.empty()) {
    const Expected<void> written =
        write_report(arguments.page, inputs.source, inputs.target, shown, report_text(summary));
    if (!written) complain(written.error());
    if (!written) return false;
    summary.page = arguments.page;
  }
  summary.pictures = arguments.pictures.files();
  return write_pictures(arguments.pictures, inputs.source, inputs.target, shown);
}

}  // namespace

std::optional<DiffSummary> compare(const DiffArguments& arguments, const MeshFile& source, const MeshFile& target,
                                   double reading, Progress& progress) {
  Stopwatch stopwatch;
  progress.stage("matching");
  MatchWishes wishes = arguments.match;
  wishes.waves = !arguments.page.empty() || !arguments.pictures.animation.empty();  // both replay them
  std::optional<Match> match = find_or_read_match(wishes, source, target, progress);
  if (!match) return std::nullopt;
  progress.stage("comparing");
  const DiffOptions options{arguments.ignore_positions, arguments.tolerance, arguments.least_confidence};
  Expected<Difference> difference = diff(source.mesh, target.mesh, *match, options);
  progress.clear();
  if (!difference) {
    difference.error().path = display_name(arguments.match.file);
    complain(difference.error());
    return std::nullopt;
  }
  DiffSummary summary{.source = source.path,
                      .target = target.path,
                      .match = *std::move(match),
                      .difference = *std::move(difference),
                      .settings = settings_of(arguments),
                      .times = {},
                      .page = {}};
  summary.times.reading = reading;
  summary.times.matching = stopwatch.lap();
  return summary;
}

bool tell(const DiffArguments& arguments, const DiffSummary& summary) {
  if (arguments.json) return print(as_json(summary));
  if (arguments.stat) return print(as_stat(summary));
  return arguments.quiet || print(as_text(summary));
}

int run_parts_diff(const DiffArguments& arguments) {
  Progress progress(!arguments.quiet);
  Stopwatch stopwatch;
  progress.stage(fmt::format("reading {} and {}", display_name(arguments.source), display_name(arguments.target)));
  const std::optional<InputPair> inputs =
      read_inputs(arguments.source, arguments.target, !arguments.quiet, arguments.threads);
  if (!inputs) return kTrouble;
  const double reading = stopwatch.lap();
  if (!arguments.quiet) {
    warn_of_dirt(inputs->source);
    warn_of_dirt(inputs->target);
  }
  std::optional<DiffSummary> summary = compare(arguments, inputs->source, inputs->target, reading, progress);
  if (!summary || !write_views(arguments, *inputs, *summary) || !tell(arguments, *summary)) return kTrouble;
  return summary->difference.none() ? kSame : kDifferent;
}

}  // namespace quadmatch::cli
