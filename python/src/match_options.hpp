#pragma once
/// The words of `quadmatch match` as options of the library.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/mesh/expected.hpp>

namespace quadmatch::python {

/// What Python asks for, in words.
struct MatchWords {
  std::string algorithm, orientation;
  bool positions = true;
  std::vector<std::string> without;
  double least_confidence = 0;
  std::uint32_t least_region = 1;
  std::uint32_t rounds = AnchorOptions{}.rounds;
  bool arc_lengths = false;
  bool waves = false;
  std::uint32_t at_least = 0;
  double time_limit = 0;
  /// Rows of face, corner, face, corner.
  std::vector<std::array<std::int64_t, 4>> anchors;
};

/// @par Errors  BadArgument for a word that is not known, a share outside 0 ... 1, options of the exact search with
///              another one, and anchors that name no corner; each sentence names the argument.
[[nodiscard]] Expected<MatchOptions> options_of(const MatchWords& words, const Mesh& source, const Mesh& target);
[[nodiscard]] Expected<OrientationChoice> orientation_of(const std::string& word);

/// What was asked for, as the match file remembers it.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> settings_of(const MatchWords& words);

}  // namespace quadmatch::python
