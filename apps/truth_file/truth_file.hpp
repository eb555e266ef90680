#pragma once
/// A true correspondence as a file (JSON): {"orientation": "preserving", "partial": {}, "exact": [[f, g, r], ...]},
/// each triple a surviving face, where it is now, and how it is turned, as in the match file.

#include <string>
#include <vector>

#include <quadmatch/mesh/match.hpp>

namespace quadmatch {

/// @return  false where the file cannot be written.
[[nodiscard]] bool write_truth(const std::string& path, const std::vector<FacePair>& truth);

}  // namespace quadmatch
