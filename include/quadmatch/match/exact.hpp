#pragma once
/// The largest region of two meshes, proved: what the NP-hard problem of §3 asks for, as far as it can be had.

#include <cstdint>
#include <functional>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// How far a search for the largest region is.
struct ExactProgress {
  std::uint32_t faces = 0;  ///< of the best region so far
  std::uint32_t bound = 0;  ///< the most a region can have
  std::uint64_t nodes = 0;  ///< searched
};

struct ExactOptions {
  /// `Auto`: the larger of both ways round.
  OrientationChoice orientation = OrientationChoice::Auto;
  /// Theorem 3.2's question: is there a region of so many faces? The search ends as soon as that is known. 0: not
  /// asked.
  std::uint32_t at_least = 0;
  /// Nodes to search at most; 0: no limit.
  std::uint64_t node_limit = 0;
  /// Called every few milliseconds; returning false stops. The library looks at no clock, so a limit of time is made of
  /// this.
  std::function<bool(const ExactProgress& progress)> progress = {};
};

struct LargestRegion {
  /// One region, or none where no pair of faces has as many corners. `complete` is false where the search was stopped.
  Match match;
  Optimality optimality;
};

/// Find the largest region there is (see verify), and prove it.
///
/// @param source, target  any polygon meshes, of any number of components, dirty or not. Positions are not looked at.
/// @return      the largest region found and what is proved of it, the same for the same input, and for the same
///              `node_limit`. Of several largest ones, any.
/// @par Cost    exponential in the worst case: the problem is NP-hard (Theorem 3.1). Patches of 200 quads after a local
///              edit take a second mostly, long loops and regular areas far longer (docs/design/011-exact.md).
///              Memory O(F) and, on the way down, O(depth * rim).
[[nodiscard]] LargestRegion largest_region(const Mesh& source, const Mesh& target, const ExactOptions& options = {});

}  // namespace quadmatch
