#include "text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace quadmatch::cli {

std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3;) digits.insert(at -= 3, 1, ',');
  return digits;
}

std::string counted(std::uint64_t number, std::string_view noun, std::string_view plural) {
  if (number == 1) return fmt::format("1 {}", noun);
  return plural.empty() ? fmt::format("{} {}s", grouped(number), noun) : fmt::format("{} {}", grouped(number), plural);
}

std::string percent(std::uint64_t part, std::uint64_t whole) {
  const double share = whole == 0 ? 1.0 : static_cast<double>(part) / static_cast<double>(whole);
  // Down, not to the nearest: one face of a million that was not matched must not read as 100.0 %.
  return fmt::format("{:.1f} %", std::floor(share * 1000.0) / 10.0);
}

std::string duration(double milliseconds) {
  if (milliseconds < 10.0) return fmt::format("{:.1f} ms", milliseconds);
  if (milliseconds < 1000.0) return fmt::format("{:.0f} ms", milliseconds);
  return fmt::format("{:.2f} s", milliseconds / 1000.0);
}

std::string display_name(const std::string& path) { return path == "-" ? "standard input" : path; }

std::string byte_size(std::uint64_t bytes) {
  double size = static_cast<double>(bytes) / 1e3;
  const char* unit = "kB";
  for (const char* larger : {"MB", "GB", "TB"}) {
    if (size < 1000) break;
    size /= 1e3;
    unit = larger;
  }
  return size < 10 ? fmt::format("{:.1f} {}", size, unit) : fmt::format("{:.0f} {}", size, unit);
}

std::string joined(const std::vector<std::string>& parts, std::string_view separator) {
  return fmt::format("{}", fmt::join(parts, separator));
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      text += i == 0 ? fmt::format("{:<{}}", row[i], widths[i]) : fmt::format("  {:>{}}", row[i], widths[i]);
    }
    text += '\n';
  }
  return text;
}

std::string Lines::render(std::size_t indent) const {
  std::size_t width = 0;
  for (const auto& [name, text] : lines_) width = std::max(width, name.size());
  std::string rendered;
  for (const auto& [name, text] : lines_) rendered += fmt::format("{:{}}{:<{}}  {}\n", "", indent, name, width, text);
  return rendered;
}

void add_written(Lines& lines, std::vector<std::string> files, const std::vector<std::string>& more) {
  files.insert(files.end(), more.begin(), more.end());
  const char* name = "written";
  for (const std::string& file : files) {
    if (file.empty()) continue;
    lines.add(name, file);
    name = "";
  }
}

}  // namespace quadmatch::cli
