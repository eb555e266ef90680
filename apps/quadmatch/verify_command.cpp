// quadmatch verify A B M: is a match file sound, whoever wrote it?

#include <fmt/format.h>

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
    R"(A match is sound when in every region paired faces have equally many corners, the corner
pairs make a one-to-one vertex map, two faces are adjacent exactly when their partners
are, and the faces hang together across edges; and when over all regions no face is used
twice and the list of vertices is one-to-one and complete.

Examples:
  quadmatch verify a.obj b.obj match.json
  quadmatch verify a.obj b.obj match.json --json | jq .faults

Exit status: 0 sound, 1 not sound, 2 trouble.)";

struct VerifyArguments {
  std::string source, target, match;
  std::size_t faults = 10;
  bool json = false;
  bool quiet = false;
};

struct VerifyReport {
  const MatchFile& file;
  const Verdict& verdict;

  [[nodiscard]] double coverage(const MatchSide& side) const {
    return side.faces == 0 ? 0.0 : static_cast<double>(verdict.matched_faces) / side.faces;
  }
};

std::string as_text(const VerifyReport& report) {
  const auto& [file, verdict] = report;
  std::string text =
      verdict.sound() ? "sound\n" : fmt::format("not sound: {}\n", counted(verdict.fault_count, "fault"));
  for (const Fault& fault : verdict.faults) text += fmt::format("  {}\n", fault.message);
  if (verdict.fault_count > verdict.faults.size()) {
    text += fmt::format("  and {} more\n", grouped(verdict.fault_count - verdict.faults.size()));
  }
  Lines lines;
  lines.add("matched", fmt::format("{}: {} of the source, {} of the target", counted(verdict.matched_faces, "face"),
                                   percent(verdict.matched_faces, file.source.faces),
                                   percent(verdict.matched_faces, file.target.faces)));
  lines.add("vertices", fmt::format("{} with a partner", grouped(verdict.matched_vertices)));
  lines.add("regions", fmt::format("{}, the largest of {}", grouped(file.match.regions.size()),
                                   counted(verdict.largest_region, "face")));
  return text + lines.render(2);
}

std::string as_json(const VerifyReport& report) {
  const auto& [file, verdict] = report;
  Json messages = Json::array();
  for (const Fault& fault : verdict.faults) messages.push_back(fault.message);
  return json_text({{"valid", verdict.sound()},
                    {"faults", verdict.fault_count},
                    {"regions", file.match.regions.size()},
                    {"largest_region", verdict.largest_region},
                    {"matched_faces", verdict.matched_faces},
                    {"source_faces", file.source.faces},
                    {"target_faces", file.target.faces},
                    {"source_coverage", report.coverage(file.source)},
                    {"target_coverage", report.coverage(file.target)},
                    {"matched_vertices", verdict.matched_vertices},
                    {"messages", messages}});
}

int run_verify(const VerifyArguments& arguments) {
  if (!paths_fit({arguments.source, arguments.target, arguments.match}, {})) return kTrouble;
  const std::optional<MeshFile> source = read_input(arguments.source, !arguments.quiet);
  if (!source) return kTrouble;
  const std::optional<MeshFile> target = read_input(arguments.target, !arguments.quiet);
  if (!target) return kTrouble;
  const Expected<MatchFile> file = read_match(arguments.match);
  if (!file) return complain(file.error());
  const auto side = [](const MeshFile& mesh) {
    return MatchSide{mesh.path, mesh.mesh.vertex_count(), mesh.mesh.face_count()};
  };
  if (Expected<void> fitting = fits(*file, side(*source), side(*target)); !fitting) {
    Error error = fitting.error();
    if (error.path.empty()) error.path = display_name(arguments.match);
    return complain(error);
  }
  const Verdict verdict = verify(source->mesh, target->mesh, file->match, arguments.faults);
  const VerifyReport report{*file, verdict};
  if (arguments.json && !print(as_json(report))) return kTrouble;
  if (!arguments.json && !arguments.quiet && !print(as_text(report))) return kTrouble;
  return verdict.sound() ? kSame : kDifferent;
}

}  // namespace

void add_verify_command(CLI::App& program, Action& chosen) {
  VerifyArguments* arguments = nullptr;
  CLI::App* const verb =
      add_verb(program, "verify", "Check a match file, independently of what made it", arguments, run_verify, chosen);
  verb->footer(kFooter);
  verb->add_option("A", arguments->source, "Source mesh; - reads standard input")->required()->type_name("FILE");
  verb->add_option("B", arguments->target, "Target mesh")->required()->type_name("FILE");
  verb->add_option("M", arguments->match, "Match file")->required()->type_name("FILE");
  verb->add_option("--faults", arguments->faults, "How many faults to print; all are counted")
      ->type_name("N")
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "Print the figures as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print nothing, only set the exit status");
}

}  // namespace quadmatch::cli
