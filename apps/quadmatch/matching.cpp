#include "matching.hpp"

#include <chrono>
#include <map>

#include <fmt/format.h>

#include <quadmatch/verify/verify.hpp>

#include "text.hpp"

namespace quadmatch::cli {
namespace {

template <class Choice>
CLI::Validator one_of(const std::map<std::string, Choice>& choices) {
  return CLI::IsMember(choices).description("");  // the help names them in a sentence
}

MatchOptions options_of(const MatchingArguments& arguments, bool waves,
                        const std::function<void(std::size_t, std::size_t)>& progress) {
  MatchOptions options = options_of(arguments);
  options.waves = waves;
  if (!progress && arguments.time_limit == 0) return options;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point began = Clock::now();
  options.progress = [progress, began, limit = arguments.time_limit](std::size_t matched, std::size_t most) {
    if (progress) progress(matched, most);
    return limit == 0 || std::chrono::duration<double>(Clock::now() - began).count() < limit;
  };
  return options;
}

/// Grow from the user's anchors, laid one way round.
Expected<MatchResult> match_from(const MatchingArguments& arguments, const NamedMesh& source, const NamedMesh& target,
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

}  // namespace

void add_matching_options(CLI::App& verb, MatchingArguments& arguments) {
  verb.add_option(
          "--algorithm", arguments.algorithm,
          "regions: many anchors, many regions, belief by evidence. The paper's, of one region: lazy-greedy, the "
          "largest compatible component first; greedy, every face that fits, wave by wave. exact: the largest region, "
          "proved, for small meshes")
      ->check(one_of(algorithm_choices()))
      ->type_name("NAME")
      ->capture_default_str();
  verb.add_option("--orientation", arguments.orientation,
                  "preserving, reversing (a mirror image), or auto: reversing where preserving leaves much unmatched")
      ->check(one_of(orientation_choices()))
      ->type_name("NAME")
      ->capture_default_str();
  verb.add_option("--anchor", arguments.anchors,
                  "These are the same, whatever else says so (see below); the paper's algorithms grow from the first")
      ->type_name("PLACE=PLACE")
      ->allow_extra_args(false);
  verb.add_option("--min-confidence", arguments.least_confidence,
                  "Leave out regions of which a smaller share of the extraordinary vertices agrees, 0 to 1")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->type_name("SHARE")
      ->capture_default_str();
  verb.add_option("--min-region", arguments.least_region, "Leave out regions of fewer faces")
      ->type_name("FACES")
      ->capture_default_str();
  verb.add_option("--rounds", arguments.rounds, "The paper's algorithms: rounds of colouring at most for anchors")
      ->type_name("K")
      ->capture_default_str();
  verb.add_flag("--arc-lengths", arguments.arc_lengths,
                "The paper's algorithms: colour by the lengths of skeleton arcs too");
  verb.add_flag("--no-positions", arguments.no_positions, "Connectivity alone: never look at where vertices are");
  verb.add_option("--without", arguments.without,
                  "For experiments: leave out stages of regions, of equal-parts, seams, ties, slides, turns, "
                  "ventures, slivers, islands, restarts, rows, acceptance, doubts")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(stage_choices()))
      ->type_name("STAGE,...");
  verb.add_option("--time-limit", arguments.time_limit, "exact: stop after so long, with the best region so far")
      ->check(CLI::Range(0.001, 1e9).description(""))
      ->type_name("SECONDS");
  verb.add_option(
          "--at-least", arguments.at_least,
          "exact: only settle whether there is a region of so many faces or more; the answer is the exit status")
      ->check(CLI::Range(1U, 0xffffffffU).description(""))
      ->type_name("FACES");
  verb.add_flag("--waves", arguments.waves, "Keep the order of growth, wave by wave, in the match file");
}

Expected<void> check_matching(const MatchingArguments& arguments) {
  const bool exact = arguments.algorithm == "exact";
  if (!exact && (arguments.time_limit != 0 || arguments.at_least != 0)) {
    return Unexpected(Error{ErrorCode::BadArgument,
                            fmt::format("{} needs --algorithm exact; {} ends by itself",
                                        arguments.at_least != 0 ? "--at-least" : "--time-limit", arguments.algorithm)});
  }
  if (exact && !arguments.anchors.empty()) {
    return Unexpected(
        Error{ErrorCode::BadArgument,
              "--algorithm exact looks at all places and takes no --anchor; leave it out, or use regions"});
  }
  return {};
}

std::string options_text(const MatchingArguments& arguments) {
  const MatchingArguments usual;
  std::vector<std::string> texts;
  const auto value = [&texts](const char* name, const auto& given, const auto& by_default) {
    if (given != by_default) texts.push_back(fmt::format("--{}={}", name, given));
  };
  const auto flag = [&texts](const char* name, bool given) {
    if (given) texts.push_back(fmt::format("--{}", name));
  };
  value("algorithm", arguments.algorithm, usual.algorithm);
  value("orientation", arguments.orientation, usual.orientation);
  for (const std::string& anchor : arguments.anchors) value("anchor", anchor, std::string());
  value("min-confidence", arguments.least_confidence, usual.least_confidence);
  value("min-region", arguments.least_region, usual.least_region);
  value("rounds", arguments.rounds, usual.rounds);
  flag("arc-lengths", arguments.arc_lengths);
  flag("no-positions", arguments.no_positions);
  value("without", joined(arguments.without, ","), std::string());
  value("time-limit", arguments.time_limit, usual.time_limit);
  value("at-least", arguments.at_least, usual.at_least);
  flag("waves", arguments.waves);
  return joined(texts, " ");
}

// An anchor of vertices or edges means other corners when the target is turned over, so each way round has its own.
Expected<MatchResult> match_as_asked(const MatchingArguments& arguments, const NamedMesh& source,
                                     const NamedMesh& target, bool waves,
                                     const std::function<void(std::size_t, std::size_t)>& progress) {
  const MatchOptions options = options_of(arguments, waves, progress);
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

Expected<void> check_sound(const Mesh& source, const Mesh& target, const Match& match) {
  const Verdict verdict = verify(source, target, match, 1);
  if (verdict.sound()) return {};
  return Unexpected(Error{ErrorCode::Syntax,
                          fmt::format("internal error: the match found is not sound ({}); nothing was written, please "
                                      "report it",
                                      verdict.faults.front().message)});
}

MatchSide side_of(const MeshFile& file) { return {file.path, file.mesh.vertex_count(), file.mesh.face_count()}; }

}  // namespace quadmatch::cli
