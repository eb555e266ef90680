#pragma once
/// OBJ's `l` and `p` lines, which name vertices and texture coordinates by number.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace quadmatch::use {

/// Where an element is now, counted from 0, or 0xffffffff for nowhere.
using NewNumber = std::function<std::uint32_t(std::uint32_t)>;

/// The line with the numbers of a renumbered mesh; a texture coordinate that is gone is left out. Lines of other kinds
/// stay as they are.
[[nodiscard]] std::string renumbered_line(std::string_view line, const NewNumber& vertex, const NewNumber& texture);

}  // namespace quadmatch::use
