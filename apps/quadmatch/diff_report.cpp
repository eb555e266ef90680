#include "diff_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "html_report.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr std::size_t kMostLines = 12;
constexpr std::size_t kMostIds = 4;

/// "f12, f13, f19, ... of the source".
template <class IdType>
std::string some_of(const std::vector<IdType>& ids, std::string_view mesh) {
  std::vector<std::string> names;
  for (std::size_t k = 0; k < std::min(ids.size(), kMostIds); ++k) names.push_back(to_string(ids[k]));
  if (ids.size() > kMostIds) names.emplace_back("...");
  return fmt::format("{} of the {}", joined(names), mesh);
}

std::string what_happened(const Change& change) {
  std::vector<std::string> parts;
  if (change.rows > 0) parts.push_back(counted(change.rows, "row"));
  const bool added = !change.target_faces.empty(), removed = !change.source_faces.empty();
  if (added && removed) {
    parts.push_back(fmt::format("{} in place of {}", counted(change.target_faces.size(), "face"),
                                grouped(change.source_faces.size())));
  } else if (added) {
    parts.push_back(counted(change.target_faces.size(), "face") + " added");
  } else if (removed) {
    parts.push_back(counted(change.source_faces.size(), "face") + " removed");
  } else if (change.edges > 0) {
    parts.push_back(fmt::format("along {}", counted(change.edges, "edge")));
  } else {
    parts.emplace_back("at a vertex");
  }
  return joined(parts);
}

std::string where_it_is(const Change& change) {
  std::vector<std::string> parts;
  if (!change.source_faces.empty()) parts.push_back(some_of(change.source_faces, "source"));
  if (!change.target_faces.empty()) parts.push_back(some_of(change.target_faces, "target"));
  if (parts.empty()) parts.push_back("beside " + some_of(change.rejoined, "source"));
  return joined(parts, "; ");
}

std::string sentence_of(const Change& change) {
  return fmt::format("{}: {}", what_happened(change), where_it_is(change));
}

void add_changes(Lines& lines, const std::vector<Change>& changes) {
  const std::size_t shown = changes.size() <= kMostLines + 1 ? changes.size() : kMostLines;
  for (std::size_t k = 0; k < shown; ++k) {
    lines.add(to_string(changes[k].kind), sentence_of(changes[k]));
  }
  if (shown == changes.size()) return;
  lines.add("", fmt::format("and {} smaller changes; --json lists them all", grouped(changes.size() - shown)));
}

/// "2,904 the same, 24 added, 40 removed", leaving out what there is none of.
std::string balance(std::uint32_t same, const std::vector<std::pair<std::uint32_t, const char*>>& others) {
  std::vector<std::string> parts{fmt::format("{} the same", grouped(same))};
  for (const auto& [count, what] : others) {
    if (count > 0) parts.push_back(fmt::format("{} {}", grouped(count), what));
  }
  return joined(parts);
}

std::string describe(const WholeMotion& motion) {
  std::vector<std::string> parts;
  if (motion.mirrored) parts.emplace_back("mirrored");
  if (motion.degrees >= 0.05) parts.push_back(fmt::format("turned by {:.1f} degrees", motion.degrees));
  if (std::abs(motion.scale - 1) >= 5e-5) parts.push_back(fmt::format("scaled by {:.4g}", motion.scale));
  if (motion.shift > 0) parts.push_back(fmt::format("its centre shifted by {:.4g}", motion.shift));
  return "the whole moved as one body: " + joined(parts);
}

std::string describe(const DoubtfulRegion& region) {
  const std::string place =
      fmt::format("{} from f{} of the source and f{} of the target on", counted(region.faces, "face"),
                  region.first_source.value, region.first_target.value);
  if (region.left_out) return fmt::format("{}: left out, a confidence of {:.2f} only", place, region.confidence);
  return fmt::format("{}: one of {} ways to lay them", place, grouped(region.ways));
}

void add_doubts(std::vector<ReportFigure>& figures, const std::vector<DoubtfulRegion>& doubtful) {
  constexpr std::size_t kMostDoubts = 6;
  const std::size_t shown = doubtful.size() <= kMostDoubts + 1 ? doubtful.size() : kMostDoubts;
  for (std::size_t k = 0; k < shown; ++k) figures.push_back({"doubt", describe(doubtful[k])});
  if (shown < doubtful.size()) {
    figures.push_back({"", fmt::format("and {} more regions", grouped(doubtful.size() - shown))});
  }
}

/// How many changes of each kind, in the order of the kinds.
std::map<ChangeKind, std::size_t> kinds_of(const Difference& difference) {
  std::map<ChangeKind, std::size_t> kinds;
  for (const Change& change : difference.changes) ++kinds[change.kind];
  return kinds;
}

Json change_json(const Change& change) {
  return {{"kind", to_string(change.kind)},
          {"size", change.size()},
          {"rows", change.rows},
          {"edges", change.edges},
          {"source_faces", numbers(change.source_faces)},
          {"target_faces", numbers(change.target_faces)},
          {"rejoined_source_faces", numbers(change.rejoined)},
          {"source_vertices", numbers(change.source_vertices)},
          {"target_vertices", numbers(change.target_vertices)}};
}

Json doubt_json(const DoubtfulRegion& region) {
  return {{"reason", region.ambiguous ? "ambiguous" : "low confidence"},
          {"region", region.region},
          {"faces", region.faces},
          {"first_source", region.first_source.value},
          {"first_target", region.first_target.value},
          {"ways", region.ways},
          {"confidence", region.confidence},
          {"left_out", region.left_out}};
}

