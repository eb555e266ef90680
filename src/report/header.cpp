#include "header.hpp"

#include <nlohmann/json.hpp>

namespace quadmatch::report {
namespace {

using Json = nlohmann::ordered_json;

const char* to_string(Precision precision) {
  switch (precision) {
    case Precision::Grid:
      return "grid";
    case Precision::Float32:
      return "float32";
    default:
      return "none";
  }
}

Json mesh_json(const MeshHeader& mesh) {
  return {{"path", mesh.path},
          {"vertices", mesh.vertices},
          {"faces", mesh.faces},
          {"corners", mesh.corners},
          {"all_quads", mesh.all_quads},
          {"positions", to_string(mesh.precision)},
          {"corner_bits", mesh.corner_bits},
          {"low", mesh.low},
          {"step", mesh.step},
          {"names", mesh.names}};
}

Json region_json(const Region& region) {
  return {{"orientation", region.orientation == Orientation::Reversing ? "reversing" : "preserving"},
          {"faces", region.faces.size()},
          {"confidence", region.evidence.confidence()},
          {"agreeing", region.evidence.agreeing},
          {"source_extraordinary", region.evidence.source_extraordinary},
          {"target_extraordinary", region.evidence.target_extraordinary},
          {"ways", region.ways},
          {"ambiguous", region.ambiguous}};
}

/// Can stand inside a script element: nothing in it looks like the end of one, or like a comment.
std::string escaped(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

}  // namespace

std::string format_header(const MeshHeader& source, const MeshHeader& target, const Match& match,
                          const ReportText& text, const Blocks& blocks) {
  Json regions = Json::array();
  for (const Region& region : match.regions) regions.push_back(region_json(region));
  Json figures = Json::array();
  for (const ReportFigure& figure : text.figures) figures.push_back({figure.name, figure.text});
  Json changes = Json::array();
  for (const ReportChange& change : text.changes) changes.push_back({change.kind, change.sentence});
  Json sizes = Json::array();
  for (const Blocks::Block& block : blocks.list()) sizes.push_back({block.name, block.size});
  const Json header = {{"format", "quadmatch.report/1"},
                       {"title", text.title},
                       {"program", text.program},
                       {"mirror", text.mirror},
                       {"source", mesh_json(source)},
                       {"target", mesh_json(target)},
                       {"regions", regions},
                       {"figures", figures},
                       {"changes", changes},
                       {"blocks", sizes}};
  return escaped(header.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace quadmatch::report
