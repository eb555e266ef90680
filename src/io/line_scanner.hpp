#pragma once
/// Walks over the text of a file, token by token and line by line, without copying any of it.

#include <cstdint>
#include <string>
#include <string_view>

#include <quadmatch/io/file.hpp>

#include "number.hpp"

namespace quadmatch::io {

/// A piece of a file for a message: in quotes, shortened, with bytes that a terminal could not show as `?`.
[[nodiscard]] std::string in_quotes(std::string_view text);

/// Lines end with LF, CR LF or CR; tokens are divided by blanks and tabs; `#` begins a comment. Every look ahead stops
/// at the line feeds behind the end of the file, so no step asks for the end but `at_end`.
class LineScanner {
 public:
  /// Does a backslash at the end of a line continue it on the next?
  enum class Continuation { No, Yes };

  /// @pre  behind the text a line feed stands, or it ends with one that no backslash precedes; eight more bytes may be
  ///       read. FileBytes and LineChunks see to it.
  LineScanner(std::string_view text, Continuation continuation)
      : here_(text.data()), end_(text.data() + text.size()), continues_(continuation == Continuation::Yes) {
    constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
    if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) here_ += kByteOrderMark.size();
  }
  LineScanner(const FileBytes& bytes, Continuation continuation) : LineScanner(bytes.view(), continuation) {}

  /// Go on with the next piece of the text, in which lines are counted on.
  void continue_with(std::string_view text) {
    here_ = text.data();
    end_ = text.data() + text.size();
  }

  /// Step over whole lines.
  void skip_lines(const char* to, std::uint64_t count) {
    here_ = to;
    line_ += count;
  }

  [[nodiscard]] bool at_end() const { return here_ >= end_; }
  /// The line scanned, from 1.
  [[nodiscard]] std::uint64_t line() const { return line_; }
  [[nodiscard]] const char* here() const { return here_; }
  [[nodiscard]] const char* end() const { return end_; }
  /// Bytes left to scan.
  [[nodiscard]] std::size_t remaining() const { return at_end() ? 0 : static_cast<std::size_t>(end_ - here_); }

  void skip_blanks() {
    while (true) {
      while (is_blank(*here_)) ++here_;
      if (*here_ != '\\' || !continues_ || !is_line_end(here_[1])) return;
      ++here_;
      step_over_line_end();
    }
  }

  /// After blanks: does the line hold nothing more, or a comment?
  [[nodiscard]] bool data_ends() {
    skip_blanks();
    return is_line_end(*here_) || *here_ == '#';
  }

  /// The token that begins at a place, by default where the scanner stands; empty at the end of a line.
  [[nodiscard]] std::string_view peek_token(const char* begin = nullptr) const {
    if (begin == nullptr) begin = here_;
    const char* stop = begin;
    while (!is_blank(*stop) && !is_line_end(*stop)) ++stop;
    return {begin, static_cast<std::size_t>(stop - begin)};
  }

  [[nodiscard]] std::string_view take_token() {
    skip_blanks();
    const std::string_view token = peek_token();
    here_ += token.size();
    return token;
  }

  /// Take a number that a blank, the end of the line or a comment follows; stay in front of it if there is none.
  template <class Real>
  [[nodiscard]] bool take_real(Real& value) {
    skip_blanks();
    const char* const stop = parse_real(here_, value);
    if (stop == nullptr || !ends_token(*stop)) return false;
    here_ = stop;
    return true;
  }

  /// Likewise a whole number.
  [[nodiscard]] bool take_integer(std::int64_t& value) {
    skip_blanks();
    const char* const stop = parse_integer(here_, value);
    if (stop == nullptr || !ends_token(*stop)) return false;
    here_ = stop;
    return true;
  }

  /// Take a whole number whatever follows it, e.g. `/` in a face.
  [[nodiscard]] bool take_prefix_integer(std::int64_t& value) {
    const char* const stop = parse_integer(here_, value);
    if (stop == nullptr) return false;
    here_ = stop;
    return true;
  }

  /// Take this character if it stands here.
  [[nodiscard]] bool take(char c) {
    if (*here_ != c) return false;
    ++here_;
    return true;
  }

  /// Step over bytes that are no text.
  /// @pre  count <= remaining()
  void skip_bytes(std::size_t count) { here_ += count; }

  /// Does a token end before this character?
  [[nodiscard]] static bool ends_token(char c) { return is_blank(c) || is_line_end(c) || c == '#' || c == '\\'; }

  /// Go to the beginning of the next line, over whatever is left of this one.
  void next_line() {
    while (!is_line_end(*here_)) {
      if (*here_ == '\\' && continues_ && is_line_end(here_[1])) {
        ++here_;
        step_over_line_end();
      } else {
        ++here_;
      }
    }
    step_over_line_end();
  }

  /// What is left of the line without blanks around it, continued lines joined by a blank; stops at its end.
  [[nodiscard]] std::string take_rest_of_line();

  /// The comment that begins at `#`, without it and without one blank after it; a backslash does not continue it.
  [[nodiscard]] std::string take_comment();

 private:
  [[nodiscard]] static bool is_blank(char c) { return c == ' ' || c == '\t'; }
  [[nodiscard]] static bool is_line_end(char c) { return c == '\n' || c == '\r'; }

  void step_over_line_end() {
    if (*here_ == '\r' && here_[1] == '\n') ++here_;
    ++here_;
    ++line_;
  }

  const char* here_;
  const char* end_;
  std::uint64_t line_ = 1;
  bool continues_;
};

}  // namespace quadmatch::io