Json motion_json(const std::optional<WholeMotion>& motion) {
  if (!motion) return nullptr;
  return {
      {"degrees", motion->degrees}, {"scale", motion->scale}, {"mirrored", motion->mirrored}, {"shift", motion->shift}};
}

Json totals_json(const Difference& difference) {
  const DiffTotals& totals = difference.totals;
  return {{"faces",
           {{"same", totals.matched_faces},
            {"added", totals.added_faces()},
            {"removed", totals.removed_faces()},
            {"rejoined", totals.rejoined_faces},
            {"turned", totals.turned_faces}}},
          {"vertices",
           {{"same", totals.matched_vertices},
            {"added", totals.added_vertices()},
            {"removed", totals.removed_vertices()},
            {"moved", difference.moved.size()}}}};
}

/// Sizes, and how much of them is the same.
std::vector<ReportFigure> figures_of(const DiffSummary& summary) {
  const Difference& difference = summary.difference;
  const DiffTotals& totals = difference.totals;
  const auto side = [](const std::string& name, std::uint32_t faces, std::uint32_t vertices) {
    return fmt::format("{}: {}, {}", display_name(name), counted(faces, "face"),
                       counted(vertices, "vertex", "vertices"));
  };
  std::vector<ReportFigure> figures{
      {"source", side(summary.source, totals.source_faces, totals.source_vertices)},
      {"target", side(summary.target, totals.target_faces, totals.target_vertices)},
      {"faces", balance(totals.matched_faces, {{totals.rejoined_faces, "of them joined otherwise"},
                                               {totals.turned_faces, "of them turned over"},
                                               {totals.added_faces(), "added"},
                                               {totals.removed_faces(), "removed"}})},
      {"vertices",
       balance(totals.matched_vertices, {{static_cast<std::uint32_t>(difference.moved.size()), "of them moved"},
                                         {totals.added_vertices(), "added"},
                                         {totals.removed_vertices(), "removed"}})}};
  if (difference.whole_motion) figures.push_back({"motion", describe(*difference.whole_motion)});
  return figures;
}

}  // namespace

std::string as_text(const DiffSummary& summary) {
  const Difference& difference = summary.difference;
  Lines lines;
  for (ReportFigure& figure : figures_of(summary)) lines.add(std::move(figure.name), std::move(figure.text));
  add_changes(lines, difference.changes);
  std::vector<ReportFigure> doubts;
  add_doubts(doubts, difference.doubtful);
  for (ReportFigure& doubt : doubts) lines.add(std::move(doubt.name), std::move(doubt.text));
  lines.add("time", fmt::format("reading {}, matching and comparing {}", duration(summary.times.reading),
                                duration(summary.times.matching)));
  add_written(lines, {summary.page}, summary.pictures);
  return (difference.none() ? "no differences\n" : "different\n") + lines.render(2);
}

ReportText report_text(const DiffSummary& summary) {
  ReportText text{.title = report_title(summary.source, summary.target),
                  .program = "quadmatch " QUADMATCH_VERSION,
                  .figures = figures_of(summary)};
  add_doubts(text.figures, summary.difference.doubtful);
  for (const Change& change : summary.difference.changes) {
    const bool all_matched = change.source_faces.empty() && change.target_faces.empty();
    text.changes.push_back({to_string(change.kind), all_matched ? change.rejoined : change.source_faces,
                            change.target_faces, sentence_of(change)});
  }
  return text;
}

std::string as_stat(const DiffSummary& summary) {
  const Difference& difference = summary.difference;
  const DiffTotals& totals = difference.totals;
  std::vector<std::string> kinds;
  for (const auto& [kind, count] : kinds_of(difference)) {
    std::string name = to_string(kind);
    std::replace(name.begin(), name.end(), ' ', '-');
    kinds.push_back(fmt::format("{}:{}", name, count));
  }
  return fmt::format(
      "changes={} faces_added={} faces_removed={} faces_rejoined={} faces_turned={} vertices_added={} "
      "vertices_removed={} vertices_moved={} kinds={}\n",
      difference.changes.size(), totals.added_faces(), totals.removed_faces(), totals.rejoined_faces,
      totals.turned_faces, totals.added_vertices(), totals.removed_vertices(), difference.moved.size(),
      joined(kinds, ","));
}

std::string as_json(const DiffSummary& summary) {
  const Difference& difference = summary.difference;
  const DiffTotals& totals = difference.totals;
  Json changes = Json::array(), doubtful = Json::array(), moved = Json::array(), settings = Json::object();
  for (const Change& change : difference.changes) changes.push_back(change_json(change));
  for (const DoubtfulRegion& region : difference.doubtful) doubtful.push_back(doubt_json(region));
  for (const VertexPair& pair : difference.moved) moved.push_back({pair.source.value, pair.target.value});
  for (const auto& [name, value] : summary.settings) settings[name] = value;
  return json_text(
      {{"same", difference.none()},
       {"source", {{"path", summary.source}, {"faces", totals.source_faces}, {"vertices", totals.source_vertices}}},
       {"target", {{"path", summary.target}, {"faces", totals.target_faces}, {"vertices", totals.target_vertices}}},
       {"totals", totals_json(difference)},
       {"changes", changes},
       {"moved", moved},
       {"whole_motion", motion_json(difference.whole_motion)},
       {"doubtful", doubtful},
       {"settings", settings},
       {"milliseconds", {{"reading", rounded(summary.times.reading)}, {"matching", rounded(summary.times.matching)}}},
       {"report", summary.page.empty() ? Json(nullptr) : Json(summary.page)},
       {"pictures", summary.pictures}});
}

}  // namespace quadmatch::cli
