#pragma once
/// Two meshes and what is known to match in them, as files.

#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch {

struct Pair {
  PolygonSoup source, target;
  /// One orientation-preserving region, or nothing.
  std::vector<FacePair> region;
};

/// Write NAME-source.obj and NAME-target.obj into a folder, which is made if it is missing, and NAME-match.json where
/// there is a region.
[[nodiscard]] Expected<void> write_pair(const std::string& folder, const std::string& name, const Pair& pair);

}  // namespace quadmatch
