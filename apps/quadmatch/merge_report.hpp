#pragma once
/// What a merge came to: one value, told to a modeller or to a machine.

#include <string>
#include <utility>
#include <vector>

#include <quadmatch/report/report.hpp>
#include <quadmatch/use/merge.hpp>

namespace quadmatch::cli {

/// In milliseconds.
struct MergeTimes {
  double reading = 0, matching = 0, merging = 0, writing = 0;
};

struct MergeSummary {
  std::string base, ours, theirs;  ///< paths
  std::uint32_t base_faces = 0, ours_faces = 0, theirs_faces = 0;
  std::uint32_t merged_faces = 0, merged_vertices = 0;
  /// Faces of the result that all have, that only one side has, that a side and the base have, that both sides added.
  std::uint32_t from_all = 0, from_ours = 0, from_theirs = 0, from_one_and_base = 0, from_both = 0;
  MergeReport report;
  Side prefer = Side::Ours;
  std::vector<std::pair<std::string, std::string>> settings;
  MergeTimes times;
  std::string output;
  std::string page;                        ///< where the HTML report was written; empty: nowhere
  std::vector<std::string> pictures = {};  ///< files of the image, if there is one
  std::vector<InThree<FaceId>> origins;    ///< of the result's faces, where they are asked for
};

/// Count where the faces of a merge come from.
void count_origins(const Merged& merged, MergeSummary& summary);

[[nodiscard]] std::string describe(const ConflictArea& area);
[[nodiscard]] std::string describe(const ValueConflict& conflict);
[[nodiscard]] std::string describe(const DoubtfulPart& part);

/// What the summary says, line by line, but for times and files.
[[nodiscard]] std::vector<ReportFigure> figures_of(const MergeSummary& summary);
[[nodiscard]] std::string as_text(const MergeSummary& summary);
[[nodiscard]] std::string as_json(const MergeSummary& summary);

}  // namespace quadmatch::cli
