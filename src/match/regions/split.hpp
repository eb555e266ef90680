#pragma once
/// The last word on soundness: cut a patchwork into regions that satisfy the definition (§3), each by itself.

#include <vector>

#include <quadmatch/mesh/match.hpp>

#include "patchwork.hpp"
#include "rim.hpp"

namespace quadmatch::regions {

/// A sound region: its pairs in the order in which they were reached, each from a pair before it.
struct Piece {
  std::vector<Candidate> pairs;
  /// How many pairs had been reached at the end of each wave.
  std::vector<std::uint32_t> waves;
  /// The region of the patchwork from which it was cut.
  std::uint32_t region = 0;
  /// What speaks for it: see weigh_pieces().
  Evidence evidence = {};
  /// How many maps are as good, and whether none of them is better (see Region).
  std::uint32_t ways = 1;
  bool ambiguous = false;
};

/// Walk every region of a patchwork from the first of its faces that was matched, and keep what is connected, maps
/// vertices one-to-one and keeps adjacency both ways; what does not fit becomes a piece of its own.
/// @param patchwork  its regions become the pieces, with fresh numbers.
/// @param rim        of the patchwork: away from it nothing can disagree.
/// @return           pieces in the order of their starts.
/// @par Cost         O(#matched corners).
std::vector<Piece> split(const Sides& sides, Patchwork& patchwork, Rim& rim);

}  // namespace quadmatch::regions
