#pragma once
/// The match that a verb puts to use: found here, or read from a file.

#include <optional>
#include <string>

#include <quadmatch/match/matcher.hpp>

#include "console.hpp"
#include "inputs.hpp"
#include "match_arguments.hpp"

namespace quadmatch::cli {

/// What --match, --orientation and --no-positions say.
struct MatchWishes {
  std::string file = {};  ///< empty: match here
  std::string orientation = "auto";
  bool no_positions = false;
  bool waves = false;  ///< keep how a match that is found here grew
};

/// Complains where wishes about matching contradict a match that is given.
[[nodiscard]] bool wishes_fit(const MatchWishes& wishes);

/// @return  nothing, after a complaint, where the file cannot be read or is of other meshes.
[[nodiscard]] std::optional<Match> find_or_read_match(const MatchWishes& wishes, const MeshFile& source,
                                                      const MeshFile& target, Progress& progress);

/// What is dirty in a mesh, as a warning.
void warn_of_dirt(const MeshFile& file);

}  // namespace quadmatch::cli
