#pragma once
/// What a match is asked for, in words: those of the command line, of the match file's settings and of the page.

#include <map>
#include <string>
#include <utility>
#include <vector>

#include <quadmatch/match/matcher.hpp>

namespace quadmatch::cli {

struct MatchingArguments {
  std::string algorithm = "regions";
  std::string orientation = "auto";
  std::vector<std::string> anchors = {};
  bool arc_lengths = false;
  std::uint32_t rounds = AnchorOptions{}.rounds;
  bool no_positions = false;
  std::vector<std::string> without = {};
  double least_confidence = MatchOptions{}.least_confidence;
  std::uint32_t least_region = MatchOptions{}.least_region;
  double time_limit = 0;       ///< seconds, 0: none
  std::uint32_t at_least = 0;  ///< 0: not asked
  bool waves = false;          ///< in the match file
};

/// The names of --algorithm, of --orientation, and of what --without leaves out.
[[nodiscard]] const std::map<std::string, Algorithm>& algorithm_choices();
[[nodiscard]] const std::map<std::string, OrientationChoice>& orientation_choices();
[[nodiscard]] const std::map<std::string, bool Stages::*>& stage_choices();

/// The same for the library, but for anchors, which need the meshes, and for progress.
/// @pre  the words are names of the choices.
[[nodiscard]] MatchOptions options_of(const MatchingArguments& arguments);

/// What was asked for, as the match file remembers it.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> settings_of(const MatchingArguments& arguments);

}  // namespace quadmatch::cli
