#pragma once
/// Anchors (§4.1): where the two meshes are surely the same, and how they lie on each other there.

#include <cstdint>
#include <vector>

#include <quadmatch/analysis/colouring.hpp>
#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// An oriented seed: half-edge `source` lies on half-edge `target`, and so their faces on each other (§4.5.1).
struct Anchor {
  HalfedgeId source;
  HalfedgeId target;

  bool operator==(const Anchor&) const = default;
};

struct AnchorOptions {
  /// Rounds of refinement at most, the paper's k; at least one is made.
  std::uint32_t rounds = 10;
  ColouringOptions colouring = {};
  /// How many anchors to return at most.
  std::uint32_t count = 16;
};

/// How the anchors came about, for reports.
struct AnchorSearch {
  std::vector<Anchor> anchors;      ///< best first
  std::uint32_t rounds = 0;         ///< rounds made until they were found
  std::uint32_t source_rarity = 0;  ///< nodes of the source that have the first anchor's colour
  std::uint32_t target_rarity = 0;  ///< likewise in the target; 1 and 1 is a unique pair
  bool arbitrary = false;           ///< no extraordinary vertex or no common colour: any pair
};

/// Find anchors as §4.1 does: colour both skeleton graphs round by round until a colour is unique in both meshes or
/// `rounds` are made, take the rarest colour, then look for matching neighbours.
///
/// Among equally rare colours those stand first whose neighbours' colours disagree in fewer places, then those of later
/// rounds, in larger components of the skeleton (by edges traced), with more neighbours that agree, and the smaller
/// colour: none of which depends on the numbering. Only nodes alike in all of this stand in order of their numbers.
///
/// @pre          the graphs are skeletons (Tracing::skeleton), in which every arc ends at a node.
/// @par Reading  A pair that is unique by its codes alone (round 0) is kept as well: an edit can change what later
///               rounds see around it.
/// @par Reading  Where the neighbourhood is rotationally symmetric several alignments are equally good; all are
///               returned, in order.
/// @par Cost     O(rounds * #spokes log #spokes); O(F) where a mesh has no extraordinary vertex.
[[nodiscard]] AnchorSearch find_anchors(const Mesh& source, const ArcGraph& source_skeleton,
                                        const PerFan<VertexCode>& source_codes, const Mesh& target,
                                        const ArcGraph& target_skeleton, const PerFan<VertexCode>& target_codes,
                                        const AnchorOptions& options = {});

}  // namespace quadmatch
