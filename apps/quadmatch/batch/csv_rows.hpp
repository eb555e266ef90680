#pragma once
/// Rows of comma-separated values as RFC 4180 has them: a quoted field may hold commas, quotes and line breaks.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quadmatch::cli {

struct CsvRow {
  std::uint64_t line = 0;  ///< where it begins, from 1
  std::vector<std::string> fields = {};
  std::string fault = {};  ///< why it cannot be read, one sentence; then there are no fields
};

/// The rows of a text, without those that are empty. A row that cannot be read costs one line: the next row begins
/// below the line where it began. Blanks belong to their fields.
///
/// @par Cost  O(size), and once more for a quote that is never closed.
[[nodiscard]] std::vector<CsvRow> csv_rows(std::string_view text);

}  // namespace quadmatch::cli
