#include "merge_report.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr std::size_t kMostLines = 6;

const char* name_of(Side side) { return side == Side::Ours ? "OURS" : "THEIRS"; }
const char* option_of(Side side) { return side == Side::Ours ? "ours" : "theirs"; }
Side other(Side side) { return side == Side::Ours ? Side::Theirs : Side::Ours; }

const char* elements_of(Domain domain) {
  return domain == Domain::Vertex ? "vertices" : domain == Domain::Face ? "faces" : "corners";
}

const char* element_of(Domain domain) {
  return domain == Domain::Vertex ? "vertex" : domain == Domain::Face ? "face" : "corner";
}

std::string title(const std::string& name, Domain domain) {
  if (domain != Domain::Face) return name;
  return name == "o"        ? "objects (o)"
         : name == "g"      ? "groups (g)"
         : name == "s"      ? "smoothing (s)"
         : name == "usemtl" ? "materials (usemtl)"
                            : name;
}

/// "removed 3 faces, added 12, joined others at 8 vertices, moved 40".
std::string describe(const SideChanges& changes) {
  std::vector<std::string> parts;
  if (changes.removed_faces > 0) parts.push_back(fmt::format("{} removed", counted(changes.removed_faces, "face")));
  if (changes.added_faces > 0) parts.push_back(fmt::format("{} added", counted(changes.added_faces, "face")));
  if (changes.connectivity() && changes.removed_faces + changes.added_faces == 0) {
    parts.push_back(
        fmt::format("faces joined in another way at {}", counted(changes.changed_vertices, "vertex", "vertices")));
  }
  if (changes.moved_vertices > 0) {
    parts.push_back(fmt::format("{} moved", counted(changes.moved_vertices, "vertex", "vertices")));
  }
  return parts.empty() ? "nothing removed, added or moved" : joined(parts);
}

std::string describe_side(const std::string& path, std::uint32_t faces, const SideChanges& changes) {
  return fmt::format("{}: {}; {}", display_name(path), counted(faces, "face"), describe(changes));
}

/// "f3, f4, f9 and 12 more".
template <class Id>
std::string listed(const std::vector<Id>& ids) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < ids.size() && k < kMost; ++k) names.push_back(to_string(ids[k]));
  const std::string text = joined(names);
  return ids.size() <= kMost ? text : fmt::format("{} and {} more", text, grouped(ids.size() - kMost));
}

std::string describe(const MergedAttribute& attribute) {
  std::vector<std::string> parts;
  if (attribute.from_ours > 0) parts.push_back(fmt::format("{} from OURS", grouped(attribute.from_ours)));
  if (attribute.from_theirs > 0) parts.push_back(fmt::format("{} from THEIRS", grouped(attribute.from_theirs)));
  const std::string text = title(attribute.name, attribute.domain);
  if (parts.empty()) return text;
  return fmt::format("{}: {} changed, {}", text, elements_of(attribute.domain), joined(parts));
}

/// The first lines of many.
template <class Entries>
void add_some(std::vector<ReportFigure>& lines, const char* name, const Entries& entries, const char* noun) {
  const std::size_t shown = entries.size() <= kMostLines + 1 ? entries.size() : kMostLines;
  for (std::size_t k = 0; k < shown; ++k) lines.push_back({k == 0 ? name : "", cli::describe(entries[k])});
  if (shown < entries.size()) lines.push_back({"", fmt::format("and {} more {}", entries.size() - shown, noun)});
}

std::string describe_result(const MergeSummary& summary) {
  std::vector<std::string> parts{fmt::format("{} from all", grouped(summary.from_all))};
  if (summary.from_ours > 0) parts.push_back(fmt::format("{} of OURS", grouped(summary.from_ours)));
  if (summary.from_theirs > 0) parts.push_back(fmt::format("{} of THEIRS", grouped(summary.from_theirs)));
  if (summary.from_both > 0) parts.push_back(fmt::format("{} that both added", grouped(summary.from_both)));
  if (summary.from_one_and_base > 0) {
    parts.push_back(
        fmt::format("{} that {} removed", grouped(summary.from_one_and_base), name_of(other(summary.prefer))));
  }
  return fmt::format("{}: {}", counted(summary.merged_faces, "face"), joined(parts));
}

std::string describe_conflicts(const MergeSummary& summary) {
  const MergeReport& report = summary.report;
  if (report.clean()) return "none";
  std::vector<std::string> parts;
  if (!report.areas.empty()) {
    parts.push_back(fmt::format("{} where edits meet", counted(report.areas.size(), "area")));
  }
  if (!report.values.empty()) {
    parts.push_back(fmt::format("{} of data", counted(report.values.size(), "kind")));
  }
  return fmt::format("{}; there OUT holds {}", joined(parts), name_of(summary.prefer));
}

