// quadmatch VERB ...: parse, call, show. Exit statuses as of `diff`: 0 same, 1 different, 2 trouble.

#include <exception>
#include <memory>
#include <new>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "command.hpp"
#include "console.hpp"
#include "help.hpp"

namespace quadmatch::cli {
namespace {

constexpr const char* kFooter = R"(Examples:
  quadmatch match bear.obj bear_no_ears_posed.obj -o bears.json
  quadmatch check model.obj
  quadmatch match --help

Meshes are OBJ, PLY, OFF or USD text (.usda); - reads standard input. Data goes to
standard output or to -o, messages to standard error.
Exit status: 0 same, 1 different, 2 trouble; each verb says what that means for it.)";

/// A usage error in our own form: one line, what is wrong and where to read more.
int complain_about_usage(const CLI::App& program, const CLI::ParseError& error, const std::string& first_argument) {
  const std::vector<CLI::App*> verbs = program.get_subcommands();
  if (verbs.empty() && first_argument.empty()) {
    complain("what is to be done? Name a verb, such as match; see quadmatch --help");
  } else if (verbs.empty()) {
    complain(fmt::format("there is no verb or option {}; see quadmatch --help", first_argument));
  } else {
    const std::string what = error.what();
    complain(fmt::format("{}; see quadmatch {} --help", what.substr(0, what.find('\n')), verbs.front()->get_name()));
  }
  return kTrouble;
}

int run(int argc, char** argv) {
  CLI::App program("Find which parts of two quad meshes are the same, from connectivity alone.", "quadmatch");
  program.set_version_flag("--version", "quadmatch " QUADMATCH_VERSION, "Print the version and exit");
  program.set_help_flag("-h,--help", "Print this help and exit");
  program.formatter(std::make_shared<HelpFormatter>());
  program.footer(kFooter);
  program.require_subcommand(1);

  Action chosen;
  add_match_command(program, chosen);
  add_transfer_command(program, chosen);
  add_symmetry_command(program, chosen);
  add_merge_command(program, chosen);
  add_verify_command(program, chosen);
  add_check_command(program, chosen);
  add_diff_command(program, chosen);
  add_skeleton_command(program, chosen);
  add_batch_command(program, chosen);
  add_batch_merge_command(program, chosen);
  add_index_command(program, chosen);
  add_find_command(program, chosen);
  add_generate_command(program, chosen);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& request) {
    return program.exit(request);  // help or version
  } catch (const CLI::ParseError& error) {
    return complain_about_usage(program, error, argc > 1 ? argv[1] : "");
  }
  return chosen();
}

}  // namespace
}  // namespace quadmatch::cli

int main(int argc, char** argv) {
  try {
    return quadmatch::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    quadmatch::cli::complain("there is not enough memory; close other programs, or take smaller meshes");
  } catch (const std::exception& error) {
    quadmatch::cli::complain(fmt::format("internal error: {}; please report it", error.what()));
  }
  return quadmatch::cli::kTrouble;
}
