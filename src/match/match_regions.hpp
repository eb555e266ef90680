#pragma once
/// Algorithm::Regions from two meshes to the match: both ways round, and what of each is kept.

#include <quadmatch/match/matcher.hpp>

namespace quadmatch {

[[nodiscard]] Match match_regions(const Mesh& source, const Mesh& target, const MatchOptions& options);

}  // namespace quadmatch