Json area_json(const ConflictArea& area) {
  return {{"base_vertices", numbers(area.base_vertices)},     {"base_faces", numbers(area.base_faces)},
          {"ours_faces", numbers(area.ours_faces)},           {"theirs_faces", numbers(area.theirs_faces)},
          {"merged_vertices", numbers(area.merged_vertices)}, {"centre", area.centre}};
}

Json side_json(const std::string& path, std::uint32_t faces, const SideChanges& changes) {
  return {{"path", path},
          {"faces", faces},
          {"matched_faces", changes.matched_faces},
          {"removed_faces", changes.removed_faces},
          {"added_faces", changes.added_faces},
          {"changed_vertices", changes.changed_vertices},
          {"moved_vertices", changes.moved_vertices}};
}

Json doubtful_json(const DoubtfulPart& part) {
  return {{"side", option_of(part.side)},
          {"reason", part.ambiguous ? "ambiguous" : "low confidence"},
          {"region", part.region},
          {"faces", part.faces},
          {"first_base", part.first_base.value},
          {"first_side", part.first_side.value},
          {"ways", part.ways},
          {"confidence", part.confidence}};
}

/// A number, or null where the mesh has no such face.
Json number(FaceId face) { return face.valid() ? Json(face.value) : Json(nullptr); }

}  // namespace

void count_origins(const Merged& merged, MergeSummary& summary) {
  for (const InThree<FaceId>& origin : merged.face_origins) {
    const bool base = origin[Side::Base].valid(), ours = origin[Side::Ours].valid();
    const bool theirs = origin[Side::Theirs].valid();
    if (ours && theirs) {
      ++(base ? summary.from_all : summary.from_both);
    } else if (base) {
      ++summary.from_one_and_base;
    } else {
      ++(ours ? summary.from_ours : summary.from_theirs);
    }
  }
  summary.merged_faces = merged.file.mesh.face_count();
  summary.merged_vertices = merged.file.mesh.vertex_count();
}

std::string describe(const ConflictArea& area) {
  std::vector<std::string> parts;
  if (!area.base_vertices.empty()) parts.push_back(fmt::format("{} of BASE", listed(area.base_vertices)));
  if (!area.base_faces.empty()) parts.push_back(fmt::format("{} of BASE removed by one side", listed(area.base_faces)));
  if (!area.ours_faces.empty()) parts.push_back(fmt::format("{} of OURS", listed(area.ours_faces)));
  if (!area.theirs_faces.empty()) parts.push_back(fmt::format("{} of THEIRS", listed(area.theirs_faces)));
  return fmt::format("{}; about ({:.4g}, {:.4g}, {:.4g})", joined(parts, "; "), area.centre[0], area.centre[1],
                     area.centre[2]);
}

std::string describe(const ValueConflict& conflict) {
  std::vector<std::string> names;
  constexpr std::size_t kMost = 3;
  const char letter = conflict.domain == Domain::Vertex ? 'v' : conflict.domain == Domain::Face ? 'f' : 'h';
  for (std::size_t k = 0; k < conflict.first.size() && k < kMost; ++k) {
    names.push_back(fmt::format("{}{}", letter, conflict.first[k]));
  }
  const std::string more = conflict.count > names.size() ? " ..." : "";
  return fmt::format(
      "{}: both sides changed {}, to different values: {}{} of OUT", title(conflict.name, conflict.domain),
      counted(conflict.count, element_of(conflict.domain), elements_of(conflict.domain)), joined(names), more);
}

/// "3 faces of OURS from f12 on, f3 of BASE: one of 2 ways to lay them, and THEIRS changed something there".
std::string describe(const DoubtfulPart& part) {
  const std::string place = fmt::format("{} of {} from f{} on, f{} of BASE", counted(part.faces, "face"),
                                        name_of(part.side), part.first_side.value, part.first_base.value);
  const std::string why = part.ambiguous ? fmt::format("one of {} ways to lay them", grouped(part.ways))
                                         : fmt::format("a confidence of {:.2f} only", part.confidence);
  return fmt::format("{}: {}, and {} changed something there", place, why, name_of(other(part.side)));
}

