#pragma once
/// What a search for the mirror of a mesh came to: one value, told to a modeller or to a machine.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <quadmatch/report/report.hpp>
#include <quadmatch/use/symmetry.hpp>

#include "match_report.hpp"

namespace quadmatch::cli {

/// A connected area of faces without partner.
struct LonelyArea {
  std::vector<FaceId> faces;  ///< ascending
  /// Where its middle is, beside the plane: "on the +x side"; empty where there is no plane.
  std::string place;
};

/// What --symmetrize wrote.
struct SymmetrizeSummary {
  std::string output;
  std::string side;  ///< as it was asked for: "+x"
  std::uint32_t moved = 0;
  double farthest = 0;
  bool with_positions = false;
  std::vector<std::pair<std::string, std::uint32_t>> copied;  ///< attributes and how many elements took them
};

struct SymmetrySummary {
  std::string path;
  Symmetry symmetry;
  std::vector<LonelyArea> lonely;  ///< from the largest
  std::vector<std::pair<std::string, std::string>> settings;
  Times times;                        ///< matching: the search
  std::string output;                 ///< where the map was written; empty: nowhere
  std::string page;                   ///< where the HTML report was written; empty: nowhere
  std::vector<std::string> pictures;  ///< files of the image, if there is one
  std::optional<SymmetrizeSummary> symmetrized;
};

[[nodiscard]] std::vector<LonelyArea> lonely_areas(const Mesh& mesh, const Symmetry& symmetry);

/// The field `symmetry` of a map file: centre line, what has no partner, the plane, and how many mirrors there are.
[[nodiscard]] std::string map_field(const Symmetry& symmetry);

/// The mirror as pictures show it: cut along the centre line, so that each side is a region of its own, next to the one
/// opposite, and what lies on the line is a third. What is said of a region of the mirror is said of its pieces.
[[nodiscard]] Match cut_along_line(const Mesh& mesh, const Symmetry& symmetry);

/// What the HTML report says of it: the centre line and every area without partner, to fly to.
[[nodiscard]] ReportText report_text(const Mesh& mesh, const SymmetrySummary& summary);

[[nodiscard]] std::string as_text(const SymmetrySummary& summary);
[[nodiscard]] std::string as_json(const SymmetrySummary& summary);

}  // namespace quadmatch::cli
