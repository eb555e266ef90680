#pragma once
/// A merge to look at: the base beside the result, and who changed what.

#include <quadmatch/report/report.hpp>

#include "merge_report.hpp"

namespace quadmatch::cli {

/// What the HTML report lists, each to fly to: conflicts first, then what was removed and added, by side and area, then
/// what is in doubt.
///
/// @param result             the merged mesh.
/// @param origins            where its faces come from.
/// @param to_ours, to_theirs the matches of the base.
[[nodiscard]] ReportText report_text(const MergeSummary& summary, const Mesh& base, const Mesh& result,
                                     const std::vector<InThree<FaceId>>& origins, const Match& to_ours,
                                     const Match& to_theirs);

}  // namespace quadmatch::cli
