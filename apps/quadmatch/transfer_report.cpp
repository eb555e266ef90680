#include "transfer_report.hpp"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_record(const TransferredAttribute& attribute) {
  return attribute.domain == Domain::Face && is_one_of(attribute.name, {"o", "g", "s", "usemtl"});
}

/// Does a format have a place for it (docs/formats.md)?
bool holds(Format format, const TransferredAttribute& attribute) {
  const std::string_view name = attribute.name;
  const bool vertex = attribute.domain == Domain::Vertex;
  const bool pool = attribute.domain == Domain::Corner && is_one_of(name, {"texture coordinates", "normals"});
  const bool colour = vertex && is_one_of(name, {"red", "green", "blue", "alpha"});
  if (vertex && name == "positions") return true;
  switch (format) {
    case Format::Obj:
      return pool || is_record(attribute) || colour || (vertex && name == "w");
    case Format::Ply:
      return attribute.domain == Domain::Corner ? name == "texture coordinates" : !is_record(attribute);
    case Format::Off:
      return colour || (vertex && is_one_of(name, {"nx", "ny", "nz", "s", "t"}));
    case Format::Usda:
      return pool || (is_record(attribute) && name == "o");
  }
  return true;
}

const char* name_of(Format format) {
  switch (format) {
    case Format::Obj:
      return "OBJ";
    case Format::Ply:
      return "PLY";
    case Format::Off:
      return "OFF";
    case Format::Usda:
      break;
  }
  return "USD";
}

const char* elements_of(Domain domain) {
  return domain == Domain::Vertex ? "vertices" : domain == Domain::Face ? "faces" : "corners";
}

std::string title(const TransferredAttribute& attribute) {
  if (!is_record(attribute)) return attribute.name;
  return attribute.name == "o"   ? "objects (o)"
         : attribute.name == "g" ? "groups (g)"
         : attribute.name == "s" ? "smoothing (s)"
                                 : "materials (usemtl)";
}

std::string describe(const TransferredAttribute& attribute) {
  const std::uint32_t all = attribute.carried + attribute.kept + attribute.filled + attribute.without;
  std::string text = fmt::format("{}: {}", title(attribute), grouped(attribute.carried));
  if (attribute.carried == all) return fmt::format("{} {}, all of them", text, elements_of(attribute.domain));
  text += fmt::format(" of {} {}", grouped(all), elements_of(attribute.domain));
  if (attribute.kept > 0) text += fmt::format("; {} keep their own", grouped(attribute.kept));
  if (attribute.filled > 0) text += fmt::format("; {} filled in", grouped(attribute.filled));
  if (attribute.without > 0) text += fmt::format("; {} have none", grouped(attribute.without));
  return text;
}

void add_attributes(Lines& lines, const std::vector<TransferredAttribute>& attributes) {
  for (std::size_t k = 0; k < attributes.size(); ++k) {
    lines.add(k == 0 ? "carried" : "", describe(attributes[k]));
    for (const std::string& remark : attributes[k].remarks) lines.add("", "  " + remark);
  }
}

void add_left_out(Lines& lines, const std::vector<LeftOutRegion>& regions) {
  constexpr std::size_t kMostLines = 6;
  const std::size_t shown = regions.size() <= kMostLines + 1 ? regions.size() : kMostLines;
  for (std::size_t k = 0; k < shown; ++k) lines.add(k == 0 ? "left out" : "", cli::describe(regions[k]));
  if (shown == regions.size()) return;
  std::uint64_t faces = 0;
  for (std::size_t k = shown; k < regions.size(); ++k) faces += regions[k].faces;
  lines.add("", fmt::format("and {} more parts, {} in all", regions.size() - shown, counted(faces, "face")));
}

std::uint32_t left_out_faces(const TransferReport& report) {
  std::uint32_t faces = 0;
  for (const LeftOutRegion& region : report.left_out) faces += region.faces;
  return faces;
}

std::string describe_target(const TransferSummary& summary) {
  const TransferReport& report = summary.report;
  const std::string faces = fmt::format("{}: {}", display_name(summary.target), counted(report.faces, "face"));
  if (report.complete()) return faces + ", all of it takes the source's data";
  std::string text = fmt::format("{}, {} take the source's data", faces, percent(report.matched_faces, report.faces));
  const std::uint32_t unmatched = report.faces - report.matched_faces - left_out_faces(report);
  if (unmatched > 0) text += fmt::format(", {} not found in the source", grouped(unmatched));
  return text;
}

