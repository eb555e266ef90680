#pragma once
/// The viewer: an HTML file built from web/ and committed as src/report/page.html, here as a constant.

#include <string_view>

namespace quadmatch::report {

/// With kHeaderPlace and kDataPlace in it once each, where a report has its own.
[[nodiscard]] std::string_view page();

constexpr std::string_view kHeaderPlace = "@QUADMATCH_HEADER@";
constexpr std::string_view kDataPlace = "@QUADMATCH_DATA@";

}  // namespace quadmatch::report
