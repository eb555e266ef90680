// quadmatch transfer A B -o OUT: read, match or read the match, carry, write, report.

#include <map>

#include <fmt/format.h>

#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/use/transfer.hpp>

#include "command.hpp"
#include "console.hpp"
#include "inputs.hpp"
#include "pair_match.hpp"
#include "text.hpp"
#include "transfer_report.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(OUT is B with A's data wherever both are the same: the shape, the pose and the faces are B's,
unless you ask for positions or order. Seams of A's texture stay seams.

What --only names:
  uv          texture coordinates     groups     objects and groups (o, g)
  colours     vertex and face colours materials  materials and their libraries
  properties  all else with a name    smoothing  smoothing groups (s)
  normals     A's normals             positions  A's vertex positions
  none        nothing, for --order alone
Without --only all but normals and positions are carried: those belong to the pose.

What becomes of faces of B that A has not, by --fill:
  keep    they keep what B has, if anything
  none    they get nothing
  smooth  UVs, colours and the like go on from the matched part; groups and materials are
          those of the nearest face

With --order B's vertices and faces are renumbered as in A. Where all is matched, OUT has A's
indices exactly and can be imported as a shape key of A.

Parts that could lie in several ways (symmetric or repeated ones) are not carried, but named.
OUT may be A or B itself: it is replaced when all of it is written, or not at all.

Examples:
  quadmatch transfer textured.obj edited.obj -o edited_with_uvs.obj
  quadmatch transfer a.obj b.obj -o b.obj --only uv,materials --fill smooth
  quadmatch transfer rest.obj sculpted.obj -o key.obj --only none --order
  quadmatch match a.ply b.ply -o m.json && quadmatch transfer a.ply b.ply --match m.json -o c.ply

Exit status: 0 all of B took A's data; 1 a part of it; 2 trouble, nothing is written.)";

const std::map<std::string, bool Carry::*> kKinds{
    {"uv", &Carry::texture_coordinates}, {"colours", &Carry::colours},     {"properties", &Carry::properties},
    {"groups", &Carry::groups},          {"materials", &Carry::materials}, {"smoothing", &Carry::smoothing},
    {"normals", &Carry::normals},        {"positions", &Carry::positions}, {"none", nullptr}};
const std::map<std::string, Fill> kFills{{"keep", Fill::Keep}, {"none", Fill::None}, {"smooth", Fill::Smooth}};

template <class Choice>
CLI::Validator one_of(const std::map<std::string, Choice>& choices) {
  return CLI::IsMember(choices).description("");  // the help names them in a sentence
}

struct TransferArguments {
  std::string source, target;
  std::string output;
  MatchWishes match;
  std::vector<std::string> only;
  std::string fill = "keep";
  bool order = false;
  bool allow_ambiguous = false;
  double least_confidence = 0;
  std::uint32_t threads = 0;
  bool json = false;
  bool quiet = false;
};

TransferOptions options_of(const TransferArguments& arguments) {
  TransferOptions options;
  if (!arguments.only.empty()) options.carry = Carry::nothing();
  for (const std::string& kind : arguments.only) {
    if (bool Carry::*const wanted = kKinds.at(kind)) options.carry.*wanted = true;
  }
  options.fill = kFills.at(arguments.fill);
  options.order = arguments.order;
  options.allow_ambiguous = arguments.allow_ambiguous;
  options.least_confidence = arguments.least_confidence;
  options.positions = !arguments.match.no_positions;
  return options;
}

std::vector<std::pair<std::string, std::string>> settings_of(const TransferArguments& arguments) {
  std::vector<std::pair<std::string, std::string>> settings{
      {"program", "quadmatch " QUADMATCH_VERSION},
      {"only",
       arguments.only.empty() ? "uv colours properties groups materials smoothing" : joined(arguments.only, " ")},
      {"fill", arguments.fill},
      {"orientation", arguments.match.orientation},
      {"order", arguments.order ? "true" : "false"},
      {"positions", arguments.match.no_positions ? "false" : "true"}};
  if (!arguments.match.file.empty()) settings.emplace_back("match", arguments.match.file);
  return settings;
}

bool arguments_fit(const TransferArguments& arguments) {
  std::vector<std::string> inputs{arguments.source, arguments.target};
  if (!arguments.match.file.empty()) inputs.push_back(arguments.match.file);
  if (!paths_fit(inputs, {})) return false;
  if (!arguments.match.file.empty() && !paths_fit({arguments.match.file}, arguments.output)) return false;
  if (!wishes_fit(arguments.match)) return false;
  if (arguments.json && arguments.output == "-") {
    complain("--json and -o - would mix figures and the mesh on standard output; write the mesh to a file");
    return false;
  }
  if (arguments.output != "-" && !format_of_path(arguments.output)) {
    complain(
        fmt::format("{}: the name does not tell the format; end it in .obj, .ply, .off or .usda", arguments.output));
    return false;
  }
  return true;
}

/// There is no sense in a copy of B that nothing was carried to.
int complain_of_nothing(const TransferArguments& arguments, const TransferReport& report) {
  if (report.left_out.empty()) {
    complain(
        fmt::format("{}: nothing of {} was found in it, so nothing is carried and nothing written; quadmatch match "
                    "shows more",
                    display_name(arguments.target), display_name(arguments.source)));
    return kTrouble;
  }
  complain(fmt::format("{}: all that was found of {} is doubtful, so nothing is carried and nothing written",
                       display_name(arguments.target), display_name(arguments.source)));
  constexpr std::size_t kMost = 6;
  for (std::size_t k = 0; k < report.left_out.size() && k < kMost; ++k) complain(describe(report.left_out[k]));
  if (report.left_out.size() > kMost) complain(fmt::format("and {} more parts", report.left_out.size() - kMost));
  return kTrouble;
}