std::string describe_order(const TransferSummary& summary) {
  if (summary.report.complete() && summary.source_faces == summary.report.faces) {
    return summary.report.reversing ? "as the source's; faces are wound the other way"
                                    : "as the source's, element by element";
  }
  return "matched elements as in the source, the others behind them";
}

Json attribute_json(const TransferredAttribute& attribute) {
  return {{"name", attribute.name},       {"elements", elements_of(attribute.domain)},
          {"carried", attribute.carried}, {"kept", attribute.kept},
          {"filled", attribute.filled},   {"without", attribute.without},
          {"remarks", attribute.remarks}};
}

Json left_out_json(const LeftOutRegion& region) {
  return {{"reason", region.reason == LeftOutRegion::Reason::Ambiguous ? "ambiguous" : "low confidence"},
          {"region", region.region},
          {"faces", region.faces},
          {"first_source", region.first_source.value},
          {"first_target", region.first_target.value},
          {"ways", region.ways},
          {"confidence", region.confidence}};
}

}  // namespace

std::vector<std::string> TransferSummary::not_written() const {
  std::vector<std::string> names;
  for (const TransferredAttribute& attribute : report.attributes) {
    if (attribute.carried + attribute.filled > 0 && !holds(format, attribute)) names.push_back(title(attribute));
  }
  return names;
}

std::string describe(const LeftOutRegion& region) {
  const std::string place =
      fmt::format("{} of the target from f{} on, f{} of the source", counted(region.faces, "face"),
                  region.first_target.value, region.first_source.value);
  if (region.reason == LeftOutRegion::Reason::Ambiguous) {
    return fmt::format("{}: one of {} ways to lay them; --allow-ambiguous carries all the same", place,
                       grouped(region.ways));
  }
  return fmt::format("{}: a confidence of {:.2f} only", place, region.confidence);
}

std::string as_text(const TransferSummary& summary) {
  Lines lines;
  lines.add("source", fmt::format("{}: {}", display_name(summary.source), counted(summary.source_faces, "face")));
  lines.add("target", describe_target(summary));
  add_attributes(lines, summary.report.attributes);
  add_left_out(lines, summary.report.left_out);
  if (summary.options.order) lines.add("order", describe_order(summary));
  if (const std::vector<std::string> lost = summary.not_written(); !lost.empty()) {
    lines.add("not kept",
              fmt::format("{} has no place for {}; choose another format", name_of(summary.format), joined(lost)));
  }
  lines.add("time", fmt::format("reading {}, matching and carrying {}, writing {}", duration(summary.times.reading),
                                duration(summary.times.matching), duration(summary.times.writing)));
  if (summary.output != "-") lines.add("written", summary.output);
  return lines.render();
}

std::string as_json(const TransferSummary& summary) {
  const TransferReport& report = summary.report;
  Json attributes = Json::array(), left_out = Json::array(), settings = Json::object();
  for (const TransferredAttribute& attribute : report.attributes) attributes.push_back(attribute_json(attribute));
  for (const LeftOutRegion& region : report.left_out) left_out.push_back(left_out_json(region));
  for (const auto& [name, value] : summary.settings) settings[name] = value;
  return json_text({{"source", {{"path", summary.source}, {"faces", summary.source_faces}}},
                    {"target",
                     {{"path", summary.target},
                      {"faces", report.faces},
                      {"vertices", report.vertices},
                      {"matched_faces", report.matched_faces},
                      {"matched_vertices", report.matched_vertices}}},
                    {"complete", summary.complete()},
                    {"attributes", attributes},
                    {"left_out", left_out},
                    {"reversing", report.reversing},
                    {"not_written", summary.not_written()},
                    {"settings", settings},
                    {"milliseconds",
                     {{"reading", rounded(summary.times.reading)},
                      {"matching", rounded(summary.times.matching)},
                      {"writing", rounded(summary.times.writing)}}},
                    {"output", summary.output}});
}

}  // namespace quadmatch::cli
