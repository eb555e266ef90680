#pragma once
/// What a comparison by parts came to: one value, told to a modeller, to a script or to a machine.

#include <string>
#include <utility>
#include <vector>

#include <quadmatch/use/diff.hpp>

#include "match_report.hpp"

namespace quadmatch::cli {

struct DiffSummary {
  std::string source, target;  ///< names to show
  Difference difference;
  std::vector<std::pair<std::string, std::string>> settings;
  Times times;  ///< matching: both, to match and to compare
};

/// One page: what was changed, from the largest.
[[nodiscard]] std::string as_text(const DiffSummary& summary);
/// One line of name=number, for scripts.
[[nodiscard]] std::string as_stat(const DiffSummary& summary);
/// Everything, with the elements of each change.
[[nodiscard]] std::string as_json(const DiffSummary& summary);

}  // namespace quadmatch::cli
