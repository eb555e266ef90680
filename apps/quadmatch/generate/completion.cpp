// Completions for three shells: verbs, then the options of the verb, then files.

#include <fmt/format.h>

#include "manual.hpp"

namespace quadmatch::cli {
namespace {

/// All that can be typed after a verb, or before one, with a hyphen.
std::string option_words(const CLI::App& app) {
  std::string words;
  for (const CLI::Option* option : shown_options(app)) {
    for (const std::string& name : typed_names(*option)) words += (words.empty() ? "" : " ") + name;
  }
  return words;
}

std::string verb_words(const CLI::App& program) {
  std::string words;
  for (const CLI::App* verb : shown_verbs(program)) words += (words.empty() ? "" : " ") + verb->get_name();
  return words;
}

bool is_path(const CLI::Option& option) {
  return option.get_type_name() == "FILE" || option.get_type_name() == "FOLDER";
}

/// The names of a verb's options after which no file name comes, as a pattern of the shell.
std::string plain_value_pattern(const CLI::App& verb) {
  std::string pattern;
  for (const CLI::Option* option : shown_options(verb)) {
    if (!takes_value(*option) || is_path(*option)) continue;
    for (const std::string& name : typed_names(*option)) pattern += (pattern.empty() ? "" : "|") + name;
  }
  return pattern;
}

/// Within single quotes.
std::string in_quotes(std::string_view text) {
  std::string inside;
  for (const char letter : text) inside += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return inside;
}

/// Within the brackets of zsh's _arguments, in single quotes.
std::string zsh_text(std::string_view text) {
  std::string inside;
  for (const char letter : in_quotes(text)) {
    if (letter == '[' || letter == ']' || letter == ':') inside += '\\';
    inside += letter;
  }
  return inside;
}

std::string zsh_option(const CLI::Option& option, const std::string& name) {
  const std::string value = !takes_value(option)                 ? ""
                            : option.get_type_name() == "FOLDER" ? ":folder:_files -/"
                            : is_path(option)                    ? ":file:_files"
                                              : fmt::format(":{}:", zsh_text(option.get_type_name()));
  return fmt::format("        '*{}[{}]{}' \\\n", name, zsh_text(option.get_description()), value);
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
  std::string script = fmt::format(R"(# bash completion for quadmatch
_quadmatch() {{
  local word verb="" options="{}" current="${{COMP_WORDS[COMP_CWORD]}}" before="${{COMP_WORDS[COMP_CWORD - 1]}}"
  COMPREPLY=()
  if [ "$COMP_CWORD" -gt 1 ]; then verb="${{COMP_WORDS[1]}}"; fi
  case "$verb" in
    "") if [[ $current != -* ]]; then
          COMPREPLY=($(compgen -W "{}" -- "$current"))
          return
        fi ;;
)",
                                   option_words(program), verb_words(program));
  for (const CLI::App* verb : shown_verbs(program)) {
    const std::string values = plain_value_pattern(*verb);
    script += fmt::format("    {}) options=\"{}\"\n", verb->get_name(), option_words(*verb));
    if (!values.empty()) script += fmt::format("      case \"$before\" in {}) return ;; esac\n", values);
    script += "      ;;\n";
  }
  return script + R"(  esac
  if [[ $current == -?* || ( $current == - ) ]]; then
    COMPREPLY=($(compgen -W "$options" -- "$current"))
  else
    compopt -o filenames 2>/dev/null
    local IFS=$'\n'
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}
complete -F _quadmatch quadmatch
)";
}

std::string zsh_completion(const CLI::App& program) {
  std::string script = "#compdef quadmatch\n\n_quadmatch() {\n  if (( CURRENT == 2 )); then\n    local -a verbs=(\n";
  for (const CLI::App* verb : shown_verbs(program)) {
    script += fmt::format("      '{}:{}'\n", verb->get_name(), zsh_text(verb->get_description()));
  }
  script += "    )\n    _describe verb verbs\n    _arguments \\\n";
  for (const CLI::Option* option : shown_options(program)) {
    for (const std::string& name : typed_names(*option)) script += zsh_option(*option, name);
  }
  script +=
      "        && return\n    return\n  fi\n  local verb=${words[2]}\n  shift words\n  (( CURRENT-- ))\n  case $verb "
      "in\n";
  for (const CLI::App* verb : shown_verbs(program)) {
    script += fmt::format("    {})\n      _arguments \\\n", verb->get_name());
    for (const CLI::Option* option : shown_options(*verb)) {
      for (const std::string& name : typed_names(*option)) script += zsh_option(*option, name);
    }
    script += "        '*:file:_files'\n      ;;\n";
  }
  return script + "  esac\n}\n\n_quadmatch \"$@\"\n";
}

std::string fish_completion(const CLI::App& program) {
  std::string script = "# fish completion for quadmatch\n";
  const auto add_options = [&script](const CLI::App& app, const std::string& when) {
    for (const CLI::Option* option : shown_options(app)) {
      script += fmt::format("complete -c quadmatch -n '{}'", when);
      for (const std::string& name : option->get_lnames()) script += " -l " + name;
      for (const std::string& name : option->get_snames()) script += " -s " + name;
      if (takes_value(*option)) script += is_path(*option) ? " -r -F" : " -x";
      script += fmt::format(" -d '{}'\n", in_quotes(option->get_description()));
    }
  };
  for (const CLI::App* verb : shown_verbs(program)) {
    script += fmt::format("complete -c quadmatch -n __fish_use_subcommand -f -a {} -d '{}'\n", verb->get_name(),
                          in_quotes(verb->get_description()));
  }
  add_options(program, "__fish_use_subcommand");
  for (const CLI::App* verb : shown_verbs(program)) {
    add_options(*verb, "__fish_seen_subcommand_from " + verb->get_name());
  }
  return script;
}

}  // namespace quadmatch::cli
