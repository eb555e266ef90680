#pragma once
/// Match two meshes: analysis, anchors, growth (§4), in one call.

#include <cstddef>
#include <functional>
#include <vector>

#include <quadmatch/analysis/anchors.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

enum class Algorithm {
  Greedy,      ///< §4.4: every quad that fits, wave by wave
  LazyGreedy,  ///< §4.5: the largest component of the compatibility graph first
  Regions,     ///< many anchors, many regions, belief by evidence
};

/// Which way round the target is laid on the source.
enum class OrientationChoice {
  Preserving,
  Reversing,
  Auto,  ///< preserving; reversing as well where that leaves most of both meshes unmatched, and the far larger one wins
};

/// A place the user knows to be the same: half-edge on half-edge (a face corner, or an edge of a face).
using UserAnchor = Anchor;

struct MatchOptions {
  Algorithm algorithm = Algorithm::LazyGreedy;
  OrientationChoice orientation = OrientationChoice::Auto;
  /// Tried in this order, before any that are found; empty: find them (§4.1).
  std::vector<UserAnchor> anchors = {};
  AnchorOptions anchor_search = {};
  /// Regions only: let positions, where both meshes have them, weigh in where connectivity leaves a choice.
  bool positions = true;
  /// Keep the growth order wave by wave.
  bool waves = false;
  /// Called now and then with faces matched so far and the most there can be; returning false cancels.
  std::function<bool(std::size_t matched, std::size_t most)> progress = {};
};

/// What the search saw, beside the match itself.
struct MatchResult {
  Match match;
  AnchorSearch search;
  /// The anchor that was grown from; not valid where nothing could be matched.
  Anchor seed;
};

/// Match two meshes from connectivity alone.
///
/// @param source, target  any polygon meshes.
/// @return      a sound match (see verify), of at most one region for the paper's algorithms; the same for the same
///              input on every run. `match.complete` is false after a cancel.
/// @pre         user anchors name half-edges of the meshes, of faces with equal corner counts (see check_anchor).
/// @par Cost    near linear in F in practice (docs/results.md); greedy is linear.
[[nodiscard]] MatchResult match(const Mesh& source, const Mesh& target, const MatchOptions& options = {});

/// Does a user's anchor name half-edges that exist, of faces that can lie on each other?
/// @par Errors  BadArgument, naming the element.
[[nodiscard]] Expected<void> check_anchor(const Mesh& source, const Mesh& target, const UserAnchor& anchor);

}  // namespace quadmatch
