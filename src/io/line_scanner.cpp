#include "line_scanner.hpp"

namespace quadmatch::io {

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kMost = 40;
  std::string shown = "'";
  for (const char c : text.substr(0, kMost)) shown += c >= ' ' && c <= '~' ? c : '?';
  return shown + (text.size() > kMost ? "...'" : "'");
}

std::string LineScanner::take_rest_of_line() {
  std::string text;
  const auto trim = [&text] {
    while (!text.empty() && is_blank(text.back())) text.pop_back();
  };
  skip_blanks();
  while (!is_line_end(*here_)) {
    if (*here_ == '\\' && continues_ && is_line_end(here_[1])) {
      skip_blanks();
      trim();
      text += ' ';
    } else {
      text += *here_++;
    }
  }
  trim();
  return text;
}

std::string LineScanner::take_comment() {
  const char* begin = ++here_;
  while (!is_line_end(*here_)) ++here_;
  if (is_blank(*begin)) ++begin;
  return {begin, here_};
}

}  // namespace quadmatch::io
