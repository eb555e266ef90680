// quadmatch symmetry A: read, find the mirror, write the map, copy one side to the other, report.

#include <map>

#include <fmt/format.h>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/use/symmetry.hpp>

#include "command.hpp"
#include "console.hpp"
#include "dirt.hpp"
#include "html_report.hpp"
#include "inputs.hpp"
#include "picture_options.hpp"
#include "symmetry_report.hpp"
#include "text.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(Which vertex and which face lies opposite which is found by connectivity, so the model may
be posed, turned or sculpted. Where it could be mirrored in several ways, as a rook or a
cube, one mirror is taken for all of it, and you are told how many there are.

The map (-o) is a match file of A with A; quadmatch verify A A MAP checks it. Its field
"symmetry" lists the centre line and what has no partner.

--symmetrize OUT writes A with one side copied to the other. --from says which side is
copied: +x is the side that lies farther to +x than its partners, whatever the pose.
What --only names:
  positions  mirrored in the plane between the sides; the centre line is moved into it.
             A posed model has no such plane: then this is refused
  uv, colours, properties, groups, materials, smoothing, normals
             copied as they are; an arm called arm.L gives its name to the other arm
Faces and vertices without partner stay as they are.

With --report and --image the mesh stands beside itself: a part and its partner have one colour,
the centre line is where colours meet, and what has no partner is red.

Examples:
  quadmatch symmetry head.obj
  quadmatch symmetry head.obj --report head.html --image head.png
  quadmatch symmetry posed.obj -o map.json && quadmatch verify posed.obj posed.obj map.json
  quadmatch symmetry head.obj --symmetrize even.obj --from +x
  quadmatch symmetry posed.ply --symmetrize out.ply --from -x --only properties

Exit status: 0 all of A has a mirror image; 1 a part of it, or nothing; 2 trouble.)";

const std::map<std::string, MirrorSide> kSides{{"+x", {0, true}},  {"-x", {0, false}}, {"+y", {1, true}},
                                               {"-y", {1, false}}, {"+z", {2, true}},  {"-z", {2, false}}};
const std::map<std::string, bool Carry::*> kKinds{{"positions", &Carry::positions}, {"uv", &Carry::texture_coordinates},
                                                  {"colours", &Carry::colours},     {"properties", &Carry::properties},
                                                  {"groups", &Carry::groups},       {"materials", &Carry::materials},
                                                  {"smoothing", &Carry::smoothing}, {"normals", &Carry::normals}};

template <class Choice>
CLI::Validator one_of(const std::map<std::string, Choice>& choices) {
  return CLI::IsMember(choices).description("");  // the help names them in a sentence
}

struct SymmetryArguments {
  std::string mesh;
  std::string output;
  std::string symmetrized;
  std::string from;
  std::string page;  // of the HTML report, empty: none
  PictureWishes pictures;
  std::vector<std::string> only;
  bool no_positions = false;
  bool json = false;
  bool quiet = false;
};

std::vector<std::pair<std::string, std::string>> settings_of(const SymmetryArguments& arguments) {
  return {{"program", "quadmatch " QUADMATCH_VERSION},
          {"verb", "symmetry"},
          {"positions", arguments.no_positions ? "false" : "true"}};
}

bool arguments_fit(const SymmetryArguments& arguments) {
  if (!paths_fit({arguments.mesh}, arguments.output)) return false;
  const bool symmetrizes = !arguments.symmetrized.empty();
  if (symmetrizes != !arguments.from.empty()) {
    complain(symmetrizes ? "--symmetrize needs --from, the side that is copied, such as --from +x"
                         : "--from says which side is copied, but --symmetrize does not say where to");
    return false;
  }
  if (!arguments.only.empty() && !symmetrizes) {
    complain("--only says what is copied, but --symmetrize does not say where to");
    return false;
  }
  if (symmetrizes && arguments.symmetrized == arguments.output) {
    complain(fmt::format("{}: the map and the mesh cannot go to the same place", arguments.output));
    return false;
  }
  if (arguments.json && (arguments.output == "-" || arguments.symmetrized == "-")) {
    complain("--json and - would mix figures and a file on standard output; write it to a file");
    return false;
  }
  if (symmetrizes && arguments.symmetrized != "-" && !format_of_path(arguments.symmetrized)) {
    complain(fmt::format("{}: the name does not tell the format; end it in .obj, .ply, .off or .usda",
                         arguments.symmetrized));
    return false;
  }
  return report_fits(arguments.page, {arguments.mesh}, {arguments.output, arguments.symmetrized}) &&
         pictures_fit(arguments.pictures, {arguments.mesh}, {arguments.output, arguments.symmetrized, arguments.page});
}

SymmetrizeOptions options_of(const SymmetryArguments& arguments) {
  SymmetrizeOptions options;
  options.from = kSides.at(arguments.from);
  if (!arguments.only.empty()) options.carry = Carry::nothing();
  for (const std::string& kind : arguments.only) options.carry.*kKinds.at(kind) = true;
  return options;
}

Symmetry search(const SymmetryArguments& arguments, const Mesh& mesh, Progress& progress) {
  SymmetryOptions options;
  options.positions = !arguments.no_positions;
  if (progress.visible()) {
    options.progress = [&progress](std::size_t matched, std::size_t most) {
      progress.update(matched, most);
      return true;
    };
  }
  return find_symmetry(mesh, options);
}

