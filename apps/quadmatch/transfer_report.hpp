#pragma once
/// What a transfer came to: one value, told to a modeller or to a machine.

#include <string>
#include <utility>
#include <vector>

#include <quadmatch/use/transfer.hpp>

#include "match_report.hpp"

namespace quadmatch::cli {

struct TransferSummary {
  std::string source, target;  ///< paths
  std::uint32_t source_faces = 0;
  TransferReport report;
  TransferOptions options;
  Format format = Format::Obj;  ///< of the output
  std::vector<std::pair<std::string, std::string>> settings;
  Times times;  ///< matching: both, to match and to carry
  std::string output;

  /// Attributes that were carried and that the format of the output has no place for.
  [[nodiscard]] std::vector<std::string> not_written() const;
  /// Did all of the target take all that was to be carried?
  [[nodiscard]] bool complete() const { return report.complete() && not_written().empty(); }
};

/// "6 faces of the target from f12 on, f3 of the source: one of 2 ways to lay them".
[[nodiscard]] std::string describe(const LeftOutRegion& region);

[[nodiscard]] std::string as_text(const TransferSummary& summary);
[[nodiscard]] std::string as_json(const TransferSummary& summary);

}  // namespace quadmatch::cli
