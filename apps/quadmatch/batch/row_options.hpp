#pragma once
/// Cells of a job list as options of `match`, read by the same definitions.

#include <map>
#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>

#include "../matching.hpp"

namespace quadmatch::cli {

class RowOptions {
 public:
  explicit RowOptions(const MatchingArguments& defaults);

  /// The columns there may be, in order.
  [[nodiscard]] std::vector<std::string> columns() const;
  [[nodiscard]] bool knows(const std::string& column) const { return flags_.contains(column); }

  /// @param cells  of known columns, by name; an empty cell leaves its option as it is by default.
  /// @par Errors   BadArgument, naming the option.
  /// @par Cost     options are parsed once for all rows that have the same.
  [[nodiscard]] const Expected<MatchingArguments>& parse(const std::map<std::string, std::string>& cells);

 private:
  [[nodiscard]] Expected<MatchingArguments> parse_anew(const std::map<std::string, std::string>& cells) const;

  MatchingArguments defaults_;
  std::map<std::string, bool> flags_;  ///< by column: is it a flag?
  std::map<std::map<std::string, std::string>, Expected<MatchingArguments>> known_;
};

}  // namespace quadmatch::cli