Expected<void> write_map(const SymmetryArguments& arguments, const MeshFile& file, const Symmetry& symmetry) {
  const MatchSide side{file.path, file.mesh.vertex_count(), file.mesh.face_count()};
  MatchFile map{.source = side, .target = side, .match = symmetry.match};
  map.settings = settings_of(arguments);
  map.further.emplace_back("symmetry", map_field(symmetry));
  return write_match(arguments.output, map);
}

Expected<SymmetrizeSummary> write_symmetrized(const SymmetryArguments& arguments, const MeshFile& file,
                                              const Symmetry& symmetry) {
  const SymmetrizeOptions options = options_of(arguments);
  const Expected<Symmetrized> result = symmetrize(file, symmetry, options);
  if (!result) return Unexpected(result.error());
  if (Expected<void> written = write_mesh(arguments.symmetrized, result->file); !written) {
    return Unexpected(written.error());
  }
  SymmetrizeSummary summary{arguments.symmetrized, arguments.from,          result->moved,
                            result->farthest,      options.carry.positions, {}};
  for (const TransferredAttribute& attribute : result->report.attributes) {
    summary.copied.emplace_back(attribute.name, attribute.carried);
  }
  return summary;
}

/// The page and the picture, as far as they were asked for.
bool write_views(const SymmetryArguments& arguments, const MeshFile& file, SymmetrySummary& summary) {
  if (arguments.page.empty() && !arguments.pictures.any()) return true;
  const Match shown = cut_along_line(file.mesh, summary.symmetry);
  if (!arguments.page.empty()) {
    const Expected<void> written = write_report(arguments.page, file, file, shown, report_text(file.mesh, summary));
    if (!written) complain(written.error());
    if (!written) return false;
    summary.page = arguments.page;
  }
  summary.pictures = arguments.pictures.files();
  return write_pictures(arguments.pictures, file, file, shown);
}

bool tell(const SymmetryArguments& arguments, const SymmetrySummary& summary) {
  if (arguments.json) return print(as_json(summary));
  if (arguments.quiet) return true;
  if (arguments.output != "-" && arguments.symmetrized != "-") return print(as_text(summary));
  fmt::print(stderr, "{}", as_text(summary));
  return true;
}

int run_symmetry(const SymmetryArguments& arguments) {
  if (!arguments_fit(arguments)) return kTrouble;
  Progress progress(!arguments.quiet);
  Stopwatch stopwatch;
  SymmetrySummary summary;
  summary.path = arguments.mesh;
  progress.stage(fmt::format("reading {}", display_name(arguments.mesh)));
  const std::optional<MeshFile> file = read_input(arguments.mesh, !arguments.quiet);
  if (!file) return kTrouble;
  summary.times.reading = stopwatch.lap();
  if (const std::string dirt = describe_dirt(file->mesh, "matching"); !dirt.empty() && !arguments.quiet) {
    warn(fmt::format("{}: {}", display_name(file->path), dirt));
  }

  progress.stage("looking for the mirror");
  summary.symmetry = search(arguments, file->mesh, progress);
  summary.times.matching = stopwatch.lap();
  summary.lonely = lonely_areas(file->mesh, summary.symmetry);
  if (!arguments.symmetrized.empty()) {  // what may be refused comes first, so that nothing is written then
    Expected<SymmetrizeSummary> done = write_symmetrized(arguments, *file, summary.symmetry);
    if (!done) {
      if (done.error().path == "-") done.error().path = display_name("-");
      return complain(done.error());
    }
    summary.symmetrized = *std::move(done);
  }
  if (!write_views(arguments, *file, summary)) return kTrouble;
  if (!arguments.output.empty()) {
    if (Expected<void> written = write_map(arguments, *file, summary.symmetry); !written) {
      return complain(written.error());
    }
  }
  progress.clear();

  summary.settings = settings_of(arguments);
  summary.output = arguments.output;
  if (!tell(arguments, summary)) return kTrouble;
  return summary.symmetry.whole() ? kSame : kDifferent;
}

}  // namespace

void add_symmetry_command(CLI::App& program, Action& chosen) {
  SymmetryArguments* arguments = nullptr;
  CLI::App* const verb = add_verb(program, "symmetry", "Find what lies opposite what in a mesh, in any pose", arguments,
                                  run_symmetry, chosen);
  verb->footer(kFooter);
  verb->add_option("A", arguments->mesh, "Mesh; - reads standard input")->required()->type_name("FILE");
  verb->add_option("-o,--output", arguments->output, "Map to write; - writes it to standard output")->type_name("FILE");
  add_report_option(*verb, arguments->page);
  add_picture_options(*verb, arguments->pictures, false);
  verb->add_option("--symmetrize", arguments->symmetrized,
                   "Mesh to write, with one side copied to the other; - writes OBJ to standard output")
      ->type_name("OUT");
  verb->add_option("--from", arguments->from, "The side that is copied: +x, -x, +y, -y, +z or -z")
      ->check(one_of(kSides))
      ->type_name("SIDE");
  verb->add_option("--only", arguments->only,
                   "What is copied, of positions (the default), uv, colours, properties, groups, materials, smoothing, "
                   "normals")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(kKinds))
      ->type_name("KIND,...");
  verb->add_flag("--no-positions", arguments->no_positions, "Search by connectivity alone");
  verb->add_flag("--json", arguments->json, "Print the figures as JSON");
  verb->add_flag("--quiet", arguments->quiet, "Print neither summary nor warnings");
}

}  // namespace quadmatch::cli
