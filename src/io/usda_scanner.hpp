#pragma once
/// The tokens of USD text files: words, numbers, strings and brackets, on as many lines as they like.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <quadmatch/io/file.hpp>

namespace quadmatch::io {

class UsdaScanner {
 public:
  explicit UsdaScanner(const FileBytes& bytes) : here_(bytes.begin()), end_(bytes.end()) {}

  [[nodiscard]] std::uint64_t line() const { return line_; }
  /// Go over blanks, line breaks, semicolons and comments. @return whether anything is left.
  bool skip_blanks();
  /// After blanks: the next character, a line feed at the end of the file.
  [[nodiscard]] char peek() {
    skip_blanks();
    return here_ < end_ ? *here_ : '\n';
  }
  /// Take this character if it is next.
  [[nodiscard]] bool take(char c);
  /// Take a word of letters, digits and `_:.[]`, e.g. `point3f[]` or `primvars:st`; empty if none is next.
  [[nodiscard]] std::string_view take_word();
  /// Take a string in single, double or triple quotes, without them. False if none is next or it has no end.
  [[nodiscard]] bool take_string(std::string_view& text);
  [[nodiscard]] bool take_real(double& value);
  [[nodiscard]] bool take_integer(std::int64_t& value);
  /// Step over one value of any kind: a word, number, string, path, asset, or a bracket with all it holds.
  /// False if there is none or its bracket is not closed.
  [[nodiscard]] bool skip_value();

  /// The rest of the line, for messages.
  [[nodiscard]] std::string_view rest() const;
  [[nodiscard]] std::vector<std::string>& comments() { return comments_; }

 private:
  [[nodiscard]] bool skip_atom();
  /// Step over text up to and including `stop`. False if the file ends before.
  [[nodiscard]] bool skip_until(std::string_view stop);
  void take_comment();

  const char* here_;
  const char* end_;
  std::uint64_t line_ = 1;
  std::vector<std::string> comments_;
};

}  // namespace quadmatch::io
