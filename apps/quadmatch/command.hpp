#pragma once
/// The verbs. Each declares its options and its help, and says what to run when it is chosen.

#include <functional>

#include <CLI/CLI.hpp>

namespace quadmatch::cli {

/// Runs a verb on what was given and returns the exit status.
using Action = std::function<int()>;

void add_match_command(CLI::App& program, Action& chosen);
void add_verify_command(CLI::App& program, Action& chosen);
void add_check_command(CLI::App& program, Action& chosen);
void add_diff_command(CLI::App& program, Action& chosen);
void add_skeleton_command(CLI::App& program, Action& chosen);
void add_symmetry_command(CLI::App& program, Action& chosen);
void add_merge_command(CLI::App& program, Action& chosen);
void add_transfer_command(CLI::App& program, Action& chosen);
void add_batch_command(CLI::App& program, Action& chosen);
void add_batch_merge_command(CLI::App& program, Action& chosen);
void add_index_command(CLI::App& program, Action& chosen);
void add_find_command(CLI::App& program, Action& chosen);
void add_generate_command(CLI::App& program, Action& chosen);

/// A verb whose options are kept in an `Options`: `run(options)` becomes the action when the verb is chosen.
template <class Options>
CLI::App* add_verb(CLI::App& program, const char* name, const char* description, Options*& options,
                   int (*run)(const Options&), Action& chosen) {
  const auto kept = std::make_shared<Options>();
  options = kept.get();
  CLI::App* const verb = program.add_subcommand(name, description);
  verb->callback([kept, run, &chosen] { chosen = [kept, run] { return run(*kept); }; });
  return verb;
}

}  // namespace quadmatch::cli
