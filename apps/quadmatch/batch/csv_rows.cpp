// Rows by libcsv; where one begins, and where to go on after a broken one, is kept here.

#include "csv_rows.hpp"

#include <algorithm>

#include <csv.h>

namespace quadmatch::cli {
namespace {

/// The length of the first line, with its end: "\n", "\r\n" or "\r".
std::size_t line_length(std::string_view text) {
  const std::size_t end = text.find_first_of("\r\n");
  if (end == std::string_view::npos) return text.size();
  return text.substr(end).starts_with("\r\n") ? end + 2 : end + 1;
}

/// One row, from its first line on.
class RowParser {
 public:
  RowParser() {
    csv_init(&parser_, CSV_STRICT | CSV_STRICT_FINI);
    csv_set_space_func(&parser_, [](unsigned char) { return 0; });
  }
  RowParser(const RowParser&) = delete;
  RowParser& operator=(const RowParser&) = delete;
  ~RowParser() { csv_free(&parser_); }

  /// Take in the next line. @return false where it cannot be part of a row.
  bool take(std::string_view line) {
    return csv_parse(&parser_, line.data(), line.size(), on_field, on_row, this) == line.size();
  }
  /// There is no further line. @return false where a quote is open.
  bool end() { return csv_fini(&parser_, on_field, on_row, this) == 0; }

  [[nodiscard]] bool complete() const { return complete_; }
  [[nodiscard]] std::vector<std::string>& fields() { return fields_; }

 private:
  static void on_field(void* bytes, std::size_t size, void* self) {
    static_cast<RowParser*>(self)->fields_.emplace_back(static_cast<const char*>(bytes), size);
  }
  static void on_row(int, void* self) { static_cast<RowParser*>(self)->complete_ = true; }

  csv_parser parser_ = {};
  std::vector<std::string> fields_;
  bool complete_ = false;
};

/// The row at the beginning of a text, and how many of its lines it takes.
struct Taken {
  CsvRow row;
  std::size_t bytes = 0;
  std::uint64_t lines = 0;
};

Taken take_row(std::string_view text) {
  RowParser parser;
  Taken taken;
  const auto broken = [text](const char* fault) { return Taken{{.fault = fault}, line_length(text), 1}; };
  while (!parser.complete() && taken.bytes < text.size()) {
    const std::size_t length = line_length(text.substr(taken.bytes));
    if (!parser.take(text.substr(taken.bytes, length))) {
      return broken("a quote stands inside a field; put the whole field in quotes and write its own quotes twice");
    }
    taken.bytes += length;
    ++taken.lines;
  }
  if (!parser.complete() && !parser.end()) return broken("a quote is opened and never closed; close it");
  taken.row.fields = std::move(parser.fields());
  return taken;
}

bool is_empty_line(std::string_view line) { return line.find_first_not_of("\r\n") == std::string_view::npos; }

}  // namespace

std::vector<CsvRow> csv_rows(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<CsvRow> rows;
  for (std::uint64_t line = 1; !text.empty();) {
    const std::size_t first = line_length(text);
    if (is_empty_line(text.substr(0, first))) {
      text.remove_prefix(first);
      ++line;
      continue;
    }
    Taken taken = take_row(text);
    taken.row.line = line;
    rows.push_back(std::move(taken.row));
    text.remove_prefix(taken.bytes);
    line += taken.lines;
  }
  return rows;
}

}  // namespace quadmatch::cli
