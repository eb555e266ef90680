#pragma once
/// Match two meshes: analysis, anchors, growth (§4), in one call.

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include <quadmatch/analysis/anchors.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

enum class Algorithm {
  Greedy,      ///< §4.4: every quad that fits, wave by wave
  LazyGreedy,  ///< §4.5: the largest component of the compatibility graph first
  Regions,     ///< many anchors, many regions, belief by evidence (docs/how-it-works.md)
  Exact,       ///< the largest region there is, proved; for small meshes (match/exact.hpp)
};

/// Which way round the target is laid on the source.
enum class OrientationChoice {
  Preserving,
  Reversing,
  /// Preserving; reversing as well where that leaves much unmatched. The paper's algorithms take the reversing match if
  /// it is far larger; regions takes the larger and fills the components it left from the other, so parts may differ.
  Auto,
};

/// The stages of Algorithm::Regions, each of which can be left out for comparison.
struct Stages {
  bool equal_parts = true;  ///< components that are the same are laid whole, before anything burns
  bool seams = true;        ///< seams between regions move to where they cost least
  bool ties = true;         ///< positions settle what corners and lengths cannot
  bool slides = true;       ///< rings matched a step round are turned back
  bool turns = true;        ///< and so is, as a whole, what hangs on them
  bool ventures = true;     ///< without lengths, regions go on past corners that disagree
  bool slivers = true;      ///< faces that no region can take in become regions of their own
  bool islands = true;      ///< parts cut off by new faces are reached by hops
  bool restarts = true;     ///< large parts left free are tried from rare corners
  bool rows = true;         ///< what is left free of a row of quads is made a whole row
  bool acceptance = true;   ///< what chance may have brought together is dropped
  bool doubts = true;       ///< what lies as well on something else is told to be ambiguous
};

/// A place the user knows to be the same: half-edge on half-edge (a face corner, or an edge of a face).
using UserAnchor = Anchor;

struct MatchOptions {
  Algorithm algorithm = Algorithm::Regions;
  OrientationChoice orientation = OrientationChoice::Auto;
  /// The paper's algorithms grow from the first that fits, and from none they find (§4.1); regions grows from all of
  /// them, then from what it finds, and never overrules them.
  std::vector<UserAnchor> anchors = {};
  AnchorOptions anchor_search = {};
  /// Regions only: let positions, where both meshes have them, weigh in where connectivity leaves a choice.
  bool positions = true;
  /// Regions only: leave out regions of which a smaller share of the extraordinary vertices agrees, 0 ... 1.
  double least_confidence = 0;
  /// Regions only: leave out regions of fewer faces.
  std::uint32_t least_region = 1;
  Stages stages = {};
  /// Exact only: end as soon as it is known whether there is a region of so many faces; 0: find the largest.
  std::uint32_t at_least = 0;
  /// Keep the growth order wave by wave.
  bool waves = false;
  /// Called now and then with faces matched so far and the most there can be (for Exact, what is proved of that);
  /// returning false cancels.
  std::function<bool(std::size_t matched, std::size_t most)> progress = {};
};

/// What the search saw, beside the match itself.
struct MatchResult {
  Match match;
  AnchorSearch search;
  /// The anchor that was grown from; not valid where nothing could be matched.
  Anchor seed;
  /// Exact only: what is proved.
  std::optional<Optimality> optimality = {};
};

/// Match two meshes from connectivity alone.
///
/// @param source, target  any polygon meshes.
/// @return      a sound match (see verify), of at most one region for the paper's algorithms; the same for the same
///              input on every run. `match.complete` is false after a cancel. `search` and `seed` are the paper's.
/// @pre         user anchors name half-edges of the meshes, of faces with equal corner counts (see check_anchor).
/// @par Cost    near linear in F in practice (docs/results.md); greedy is linear.
[[nodiscard]] MatchResult match(const Mesh& source, const Mesh& target, const MatchOptions& options = {});

/// Does a user's anchor name half-edges that exist, of faces that can lie on each other?
/// @par Errors  BadArgument, naming the element.
[[nodiscard]] Expected<void> check_anchor(const Mesh& source, const Mesh& target, const UserAnchor& anchor);

}  // namespace quadmatch
