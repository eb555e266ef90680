#pragma once
/// Manual pages and completions, made from the flags as the parser knows them: each is written down once.

#include <string>

#include <CLI/CLI.hpp>

namespace quadmatch::cli {

/// The page of the program (roff, section 1), which names the verbs.
[[nodiscard]] std::string program_manual(const CLI::App& program);
/// The page of a verb.
[[nodiscard]] std::string verb_manual(const CLI::App& program, const CLI::App& verb);

[[nodiscard]] std::string bash_completion(const CLI::App& program);
[[nodiscard]] std::string zsh_completion(const CLI::App& program);
[[nodiscard]] std::string fish_completion(const CLI::App& program);

/// The verbs that help names, in its order.
[[nodiscard]] std::vector<const CLI::App*> shown_verbs(const CLI::App& program);
/// The options of a verb that begin with a hyphen, without those that help does not name.
[[nodiscard]] std::vector<const CLI::Option*> shown_options(const CLI::App& verb);
/// "--json" and "-o": all the names an option is typed by, the long ones first.
[[nodiscard]] std::vector<std::string> typed_names(const CLI::Option& option);
[[nodiscard]] inline bool takes_value(const CLI::Option& option) { return option.get_expected_max() > 0; }

}  // namespace quadmatch::cli
