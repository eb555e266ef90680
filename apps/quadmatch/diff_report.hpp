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
  Match match;
  Difference difference;
  std::vector<std::pair<std::string, std::string>> settings;
  Times times;                             ///< matching: both, to match and to compare
  std::string page;                        ///< where the HTML report was written; empty: nowhere
  std::vector<std::string> pictures = {};  ///< files of the image and the animation, if there are any
};

/// What the HTML report says of it: every change by its name, to fly to.
[[nodiscard]] ReportText report_text(const DiffSummary& summary);

/// One page: what was changed, from the largest.
[[nodiscard]] std::string as_text(const DiffSummary& summary);
/// One line of name=number, for scripts.
[[nodiscard]] std::string as_stat(const DiffSummary& summary);
/// Everything, with the elements of each change.
[[nodiscard]] std::string as_json(const DiffSummary& summary);

}  // namespace quadmatch::cli