std::vector<ReportFigure> figures_of(const MergeSummary& summary) {
  const MergeReport& report = summary.report;
  std::vector<ReportFigure> lines{
      {"base", fmt::format("{}: {}", display_name(summary.base), counted(summary.base_faces, "face"))},
      {"ours", describe_side(summary.ours, summary.ours_faces, report.ours)},
      {"theirs", describe_side(summary.theirs, summary.theirs_faces, report.theirs)},
      {"merged", describe_result(summary)}};
  for (std::size_t k = 0; k < report.attributes.size(); ++k) {
    lines.push_back({k == 0 ? "data" : "", describe(report.attributes[k])});
    for (const std::string& remark : report.attributes[k].remarks) lines.push_back({"", "  " + remark});
  }
  if (report.carried_along > 0) {
    lines.push_back({"moved", fmt::format("{} carried along by what the other side moved",
                                          counted(report.carried_along, "vertex", "vertices"))});
  }
  lines.push_back({"conflicts", describe_conflicts(summary)});
  add_some(lines, "", report.areas, "areas");
  add_some(lines, "", report.values, "kinds of data");
  add_some(lines, "doubtful", report.doubtful, "parts");
  for (const DepartureKind kind : report.new_departures) {
    lines.push_back({"check", fmt::format("more of {} than the sides have; see quadmatch check", to_string(kind))});
  }
  return lines;
}

std::string as_text(const MergeSummary& summary) {
  Lines lines;
  for (ReportFigure& figure : figures_of(summary)) lines.add(std::move(figure.name), std::move(figure.text));
  lines.add("time", fmt::format("reading {}, matching {}, merging {}, writing {}", duration(summary.times.reading),
                                duration(summary.times.matching), duration(summary.times.merging),
                                duration(summary.times.writing)));
  add_written(lines, {summary.output == "-" ? "" : summary.output, summary.page}, summary.pictures);
  return lines.render();
}

std::string as_json(const MergeSummary& summary) {
  const MergeReport& report = summary.report;
  Json areas = Json::array(), values = Json::array(), attributes = Json::array(), doubtful = Json::array();
  Json departures = Json::array(), settings = Json::object();
  for (const ConflictArea& area : report.areas) areas.push_back(area_json(area));
  for (const ValueConflict& value : report.values) {
    values.push_back({{"name", value.name},
                      {"elements", elements_of(value.domain)},
                      {"count", value.count},
                      {"first", value.first}});
  }
  for (const MergedAttribute& attribute : report.attributes) {
    attributes.push_back({{"name", attribute.name},
                          {"elements", elements_of(attribute.domain)},
                          {"from_ours", attribute.from_ours},
                          {"from_theirs", attribute.from_theirs},
                          {"remarks", attribute.remarks}});
  }
  for (const DoubtfulPart& part : report.doubtful) doubtful.push_back(doubtful_json(part));
  for (const DepartureKind kind : report.new_departures) departures.push_back(to_string(kind));
  for (const auto& [name, value] : summary.settings) settings[name] = value;
  Json json{{"base", {{"path", summary.base}, {"faces", summary.base_faces}}},
            {"ours", side_json(summary.ours, summary.ours_faces, report.ours)},
            {"theirs", side_json(summary.theirs, summary.theirs_faces, report.theirs)},
            {"merged",
             {{"vertices", summary.merged_vertices},
              {"faces", summary.merged_faces},
              {"from_all", summary.from_all},
              {"from_ours", summary.from_ours},
              {"from_theirs", summary.from_theirs},
              {"from_both_sides", summary.from_both},
              {"from_base_and_one_side", summary.from_one_and_base},
              {"carried_along_vertices", report.carried_along},
              {"new_departures", departures}}},
            {"clean", report.clean()},
            {"prefer", option_of(summary.prefer)},
            {"areas", areas},
            {"values", values},
            {"attributes", attributes},
            {"doubtful", doubtful},
            {"settings", settings},
            {"milliseconds",
             {{"reading", rounded(summary.times.reading)},
              {"matching", rounded(summary.times.matching)},
              {"merging", rounded(summary.times.merging)},
              {"writing", rounded(summary.times.writing)}}},
            {"output", summary.output},
            {"report", summary.page.empty() ? Json(nullptr) : Json(summary.page)},
            {"pictures", summary.pictures}};
  if (!summary.origins.empty()) {
    Json origins = Json::array();
    for (const InThree<FaceId>& origin : summary.origins) {
      origins.push_back({number(origin[Side::Base]), number(origin[Side::Ours]), number(origin[Side::Theirs])});
    }
    json["origins"] = origins;
  }
  return json_text(json);
}

}  // namespace quadmatch::cli
