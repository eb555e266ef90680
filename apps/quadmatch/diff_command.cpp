// quadmatch diff A B: what was changed, part by part; or, with --isomorphic, whether both are the same as wholes.

#include <fmt/format.h>

#include "command.hpp"
#include "diff_arguments.hpp"
#include "html_report.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter =
    R"(Both meshes are matched, and what has no partner is named by what a modeller did, from the
largest change on. Numbers of faces and vertices do not matter, only what they are part of.

  new, removed component    faces that hang together with nothing else
  addition, deletion        faces at a boundary, or a hole where some were
  inserted, removed loop    rows of quads
  extrusion                 a wall around a patch (and undone: taken out)
  collapse, opening         faces closed up, or opened between others
  refinement, coarsening    the same area in more faces, or in fewer
  bridge                    a tube between faces that were apart (and undone)
  rip, weld                 faces parted along edges, or joined
  re-attachment             parts that are the same, joined at another place
  re-connection             other edges inside the same rim

Vertices that moved are a difference too, unless --ignore-positions is given.

With --isomorphic it is asked, exactly, whether one mesh is the other in another order: a map of
all faces, in one orientation. It is told how many maps there are, and -o writes one; or else
what is different. Positions are not looked at.

With git, for all .obj files (the first line goes to .gitattributes):
  *.obj diff=quadmatch
  git config diff.quadmatch.command "quadmatch diff --git"
  git config diff.quadmatch.textconv "quadmatch diff --textconv"
git diff, git show --ext-diff and git log -p --ext-diff then name changes; textconv is for
whatever compares lines, such as git log -p. Either ends with 0, or git would stop there.

Examples:
  quadmatch diff before.obj after.obj
  quadmatch diff before.obj posed.obj --ignore-positions --quiet && echo same connectivity
  quadmatch diff a.obj b.obj --json | jq '.changes[] | select(.kind == "deletion").source_faces'
  quadmatch diff before.obj after.obj --report changes.html    then open it in a browser
  quadmatch diff before.obj after.obj --image changes.png      for a ticket or a log
  quadmatch diff left.obj right.obj --isomorphic --orientation reversing -o map.json

Exit status: 0 no differences, 1 differences, 2 trouble.)";

/// The word that is given and has no place beside `mode`, or nothing.
const char* misplaced(const DiffArguments& arguments) {
  if (arguments.isomorphic) {
    return !arguments.page.empty()          ? "--report"
           : arguments.pictures.any()       ? "--image"
           : !arguments.match.file.empty()  ? "--match"
           : arguments.match.no_positions   ? "--no-positions"
           : arguments.least_confidence > 0 ? "--min-confidence"
           : arguments.stat                 ? "--stat"
                                            : nullptr;
  }
  return arguments.output.empty() ? nullptr : "-o";
}

bool usage_fits(const DiffArguments& arguments) {
  if (arguments.source.empty() || arguments.target.empty()) {
    complain(fmt::format("{} is required; see quadmatch diff --help", arguments.source.empty() ? "A" : "B"));
    return false;
  }
  if (const char* const word = misplaced(arguments)) {
    complain(
        arguments.isomorphic
            ? fmt::format("{} is about comparing part by part, --isomorphic about wholes; leave one of them out", word)
            : fmt::format("{} writes the map of --isomorphic; for a match of parts see quadmatch match", word));
    return false;
  }
  if (arguments.json && arguments.stat) {
    complain("--json and --stat would mix two forms on standard output; leave one of them out");
    return false;
  }
  std::vector<std::string> inputs{arguments.source, arguments.target};
  if (!arguments.match.file.empty()) inputs.push_back(arguments.match.file);
  return paths_fit(inputs, arguments.output) && wishes_fit(arguments.match) &&
         report_fits(arguments.page, inputs, {arguments.output}) &&
         pictures_fit(arguments.pictures, inputs, {arguments.page});
}

int run_diff(const DiffArguments& arguments) {
  if (!arguments.git.empty()) return run_git_diff(arguments);
  if (!arguments.textconv.empty()) return run_textconv(arguments);
  if (!usage_fits(arguments)) return kTrouble;
  return arguments.isomorphic ? run_isomorphic_diff(arguments) : run_parts_diff(arguments);
}

void add_comparison_options(CLI::App& verb, DiffArguments& arguments) {
  verb.add_flag("--ignore-positions", arguments.ignore_positions, "Say nothing of where vertices are");
  verb.add_option("--tolerance", arguments.tolerance,
                  "How far a vertex may be from where it was and not count as moved, as a share of the size of A")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->type_name("X")
      ->capture_default_str();
  verb.add_option("--match", arguments.match.file, "Match file from A to B; without it they are matched here")
      ->type_name("FILE");
  verb.add_option("--min-confidence", arguments.least_confidence,
                  "Take regions of which a smaller share of the extraordinary vertices agrees for unmatched, 0 to 1")
      ->check(CLI::Range(0.0, 1.0).description(""))
      ->type_name("X")
      ->capture_default_str();
  verb.add_option("--orientation", arguments.match.orientation,
                  "preserving, reversing (B is a mirror image of A), or auto: whichever fits")
      ->check(CLI::IsMember(orientation_choices()).description(""))
      ->type_name("NAME")
      ->capture_default_str();
  verb.add_flag("--no-positions", arguments.match.no_positions, "Match by connectivity alone");
  verb.add_option("--threads", arguments.threads,
                  "Read the two meshes at the same time if 2 or more; 0: as many as there are processors")
      ->type_name("N")
      ->capture_default_str();
}

void add_form_options(CLI::App& verb, DiffArguments& arguments) {
  add_report_option(verb, arguments.page);
  add_picture_options(verb, arguments.pictures, true);
  verb.add_flag("--stat", arguments.stat, "Print one line of name=number");
  verb.add_flag("--json", arguments.json, "Print all of it as JSON, with the elements of each change");
  verb.add_flag("--quiet", arguments.quiet, "Print nothing, only set the exit status");
  verb.add_option("--git", arguments.git, "For git to call as an external diff, see below; the last option")
      ->expected(1, 9)
      ->type_name("PATH OLD ...");
  verb.add_option("--textconv", arguments.textconv, "Print one mesh as lines that git can compare")->type_name("FILE");
}

}  // namespace

void add_diff_command(CLI::App& program, Action& chosen) {
  DiffArguments* arguments = nullptr;
  CLI::App* const verb =
      add_verb(program, "diff", "Tell what was changed between two meshes, or whether they are the same as wholes",
               arguments, run_diff, chosen);
  verb->footer(kFooter);
  // Not to be required of the parser: it would keep words back for them from those that git gives.
  verb->add_option("A", arguments->source, "Source mesh; - reads standard input")->type_name("FILE");
  verb->add_option("B", arguments->target, "Target mesh")->type_name("FILE");
  add_comparison_options(*verb, *arguments);
  verb->add_flag("--isomorphic", arguments->isomorphic, "Ask for a map of the whole, exactly");
  verb->add_option("-o,--output", arguments->output,
                   "With --isomorphic: match file to write (JSON), if the meshes are the same")
      ->type_name("FILE");
  add_form_options(*verb, *arguments);
}

}  // namespace quadmatch::cli
