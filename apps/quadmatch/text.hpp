#pragma once
/// How figures read in a sentence or a table.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace quadmatch::cli {

/// "13,378".
[[nodiscard]] std::string grouped(std::uint64_t number);
/// "1 face", "13,378 faces"; `plural` only where an s does not make it.
[[nodiscard]] std::string counted(std::uint64_t number, std::string_view noun, std::string_view plural = {});
/// "96.4 %" of a whole; "100.0 %" of nothing. Only all of it reads as 100.0 %.
[[nodiscard]] std::string percent(std::uint64_t part, std::uint64_t whole);
/// "12 ms", "1.25 s".
[[nodiscard]] std::string duration(double milliseconds);
/// "a.obj", or "standard input" for `-`.
[[nodiscard]] std::string display_name(const std::string& path);
/// "640 kB", "1.5 GB"; a thousand bytes are a kB.
[[nodiscard]] std::string byte_size(std::uint64_t bytes);
/// "a, b, c".
[[nodiscard]] std::string joined(const std::vector<std::string>& parts, std::string_view separator = ", ");

/// Rows under a header, in columns as wide as their cells; the first column is aligned left, the others right.
[[nodiscard]] std::string table(const std::vector<std::vector<std::string>>& rows);

/// "name     text" lines, the texts aligned; an empty name goes on with the text above.
class Lines {
 public:
  void add(std::string name, std::string text) { lines_.emplace_back(std::move(name), std::move(text)); }
  [[nodiscard]] std::string render(std::size_t indent = 0) const;

 private:
  std::vector<std::pair<std::string, std::string>> lines_;
};

/// "written  a.json" and below it the names of further files; empty names are of files that were not asked for.
void add_written(Lines& lines, std::vector<std::string> files, const std::vector<std::string>& more);

}  // namespace quadmatch::cli
