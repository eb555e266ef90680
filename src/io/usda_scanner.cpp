#include "usda_scanner.hpp"

#include <algorithm>

#include "number.hpp"

namespace quadmatch::io {
namespace {

bool is_word_character(char c) {
  const bool beyond_ascii = static_cast<unsigned char>(c) >= 0x80;  // letters of other alphabets, in UTF-8
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || is_digit(c) || c == '_' || c == ':' || c == '.' ||
         beyond_ascii;
}

/// May a number end before this character?
bool ends_number(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == ',' || c == ')' || c == ']' || c == '}' || c == ':' ||
         c == ';' || c == '#';
}

}  // namespace

void UsdaScanner::take_comment() {
  const char* begin = here_ + 1;
  here_ = std::find_if(here_, end_, [](char c) { return c == '\n' || c == '\r'; });
  const std::string_view text(begin, static_cast<std::size_t>(here_ - begin));
  if (text.substr(0, 5) == "usda ") return;  // the first line
  comments_.emplace_back(text.substr(!text.empty() && text.front() == ' ' ? 1 : 0));
}

bool UsdaScanner::skip_blanks() {
  for (; here_ < end_; ++here_) {
    if (*here_ == '#') take_comment();
    if (here_ == end_) break;
    if (*here_ == '\n') ++line_;
    if (*here_ != ' ' && *here_ != '\t' && *here_ != '\n' && *here_ != '\r' && *here_ != ';') return true;
  }
  return false;
}

bool UsdaScanner::take(char c) {
  if (!skip_blanks() || *here_ != c) return false;
  ++here_;
  return true;
}

std::string_view UsdaScanner::take_word() {
  if (!skip_blanks()) return {};
  const char* const begin = here_;
  while (here_ < end_ && is_word_character(*here_)) ++here_;
  if (here_ != begin && end_ - here_ >= 2 && here_[0] == '[' && here_[1] == ']') here_ += 2;  // the type of an array
  return {begin, static_cast<std::size_t>(here_ - begin)};
}

bool UsdaScanner::skip_until(std::string_view stop) {
  const char* const found = std::search(here_, end_, stop.begin(), stop.end());
  line_ += static_cast<std::uint64_t>(std::count(here_, found, '\n'));
  here_ = found;
  if (found == end_) return false;
  here_ += stop.size();
  return true;
}

bool UsdaScanner::take_string(std::string_view& text) {
  if (!skip_blanks() || (*here_ != '"' && *here_ != '\'')) return false;
  const char quote = *here_;
  const std::string triple(3, quote);
  if (end_ - here_ >= 3 && std::string_view(here_, 3) == triple) {
    here_ += 3;
    const char* const begin = here_;
    if (!skip_until(triple)) return false;
    text = {begin, static_cast<std::size_t>(here_ - 3 - begin)};
    return true;
  }
  const char* const begin = ++here_;
  for (; here_ < end_ && *here_ != quote && *here_ != '\n'; ++here_) {
    if (*here_ == '\\' && here_ + 1 < end_ && here_[1] != '\n') ++here_;
  }
  if (here_ >= end_ || *here_ != quote) return false;
  text = {begin, static_cast<std::size_t>(here_ - begin)};
  ++here_;
  return true;
}

bool UsdaScanner::take_real(double& value) {
  if (!skip_blanks()) return false;
  const char* const stop = parse_real(here_, value);
  if (stop == nullptr || !ends_number(*stop)) return false;
  here_ = stop;
  return true;
}

bool UsdaScanner::take_integer(std::int64_t& value) {
  if (!skip_blanks()) return false;
  const char* const stop = parse_integer(here_, value);
  if (stop == nullptr || !ends_number(*stop)) return false;
  here_ = stop;
  return true;
}

bool UsdaScanner::skip_atom() {
  std::string_view text;
  switch (*here_) {
    case '"':
    case '\'':
      return take_string(text);
    case '<':
      return skip_until(">");
    case '@': {
      const bool triple = end_ - here_ >= 3 && std::string_view(here_, 3) == "@@@";
      here_ += triple ? 3 : 1;
      return skip_until(triple ? "@@@" : "@");
    }
    default:
      break;
  }
  const auto belongs = [](char c) { return is_word_character(c) || c == '-' || c == '+'; };
  const char* const begin = here_;
  while (here_ < end_ && belongs(*here_)) ++here_;
  return here_ != begin;
}

bool UsdaScanner::skip_value() {
  // Brackets are only counted: which closes which matters to no one who passes the value over.
  std::uint64_t depth = 0;
  do {
    if (!skip_blanks()) return false;
    const char c = *here_;
    if (c == '(' || c == '[' || c == '{') {
      ++depth;
      ++here_;
    } else if (c == ')' || c == ']' || c == '}') {
      if (depth == 0) return false;
      --depth;
      ++here_;
    } else if (const char* const before = here_; !skip_atom()) {
      if (depth == 0 || here_ != before) return false;
      ++here_;  // commas, equal signs
    }
  } while (depth > 0);
  return true;
}

std::string_view UsdaScanner::rest() const {
  const char* const stop = std::find_if(here_, end_, [](char c) { return c == '\n' || c == '\r'; });
  return {here_, static_cast<std::size_t>(stop - here_)};
}

}  // namespace quadmatch::io
