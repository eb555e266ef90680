#pragma once
/// Are two whole meshes the same up to numbering (§1.1.3, "an exact topological match"), and in how many ways?
///
/// What a mesh is, here: its faces, each a cyclic order of corners; which corners lie on the same vertex; and how many
/// vertices lie on no face. So an *isomorphism* pairs the faces of two meshes one to one, each with a rotation, such
/// that two corners lie on the same vertex in one mesh exactly if their images do in the other. Edges, seams, adjacency
/// and boundaries follow. Components that share vertices, or the edges of a seam, are bound by what they share.
///
/// An isomorphism *preserves* orientation where every face is read the same way round, or *reverses* it where every
/// face is turned over. One that turns some faces over and others not is none, even if they hang together nowhere: a
/// pair of shoes is not a pair of left shoes.
///
/// An *automorphism* is an isomorphism of a mesh with itself. Two that pair the same corners are the same: what becomes
/// of unused vertices is not counted.

#include <optional>
#include <string>
#include <vector>

#include <quadmatch/analysis/group_order.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// Which isomorphisms are looked for.
enum class IsomorphismKind {
  Preserving,
  Reversing,
  Either,  ///< preserving, or else reversing: one of the two for the whole mesh
};

struct Isomorphism {
  /// All faces, in one region for each component across edges, from the largest; all vertices that a face uses. A
  /// region's `ways` are the places that its faces can take, 2^32 - 1 where there are more; it is `ambiguous` where
  /// there are several, since positions were not asked.
  Match match;
  Orientation orientation = Orientation::Preserving;
  /// How many isomorphisms of this orientation there are, this one included.
  GroupOrder ways;
};

struct IsomorphismResult {
  /// Empty where the meshes are different.
  std::optional<Isomorphism> isomorphism;
  /// Then, what is different, in words: counts that are not the same, "the source has 12 components of 6 faces, the
  /// target 11". Never empty where there is no isomorphism.
  std::vector<std::string> differences;
};

/// Lay one mesh on the other as a whole, or say what is different.
///
/// @param source, target  any polygon meshes, dirty or not.
/// @return      a map that `verify` finds sound, the same for the same input on every run; of several isomorphisms an
///              arbitrary one.
/// @par Source  §1.1.3: "a simple O(m^2) algorithm ... starting from each possible matching of edges in G to a given
///              edge e in H".
/// @par Differs We start only where a mesh looks rarest (docs/design/012-isomorphism.md).
/// @par Cost    near O(#corners) of both where every component has vertices of its own, in practice; where components
///              share vertices, O(n log^2 n) in practice and exponential in the worst case. Nothing but counting where
///              counts are different.
[[nodiscard]] IsomorphismResult find_isomorphism(const Mesh& source, const Mesh& target,
                                                 IsomorphismKind kind = IsomorphismKind::Either);

struct Automorphisms {
  /// Those that preserve orientation. At least 1, the identity.
  GroupOrder preserving;
  /// Is there one that reverses it? Then those are as many. Not for a mesh without faces: there the one map does both.
  bool has_reversing = false;
  /// All of them.
  GroupOrder all;
};

/// Count the automorphisms of a mesh, exactly.
/// @par Cost  as of find_isomorphism, of the mesh and its mirror image.
[[nodiscard]] Automorphisms count_automorphisms(const Mesh& mesh);

}  // namespace quadmatch
