#pragma once
/// What quadmatch diff was given, and the ways in which it compares.

#include <string>
#include <vector>

#include "pair_match.hpp"
#include "picture_options.hpp"

namespace quadmatch::cli {

struct DiffArguments {
  std::string source, target;
  std::string output;
  std::string page;  ///< of the HTML report, empty: none
  PictureWishes pictures;
  MatchWishes match;
  bool isomorphic = false;
  bool ignore_positions = false;
  double tolerance = 2e-6;
  double least_confidence = 0;
  std::uint32_t threads = 0;
  std::vector<std::string> git;  ///< what git gave to its external diff
  std::string textconv;
  bool stat = false;
  bool json = false;
  bool quiet = false;
};

/// Part by part.
[[nodiscard]] int run_parts_diff(const DiffArguments& arguments);
/// Whole on whole: a map, or what is different.
[[nodiscard]] int run_isomorphic_diff(const DiffArguments& arguments);
/// As an external diff of git: part by part, told of the names git knows.
[[nodiscard]] int run_git_diff(const DiffArguments& arguments);
/// One mesh as lines that git can compare.
[[nodiscard]] int run_textconv(const DiffArguments& arguments);

}  // namespace quadmatch::cli
