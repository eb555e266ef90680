#include "text_buffer.hpp"

#include <algorithm>
#include <charconv>

namespace quadmatch::io {
namespace {

template <class Number>
void append(std::string& text, Number number) {
  char digits[32];  // the longest double takes 24
  const std::to_chars_result result = std::to_chars(digits, digits + sizeof digits, number);
  text.append(digits, result.ptr);
}

}  // namespace

TextBuffer& TextBuffer::operator<<(std::int64_t number) {
  append(text_, number);
  return *this;
}

TextBuffer& TextBuffer::operator<<(std::uint64_t number) {
  append(text_, number);
  return *this;
}

TextBuffer& TextBuffer::operator<<(float number) {
  append(text_, number);
  return *this;
}

TextBuffer& TextBuffer::operator<<(double number) {
  append(text_, number);
  return *this;
}

std::string one_line(std::string_view text) {
  std::string line(text);
  std::replace_if(
      line.begin(), line.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return line;
}

}  // namespace quadmatch::io
