// quadmatch diff A B --isomorphic: are two whole meshes the same up to numbering, in how many ways, or what is
// different?

#include <map>

#include <fmt/format.h>

#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/verify/verify.hpp>

#include "command.hpp"
#include "console.hpp"
#include "inputs.hpp"
#include "json.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(Two meshes are isomorphic when one is the other in another order: a one-to-one map of faces,
each with a rotation, such that corners share a vertex in one exactly if they do in the other.
Positions are not looked at. A map keeps the orientation of all faces or turns all over
(a mirror image); a pair of shoes is not a pair of left shoes.

If there is a map, it is told how many there are, and -o writes one of them as a match file.
If there is none, it is told what is different. For parts that are the same, see quadmatch match.

Examples:
  quadmatch diff before.obj after.ply --isomorphic
  quadmatch diff left.obj right.obj --isomorphic --orientation reversing -o map.json
  quadmatch diff a.obj b.obj --isomorphic --quiet && echo same

Exit status: 0 the same, 1 different, 2 trouble.)";

const std::map<std::string, IsomorphismKind> kOrientations{{"auto", IsomorphismKind::Either},
                                                           {"preserving", IsomorphismKind::Preserving},
                                                           {"reversing", IsomorphismKind::Reversing}};

struct DiffArguments {
  std::string source, target;
  std::string output;
  std::string orientation = "auto";
  bool isomorphic = false;
  bool json = false;
  bool quiet = false;
};

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
                        {"orientation", arguments.orientation}}};
  const Expected<void> written = write_match(arguments.output, file);
  if (!written) complain(written.error());
  return written.has_value();
}

bool usage_fits(const DiffArguments& arguments) {
  if (!arguments.isomorphic) {
    complain("diff compares whole meshes: say --isomorphic; for parts that are the same, see quadmatch match --help");
    return false;
  }
  if (arguments.output == "-" && !arguments.quiet) {
    complain("-o - would mix figures and map on standard output; write the map to a file, or say --quiet");
    return false;
  }
  return paths_fit({arguments.source, arguments.target}, arguments.output);
}

int run_diff(const DiffArguments& arguments) {
  if (!usage_fits(arguments)) return kTrouble;
  const std::optional<InputPair> inputs = read_inputs(arguments.source, arguments.target, !arguments.quiet, 0);
  if (!inputs) return kTrouble;
  const IsomorphismResult result =
      find_isomorphism(inputs->source.mesh, inputs->target.mesh, kOrientations.at(arguments.orientation));
  if (result.isomorphism && !arguments.output.empty() &&
      !write_map(arguments, inputs->source, inputs->target, result.isomorphism->match)) {
    return kTrouble;
  }
  if (arguments.json && !arguments.quiet && !print(as_json(arguments, result))) return kTrouble;
  if (!arguments.json && !arguments.quiet && !print(as_text(arguments, result))) return kTrouble;
  return result.isomorphism ? kSame : kDifferent;
}

}  // namespace

void add_diff_command(CLI::App& program, Action& chosen) {
  DiffArguments* arguments = nullptr;
  CLI::App* const verb =
      add_verb(program, "diff",
               "Tell whether two whole meshes are the same up to numbering, and if not, in what they "
               "are different",
               arguments, run_diff, chosen);
  verb->footer(kFooter);
  verb->add_option("A", arguments->source, "Source mesh; - reads standard input")->required()->type_name("FILE");
  verb->add_option("B", arguments->target, "Target mesh")->required()->type_name("FILE");
  verb->add_flag("--isomorphic", arguments->isomorphic,
                 "Ask for a map of the whole, exactly; for now the one comparison there is, so it must be given");
  verb->add_option("--orientation", arguments->orientation,
                   "preserving, reversing (a mirror image), or auto: preserving, else reversing, one for the whole")
      ->check(CLI::IsMember(kOrientations).description(""))
      ->type_name("NAME")
      ->capture_default_str();
  verb->add_option("-o,--output", arguments->output, "Match file to write (JSON), if the meshes are the same")
      ->type_name("FILE");
  verb->add_flag("--json", arguments->json, "Print the figures as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print nothing, only set the exit status");
}

}  // namespace quadmatch::cli
