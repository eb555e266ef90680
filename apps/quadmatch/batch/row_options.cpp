#include "row_options.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

namespace quadmatch::cli {
namespace {

Unexpected<Error> refuse(std::string message) { return Unexpected(Error{ErrorCode::BadArgument, std::move(message)}); }

/// The words that turn an option on the command line: `--anchor=1=2` for each anchor of a cell, `--waves=true`.
Expected<std::vector<std::string>> words_of(const std::string& column, const std::string& cell, bool flag) {
  std::vector<std::string> words;
  if (flag) {
    const bool yes = cell == "yes" || cell == "true" || cell == "1";
    if (!yes && cell != "no" && cell != "false" && cell != "0") {
      return refuse(fmt::format("{}: \"{}\" is neither yes nor no", column, cell));
    }
    words.push_back(fmt::format("--{}={}", column, yes ? "true" : "false"));
  } else if (column == "anchor") {
    std::istringstream places(cell);
    for (std::string place; places >> place;) words.push_back(fmt::format("--{}={}", column, place));
  } else {
    words.push_back(fmt::format("--{}={}", column, cell));
  }
  return words;
}

}  // namespace

RowOptions::RowOptions(const MatchingArguments& defaults) : defaults_(defaults) {
  MatchingArguments unused;
  CLI::App options;
  add_matching_options(options, unused);
  for (const CLI::Option* option : options.get_options()) {
    if (option->get_lnames().empty() || option->get_lnames().front() == "help") continue;
    flags_[option->get_lnames().front()] = option->get_expected_min() == 0;
  }
}

std::vector<std::string> RowOptions::columns() const {
  std::vector<std::string> names;
  for (const auto& [name, flag] : flags_) names.push_back(name);
  return names;
}

const Expected<MatchingArguments>& RowOptions::parse(const std::map<std::string, std::string>& cells) {
  const auto known = known_.find(cells);
  if (known != known_.end()) return known->second;
  return known_.emplace(cells, parse_anew(cells)).first->second;
}

Expected<MatchingArguments> RowOptions::parse_anew(const std::map<std::string, std::string>& cells) const {
  std::vector<std::string> words;
  for (const auto& [column, cell] : cells) {
    if (cell.empty()) continue;
    const Expected<std::vector<std::string>> more = words_of(column, cell, flags_.at(column));
    if (!more) return Unexpected(more.error());
    words.insert(words.end(), more->begin(), more->end());
  }
  MatchingArguments arguments = defaults_;
  CLI::App options;
  add_matching_options(options, arguments);
  std::reverse(words.begin(), words.end());  // as CLI11 takes a vector
  try {
    options.parse(words);
  } catch (const CLI::ParseError& error) {
    const std::string what = error.what();
    return refuse(what.substr(0, what.find('\n')));
  }
  if (const Expected<void> fit = check_matching(arguments); !fit) return Unexpected(fit.error());
  return arguments;
}

}  // namespace quadmatch::cli
