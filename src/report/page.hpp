#pragma once
/// The viewer: an HTML file that scripts/build_web.sh makes of web/, here as a constant.

#include <string_view>

namespace quadmatch::report {

/// With kHeaderPlace and kDataPlace in it once each, where a report has its own.
[[nodiscard]] std::string_view page();
/// Was there a viewer when this was built? If not, the page only says so.
[[nodiscard]] bool has_viewer();

constexpr std::string_view kHeaderPlace = "@QUADMATCH_HEADER@";
constexpr std::string_view kDataPlace = "@QUADMATCH_DATA@";

}  // namespace quadmatch::report
