#include "match_arguments.hpp"

#include <fmt/format.h>

#include <quadmatch/match/words.hpp>

#include "text.hpp"

namespace quadmatch::cli {
namespace {

/// As the parser of options takes them.
template <class Meaning, std::size_t kCount>
std::map<std::string, Meaning> choices_of(const Words<Meaning, kCount>& words) {
  return {words.begin(), words.end()};
}

}  // namespace

const std::map<std::string, Algorithm>& algorithm_choices() {
  static const std::map<std::string, Algorithm> choices = choices_of(kAlgorithmWords);
  return choices;
}

const std::map<std::string, OrientationChoice>& orientation_choices() {
  static const std::map<std::string, OrientationChoice> choices = choices_of(kOrientationWords);
  return choices;
}

const std::map<std::string, bool Stages::*>& stage_choices() {
  static const std::map<std::string, bool Stages::*> choices = choices_of(kStageWords);
  return choices;
}

MatchOptions options_of(const MatchingArguments& arguments) {
  MatchOptions options;
  options.algorithm = algorithm_choices().find(arguments.algorithm)->second;
  options.orientation = orientation_choices().find(arguments.orientation)->second;
  options.anchor_search.rounds = arguments.rounds;
  options.anchor_search.colouring.arc_lengths = arguments.arc_lengths;
  options.positions = !arguments.no_positions;
  for (const std::string& stage : arguments.without) options.stages.*stage_choices().find(stage)->second = false;
  options.least_confidence = arguments.least_confidence;
  options.least_region = arguments.least_region;
  options.waves = arguments.waves;
  options.at_least = arguments.at_least;
  return options;
}

std::vector<std::pair<std::string, std::string>> settings_of(const MatchingArguments& arguments) {
  std::vector<std::pair<std::string, std::string>> settings{{"program", "quadmatch " QUADMATCH_VERSION},
                                                            {"algorithm", arguments.algorithm},
                                                            {"orientation", arguments.orientation},
                                                            {"rounds", std::to_string(arguments.rounds)},
                                                            {"arc_lengths", arguments.arc_lengths ? "true" : "false"},
                                                            {"positions", arguments.no_positions ? "false" : "true"}};
  if (arguments.time_limit != 0) settings.emplace_back("time_limit", fmt::format("{}", arguments.time_limit));
  if (arguments.at_least != 0) settings.emplace_back("at_least", fmt::format("{}", arguments.at_least));
  if (!arguments.without.empty()) settings.emplace_back("without", joined(arguments.without, " "));
  if (!arguments.anchors.empty()) settings.emplace_back("anchors", joined(arguments.anchors, " "));
  return settings;
}

}  // namespace quadmatch::cli
