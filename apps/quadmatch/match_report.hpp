#pragma once
/// What a match came to: one value, told to a modeller or to a machine.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/report/report.hpp>

namespace quadmatch::cli {

struct SideReport {
  std::string path;
  std::uint32_t vertices = 0;
  std::uint32_t faces = 0;
  std::uint32_t matched_faces = 0;
  /// Connected areas of faces that were not matched.
  std::uint32_t unmatched_areas = 0;

  [[nodiscard]] std::uint32_t unmatched_faces() const { return faces - matched_faces; }
};

/// The anchor that was grown from.
struct SeedReport {
  FaceId source_face, target_face;
  std::uint32_t source_corner = 0, target_corner = 0;
  bool given = false;      ///< by the user
  bool arbitrary = false;  ///< no vertex stands out, so any pair was taken
  std::uint32_t rounds = 0;
  std::uint32_t source_rarity = 0, target_rarity = 0;
};

struct RegionReport {
  Orientation orientation = Orientation::Preserving;
  std::uint32_t faces = 0;
  Evidence evidence;
  std::uint32_t ways = 1;  ///< maps of it that are as good
  bool ambiguous = false;
};

/// In milliseconds.
struct Times {
  double reading = 0, matching = 0, verifying = 0, writing = 0;
};

struct MatchReport {
  SideReport source, target;
  std::vector<RegionReport> regions;
  std::uint32_t matched_vertices = 0;
  std::optional<SeedReport> seed;
  std::vector<std::pair<std::string, std::string>> settings;
  /// What an exact search proved.
  std::optional<Optimality> optimality;
  Times times;
  std::string output;                 ///< where the match file was written; empty: nowhere
  std::string page;                   ///< where the HTML report was written; empty: nowhere
  std::vector<std::string> pictures;  ///< files of the image and the animation, if there are any

  [[nodiscard]] std::uint32_t matched_faces() const { return source.matched_faces; }
  /// Those of regions that are ambiguous.
  [[nodiscard]] std::uint32_t ambiguous_faces() const;
};

/// @param anchors_given  the user named the anchors.
[[nodiscard]] MatchReport report_match(const Mesh& source, const Mesh& target, const MatchResult& result,
                                       bool anchors_given);

/// What the summary says, line by line, but for times and files.
[[nodiscard]] std::vector<ReportFigure> figures_of(const MatchReport& report);
[[nodiscard]] std::string as_text(const MatchReport& report);
[[nodiscard]] std::string as_json(const MatchReport& report);

}  // namespace quadmatch::cli
