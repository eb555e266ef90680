// A report is the viewer's page with two texts put in their places: a header, and the bytes of meshes and match.

#include <quadmatch/report/report.hpp>

#include <utility>

#include <quadmatch/io/file.hpp>

#include "header.hpp"
#include "match_blocks.hpp"
#include "mesh_blocks.hpp"
#include "packer.hpp"
#include "page.hpp"

namespace quadmatch {

PackedReport pack_report(const MeshFile& source, const MeshFile& target, const Match& match, const ReportText& text) {
  report::Blocks blocks;
  const report::MeshHeader source_header = report::add_mesh(blocks, "source", source);
  const report::MeshHeader target_header = report::add_mesh(blocks, "target", target);
  report::add_match(blocks, source.mesh, target.mesh, match);
  report::add_changes(blocks, text.changes);
  std::string header = report::format_header(source_header, target_header, match, text, blocks);
  return {std::move(header), std::move(blocks).take_bytes()};
}

std::string format_report(const MeshFile& source, const MeshFile& target, const Match& match, const ReportText& text) {
  const PackedReport packed = pack_report(source, target, match, text);
  const std::string_view page = report::page();
  const std::size_t header_place = page.find(report::kHeaderPlace);
  const std::size_t data_place = page.find(report::kDataPlace);
  std::string html;
  html.reserve(page.size() + packed.bytes.size() / 3 * 4 + packed.header.size() + 64);
  html += page.substr(0, header_place);
  html += packed.header;
  const std::size_t between = header_place + report::kHeaderPlace.size();
  html += page.substr(between, data_place - between);
  report::append_base64(html, packed.bytes);
  html += page.substr(data_place + report::kDataPlace.size());
  return html;
}

Expected<void> write_report(const std::string& path, const MeshFile& source, const MeshFile& target, const Match& match,
                            const ReportText& text) {
  if (!report::has_viewer()) {
    return Unexpected(
        Error{ErrorCode::CannotWrite,
              "this program was built without the viewer that reports hold; scripts/build_web.sh makes it, "
              "then build again",
              path});
  }
  return replace_file(path, format_report(source, target, match, text));
}

}  // namespace quadmatch
