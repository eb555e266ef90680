#pragma once
/// What stands in front of the bytes of a report, as JSON that can stand in HTML.

#include <string>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/report/report.hpp>

#include "mesh_blocks.hpp"

namespace quadmatch::report {

/// `quadmatch.report/1`, on one line. No text in it can end the element it stands in: every < is written \u003c. Bytes
/// that are no UTF-8 become U+FFFD.
[[nodiscard]] std::string format_header(const MeshHeader& source, const MeshHeader& target, const Match& match,
                                        const ReportText& text, const Blocks& blocks);

}  // namespace quadmatch::report
