#include "carried_lines.hpp"

#include <charconv>
#include <limits>
#include <optional>

namespace quadmatch::use {
namespace {

/// The number at the front, counted from 0; steps over it.
std::optional<std::uint32_t> take_number(std::string_view& text) {
  std::uint32_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || number == 0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number - 1;
}

}  // namespace

std::string renumbered_line(std::string_view line, const NewNumber& vertex, const NewNumber& texture) {
  if (!line.starts_with("l ") && !line.starts_with("p ")) return std::string(line);
  std::string text(line.substr(0, 1));
  std::string_view rest = line.substr(1);
  while (rest.starts_with(' ')) {
    rest.remove_prefix(1);
    const std::optional<std::uint32_t> v = take_number(rest);
    if (!v) return std::string(line);
    text += ' ' + std::to_string(vertex(*v) + std::uint64_t{1});
    if (!rest.starts_with('/')) continue;
    rest.remove_prefix(1);
    const std::optional<std::uint32_t> vt = take_number(rest);
    if (!vt) return std::string(line);
    const std::uint32_t place = texture(*vt);
    if (place != std::numeric_limits<std::uint32_t>::max()) text += '/' + std::to_string(place + std::uint64_t{1});
  }
  return text;
}

}  // namespace quadmatch::use