/// What the transfer remarked on, and what it could not write.
void warn_of_remarks(const TransferSummary& summary, const MeshFile& result, const MeshFile& target) {
  for (std::size_t k = target.notes.size(); k < result.notes.size(); ++k) warn(result.notes[k]);
  if (summary.report.reversing && summary.options.carry.normals) {
    warn("normals were carried onto a mirror image as they are; let your program compute them anew");
  }
}

bool tell(const TransferArguments& arguments, const TransferSummary& summary) {
  if (arguments.json) return print(as_json(summary));
  if (arguments.quiet) return true;
  if (arguments.output != "-") return print(as_text(summary));
  fmt::print(stderr, "{}", as_text(summary));
  return true;
}

int run_transfer(const TransferArguments& arguments) {
  if (!arguments_fit(arguments)) return kTrouble;
  Progress progress(!arguments.quiet);
  Stopwatch stopwatch;
  TransferSummary summary;
  progress.stage(fmt::format("reading {} and {}", display_name(arguments.source), display_name(arguments.target)));
  const std::optional<InputPair> inputs =
      read_inputs(arguments.source, arguments.target, !arguments.quiet, arguments.threads);
  if (!inputs) return kTrouble;
  summary.times.reading = stopwatch.lap();
  if (!arguments.quiet) {
    warn_of_dirt(inputs->source);
    warn_of_dirt(inputs->target);
  }

  progress.stage("matching");
  const std::optional<Match> match = find_or_read_match(arguments.match, inputs->source, inputs->target, progress);
  if (!match) return kTrouble;
  progress.stage("carrying");
  summary.options = options_of(arguments);
  Expected<Transferred> result = transfer(inputs->source, inputs->target, *match, summary.options);
  if (!result) {
    if (result.error().path == "-") result.error().path = display_name("-");
    if (result.error().path.empty()) result.error().path = display_name(arguments.match.file);
    return complain(result.error());
  }
  if (result->report.matched_faces == 0) return complain_of_nothing(arguments, result->report);
  summary.times.matching = stopwatch.lap();

  progress.stage(fmt::format("writing {}", arguments.output));
  if (Expected<void> written = write_mesh(arguments.output, result->file); !written) return complain(written.error());
  summary.times.writing = stopwatch.lap();
  progress.clear();

  summary.source = arguments.source;
  summary.target = arguments.target;
  summary.source_faces = inputs->source.mesh.face_count();
  summary.report = std::move(result->report);
  summary.format = arguments.output == "-" ? Format::Obj : *format_of_path(arguments.output);
  summary.settings = settings_of(arguments);
  summary.output = arguments.output;
  if (!arguments.quiet) warn_of_remarks(summary, result->file, inputs->target);
  if (!tell(arguments, summary)) return kTrouble;
  return summary.complete() ? kSame : kDifferent;
}

}  // namespace

void add_transfer_command(CLI::App& program, Action& chosen) {
  TransferArguments* arguments = nullptr;
  CLI::App* const verb =
      add_verb(program, "transfer", "Carry UVs, colours, groups, materials or the order of A over to B", arguments,
               run_transfer, chosen);
  verb->footer(kFooter);
  verb->add_option("A", arguments->source, "Mesh that has the data; - reads standard input")
      ->required()
      ->type_name("FILE");
  verb->add_option("B", arguments->target, "Mesh that is to have them")->required()->type_name("FILE");
  verb->add_option("-o,--output", arguments->output,
                   "Mesh to write, in the format of its ending; - writes OBJ to standard output")
      ->required()
      ->type_name("FILE");
  verb->add_option("--match", arguments->match.file, "Match file from A to B; without it they are matched here")
      ->type_name("FILE");
  verb->add_option("--only", arguments->only,
                   "What to carry, of uv, colours, properties, groups, materials, smoothing, normals, positions, none")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(kKinds))
      ->type_name("KIND,...");
  verb->add_option("--fill", arguments->fill, "What faces of B that A has not get: keep, none or smooth")
      ->check(one_of(kFills))
      ->type_name("HOW")
      ->capture_default_str();
  verb->add_flag("--order", arguments->order, "Number vertices, faces and their corners as in A");
  verb->add_flag("--allow-ambiguous", arguments->allow_ambiguous, "Carry parts that could lie otherwise, too");
  verb->add_option("--min-confidence", arguments->least_confidence,
                   "Leave out regions of which a smaller share of the extraordinary vertices agrees, 0 to 1")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->type_name("X")
      ->capture_default_str();
  verb->add_option("--orientation", arguments->match.orientation,
                   "preserving, reversing (B is a mirror image of A), or auto: whichever fits")
      ->check(one_of(orientation_choices()))
      ->type_name("NAME")
      ->capture_default_str();
  verb->add_flag("--no-positions", arguments->match.no_positions, "By connectivity alone: positions decide nothing");
  verb->add_option("--threads", arguments->threads,
                   "Read the two meshes at the same time if 2 or more; 0: as many as there are processors")
      ->type_name("N")
      ->capture_default_str();
  verb->add_flag("--json", arguments->json, "Print the figures as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print neither summary nor warnings");
}

}  // namespace quadmatch::cli
