// quadmatch diff A B --isomorphic: are two whole meshes the same up to numbering, in how many ways, or what is
// different?

#include <map>

#include <fmt/format.h>

#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/verify/verify.hpp>

#include "console.hpp"
#include "diff_arguments.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

const std::map<std::string, IsomorphismKind> kOrientations{{"auto", IsomorphismKind::Either},
                                                           {"preserving", IsomorphismKind::Preserving},
                                                           {"reversing", IsomorphismKind::Reversing}};

const char* name_of(Orientation orientation) {
  return orientation == Orientation::Preserving ? "preserving" : "reversing";
}

/// "the only map", "one of 24 maps", "one of 24^10000 * 10000! maps, a number of 49,462 digits".
std::string describe_ways(const GroupOrder& ways) {
  if (const auto number = ways.value()) {
    return *number == 1 ? "the only map" : fmt::format("one of {} maps", grouped(*number));
  }
  const auto digits = static_cast<std::uint64_t>(ways.log10()) + 1;
  return fmt::format("one of {} maps, a number of {} digits", ways.describe(), grouped(digits));
}

std::string as_text(const DiffArguments& arguments, const IsomorphismResult& result) {
  if (!result.isomorphism) {
    std::string text = "different\n";
    for (const std::string& difference : result.differences) text += fmt::format("  {}\n", difference);
    return text;
  }
  const auto& [match, orientation, ways] = *result.isomorphism;
  Lines lines;
  lines.add("map", fmt::format("{}, {}, in {}", counted(match.matched_faces(), "face"),
                               counted(match.vertices.size(), "vertex", "vertices"),
                               counted(match.regions.size(), "component")));
  lines.add("orientation", name_of(orientation));
  lines.add("ways", describe_ways(ways));
  if (!arguments.output.empty()) lines.add("written", arguments.output);
  return "the same\n" + lines.render(2);
}

std::string as_json(const DiffArguments& arguments, const IsomorphismResult& result) {
  Json json{{"isomorphic", result.isomorphism.has_value()}};
  if (result.isomorphism) {
    const auto& [match, orientation, ways] = *result.isomorphism;
    const auto number = ways.value();
    json["orientation"] = name_of(orientation);
    json["ways"] = {
        {"number", number ? Json(*number) : Json(nullptr)}, {"product", ways.describe()}, {"log10", ways.log10()}};
    json["faces"] = match.matched_faces();
    json["vertices"] = match.vertices.size();
    json["components"] = match.regions.size();
  }
  json["differences"] = result.differences;
  json["output"] = result.isomorphism && !arguments.output.empty() ? Json(arguments.output) : Json(nullptr);
  return json_text(json);
}

/// No map leaves this program that the definition of a match does not allow.
bool write_map(const DiffArguments& arguments, const MeshFile& source, const MeshFile& target, const Match& match) {
  const Verdict verdict = verify(source.mesh, target.mesh, match, 1);
  if (!verdict.sound()) {
    complain(fmt::format("internal error: the map found is not sound ({}); nothing was written, please report it",
                         verdict.faults.front().message));
    return false;
  }
  const auto side = [](const MeshFile& file) {
    return MatchSide{file.path, file.mesh.vertex_count(), file.mesh.face_count()};
  };
  const MatchFile file{side(source),
                       side(target),
                       match,
                       {{"program", "quadmatch " QUADMATCH_VERSION},
                        {"algorithm", "isomorphism"},
                        {"orientation", arguments.match.orientation}}};
  const Expected<void> written = write_match(arguments.output, file);
  if (!written) complain(written.error());
  return written.has_value();
}

}  // namespace

int run_isomorphic_diff(const DiffArguments& arguments) {
  if (arguments.output == "-" && !arguments.quiet) {
    complain("-o - would mix figures and map on standard output; write the map to a file, or say --quiet");
    return kTrouble;
  }
  const std::optional<InputPair> inputs =
      read_inputs(arguments.source, arguments.target, !arguments.quiet, arguments.threads);
  if (!inputs) return kTrouble;
  const IsomorphismResult result =
      find_isomorphism(inputs->source.mesh, inputs->target.mesh, kOrientations.at(arguments.match.orientation));
  if (result.isomorphism && !arguments.output.empty() &&
      !write_map(arguments, inputs->source, inputs->target, result.isomorphism->match)) {
    return kTrouble;
  }
  if (arguments.json && !arguments.quiet && !print(as_json(arguments, result))) return kTrouble;
  if (!arguments.json && !arguments.quiet && !print(as_text(arguments, result))) return kTrouble;
  return result.isomorphism ? kSame : kDifferent;
}

}  // namespace quadmatch::cli
