#include "help.hpp"

#include <sstream>

#include <fmt/format.h>

namespace quadmatch::cli {
namespace {

constexpr std::size_t kIndent = 24;
constexpr std::size_t kWidth = 92;

/// `left` in its column, and the words of `right` beside it in as many lines as they need.
std::string two_columns(const std::string& left, const std::string& right) {
  std::string text = fmt::format("  {:<{}}", left, kIndent - 2);
  std::size_t used = text.size();
  if (used > kIndent) {
    text += fmt::format("\n{:{}}", "", kIndent);
    used = kIndent;
  }
  std::istringstream words(right);
  for (std::string word; words >> word;) {
    if (used > kIndent && used + 1 + word.size() > kWidth) {
      text += fmt::format("\n{:{}}", "", kIndent);
      used = kIndent;
    }
    if (used > kIndent) {
      text += ' ';
      ++used;
    }
    text += word;
    used += word.size();
  }
  return text + "\n";
}

}  // namespace

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  std::string left = option->get_name(is_positional, true);
  if (!is_positional && option->get_expected_max() > 0) left += " " + option->get_type_name();
  if (is_positional && option->get_expected_max() > 1) left += "...";
  std::string right = option->get_description();
  if (!option->get_default_str().empty()) right += fmt::format(" (default: {})", option->get_default_str());
  return two_columns(left, right);
}

std::string HelpFormatter::make_option_usage(const CLI::Option* option) const {
  return option->get_name(true) + (option->get_expected_max() > 1 ? "..." : "");
}

std::string HelpFormatter::make_subcommand(const CLI::App* verb) const {
  return two_columns(verb->get_name(), verb->get_description());
}

}  // namespace quadmatch::cli
