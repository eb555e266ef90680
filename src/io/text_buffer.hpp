#pragma once
/// Text under construction: numbers in their shortest form that reads back the same, without a locale.

#include <cstdint>
#include <string>
#include <string_view>

namespace quadmatch::io {

class TextBuffer {
 public:
  TextBuffer& operator<<(char c) {
    text_.push_back(c);
    return *this;
  }
  TextBuffer& operator<<(std::string_view text) {
    text_.append(text);
    return *this;
  }
  TextBuffer& operator<<(std::int64_t number);
  TextBuffer& operator<<(std::uint64_t number);
  TextBuffer& operator<<(std::uint32_t number) { return *this << std::uint64_t{number}; }
  TextBuffer& operator<<(float number);
  TextBuffer& operator<<(double number);

  void reserve(std::size_t size) { text_.reserve(size); }
  [[nodiscard]] std::string take() && { return std::move(text_); }

 private:
  std::string text_;
};

/// A text that must stay on its line: line breaks become blanks.
[[nodiscard]] std::string one_line(std::string_view text);

}  // namespace quadmatch::io
