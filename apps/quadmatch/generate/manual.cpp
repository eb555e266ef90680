// man(7): a line that begins with a dot or a quote is a request, a backslash escapes, and a bare hyphen may become a
// typographic one.

#include "manual.hpp"

#include <sstream>

#include <fmt/format.h>

namespace quadmatch::cli {
namespace {

std::string roff(std::string_view text) {
  std::string escaped;
  for (const char letter : text) {
    if (letter == '\\') {
      escaped += "\\e";
    } else if (letter == '-') {
      escaped += "\\-";
    } else if ((letter == '.' || letter == '\'') && (escaped.empty() || escaped.back() == '\n')) {
      escaped += fmt::format("\\&{}", letter);
    } else {
      escaped += letter;
    }
  }
  return escaped;
}

std::string upper(std::string text) {
  for (char& letter : text) letter = letter >= 'a' && letter <= 'z' ? static_cast<char>(letter - 'a' + 'A') : letter;
  return text;
}

std::string heading(const std::string& name) {
  return fmt::format(".TH {} 1 \"\" \"quadmatch " QUADMATCH_VERSION "\" \"User Commands\"\n", upper(name));
}

/// The text under the options: paragraphs as they are, since they hold aligned lines; "Examples:" and "Exit status:"
/// get sections of their own.
std::string footer(const CLI::App& app) {
  std::string text = ".SH DETAILS\n.nf\n";
  std::istringstream lines(app.get_footer());
  for (std::string line; std::getline(lines, line);) {
    if (line == "Examples:") {
      text += ".SH EXAMPLES\n.nf\n";
    } else if (line.rfind("Exit status: ", 0) == 0) {
      text += ".fi\n.SH EXIT STATUS\n" + roff(line.substr(13)) + "\n";
    } else {
      text += roff(line) + "\n";
    }
  }
  const std::string nothing = ".SH DETAILS\n.nf\n.SH EXAMPLES\n";
  if (text.rfind(nothing, 0) == 0) text.erase(0, nothing.find(".SH EXAMPLES"));
  return text + ".fi\n";
}

std::string option_entry(const CLI::Option& option) {
  std::string names;
  for (const std::string& name : typed_names(option)) {
    names += fmt::format("{}\\fB{}\\fR", names.empty() ? "" : ", ", roff(name));
  }
  if (names.empty()) names = fmt::format("\\fI{}\\fR", roff(option.get_name(true)));
  if (!typed_names(option).empty() && takes_value(option)) {
    names += fmt::format(" \\fI{}\\fR", roff(option.get_type_name()));
  }
  std::string text = roff(option.get_description());
  if (!option.get_default_str().empty()) text += fmt::format(" (default: {})", roff(option.get_default_str()));
  return fmt::format(".TP\n{}\n{}\n", names, text);
}

std::vector<const CLI::Option*> positionals(const CLI::App& verb) {
  return verb.get_options([](const CLI::Option* option) { return option->get_positional(); });
}

}  // namespace

std::vector<const CLI::App*> shown_verbs(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::vector<const CLI::Option*> shown_options(const CLI::App& verb) {
  return verb.get_options(
      [](const CLI::Option* option) { return option->nonpositional() && !option->get_group().empty(); });
}

std::vector<std::string> typed_names(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

std::string program_manual(const CLI::App& program) {
  std::string page = heading("quadmatch");
  page += fmt::format(".SH NAME\nquadmatch \\- {}\n", roff("find which parts of two quad meshes are the same"));
  page += ".SH SYNOPSIS\n\\fBquadmatch\\fR \\fIVERB\\fR [\\fIOPTION\\fR]... \\fIFILE\\fR...\n";
  page +=
      fmt::format(".SH DESCRIPTION\n{}\n.SH VERBS\nEach has a page of its own, such as \\fBquadmatch\\-match\\fR(1).\n",
                  roff(program.get_description()));
  for (const CLI::App* verb : shown_verbs(program)) {
    page += fmt::format(".TP\n\\fB{}\\fR\n{}\n", roff(verb->get_name()), roff(verb->get_description()));
  }
  page += ".SH OPTIONS\n";
  for (const CLI::Option* option : shown_options(program)) page += option_entry(*option);
  return page + footer(program);
}

std::string verb_manual(const CLI::App& program, const CLI::App& verb) {
  const std::string name = program.get_name() + "-" + verb.get_name();
  std::string page = heading(name);
  page += fmt::format(".SH NAME\n{} \\- {}\n", roff(name), roff(verb.get_description()));
  page += fmt::format(".SH SYNOPSIS\n\\fBquadmatch {}\\fR [\\fIOPTION\\fR]...", roff(verb.get_name()));
  for (const CLI::Option* option : positionals(verb)) {
    const std::string name_of =
        fmt::format("\\fI{}\\fR{}", roff(option->get_name(true)), option->get_expected_max() > 1 ? "..." : "");
    page += option->get_required() ? " " + name_of : " [" + name_of + "]";
  }
  page += "\n.SH ARGUMENTS\n";
  for (const CLI::Option* option : positionals(verb)) {
    page += fmt::format(".TP\n\\fI{}\\fR\n{}\n", roff(option->get_name(true)), roff(option->get_description()));
  }
  page += ".SH OPTIONS\n";
  for (const CLI::Option* option : shown_options(verb)) page += option_entry(*option);
  return page + footer(verb) + ".SH SEE ALSO\n\\fBquadmatch\\fR(1)\n";
}

}  // namespace quadmatch::cli
