#pragma once
/// The match file, `quadmatch.match/1`: JSON with 0-based indices in file order (docs/formats.md).

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>

namespace quadmatch {

/// One of the two meshes, as the match file names it.
struct MatchSide {
  std::string path;
  std::uint32_t vertices = 0;
  std::uint32_t faces = 0;

  bool operator==(const MatchSide&) const = default;
};

struct MatchFile {
  MatchSide source;
  MatchSide target;
  Match match;
  /// Settings it was made with, e.g. {"algorithm", "lazy-greedy"}; written as strings, in this order.
  std::vector<std::pair<std::string, std::string>> settings = {};
  /// What an exact search proved; written as `statistics`, passed over when read.
  std::optional<Optimality> optimality = {};
  /// Fields beside these, each a name and a JSON text: written at the end, passed over when read.
  std::vector<std::pair<std::string, std::string>> further = {};
};

/// Read a match file; `-` reads standard input. Fields it does not know are passed over, in any order; `evidence`,
/// `waves`, `settings` and `complete` may be missing.
///
/// @par Errors  CannotRead; Syntax, BadNumber and Truncated with the line; Syntax for a missing field; BadIndex for a
///              face or vertex beyond the counts that the file itself states, naming region and pair.
/// @par Cost    O(size), about 10 ns a byte; no more memory than the match itself.
[[nodiscard]] Expected<MatchFile> read_match(const std::string& path);
/// The same from memory; `name` is what errors call it.
[[nodiscard]] Expected<MatchFile> parse_match(std::string_view bytes, const std::string& name);

/// Does a match file speak of meshes of these sizes? MatchDoesNotFit, saying which side differs and how, if not.
/// @param source, target  the meshes at hand; their paths stand in the message.
[[nodiscard]] Expected<void> fits(const MatchFile& file, const MatchSide& source, const MatchSide& target);

/// Write a match file, all or nothing; `-` writes standard output. The same match gives the same bytes; in paths and
/// settings, bytes that are no UTF-8 become U+FFFD.
[[nodiscard]] Expected<void> write_match(const std::string& path, const MatchFile& file);
[[nodiscard]] std::string format_match(const MatchFile& file);

}  // namespace quadmatch
