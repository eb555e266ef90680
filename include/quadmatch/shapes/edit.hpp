#pragma once
/// Edits as modelers make them, each with the true correspondence: what a matcher should find again.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

struct Edit {
  PolygonSoup soup;
  /// Every face that survives and where it is now, ascending by `source`; all rotations are 0. Orientation is kept.
  std::vector<FacePair> truth;
};

// Surviving faces keep their order and come before new ones; vertices keep theirs, those that no face of the result
// uses are left out, new ones follow. All edits cost O(#V + #corners).
//
// Common errors: what Mesh::build finds in the soup; BadArgument where the named element does not exist or the edit
// does not fit there, saying why.

/// Remove a patch: `count` faces, nearest first, around a face.
/// @param count  1 or more; faces beyond the component are not reached.
/// @par Errors   BadArgument also where no face would be left.
[[nodiscard]] Expected<Edit> delete_patch(const PolygonSoup& soup, FaceId centre, std::uint32_t count);

/// Lift a patch of `count` faces, nearest first, and join it to its old rim by a wall of quads. The faces of the patch
/// survive, but are no longer adjacent to what was around them.
/// @param height  how far along the patch's mean normal.
/// @par Errors    BadArgument also where the patch has no rim, or one that passes a vertex twice.
[[nodiscard]] Expected<Edit> extrude_patch(const PolygonSoup& soup, FaceId centre, std::uint32_t count, double height);

/// Insert an edge loop: split every quad of the poly-chord that crosses an edge in two. The split quads do not survive.
/// @param crossed  a half-edge along the edge.
/// @par Errors     BadArgument also where the chord meets a face other than a quad, or itself.
[[nodiscard]] Expected<Edit> insert_edge_loop(const PolygonSoup& soup, HalfedgeId crossed);

/// Remove a row of quads: what lies on both sides of the poly-chord that crosses an edge grows together, midway.
/// The quads of the row do not survive.
/// @param crossed  a half-edge along the edge.
/// @par Errors     BadArgument also where the chord meets a face other than a quad, or itself, or where the result
///                 would not be as well-formed as the mesh was (see `check`).
[[nodiscard]] Expected<Edit> remove_edge_loop(const PolygonSoup& soup, HalfedgeId crossed);

/// Turn what lies beyond a ring of quads by `shift` quads against the rest, and join it again. The quads of the ring do
/// not survive; no vertex moves.
/// @param crossed  a half-edge along an edge that the ring crosses.
/// @par Errors     BadArgument also where the row is no ring, has fewer than five quads, or meets a vertex twice.
[[nodiscard]] Expected<Edit> twist_ring(const PolygonSoup& soup, HalfedgeId crossed, std::uint32_t shift);

/// Open a slit along `length` edges, straight on from a half-edge. All faces survive; the inner vertices of the slit
/// get copies, in the same place, for the faces on its left.
/// @param length  2 or more: a slit of one edge opens nothing.
/// @par Errors    BadArgument also where the slit leaves the inside of the surface or meets itself.
[[nodiscard]] Expected<Edit> rip_edges(const PolygonSoup& soup, HalfedgeId start, std::uint32_t length);

/// Split every quad of a patch of `count` faces, nearest first, in four. Faces beside the patch get the new vertices as
/// corners; neither they nor the split quads survive.
/// @par Errors  BadArgument also where the centre is not a quad.
[[nodiscard]] Expected<Edit> refine_patch(const PolygonSoup& soup, FaceId centre, std::uint32_t count);

/// Replace two quads by a tube of four between them. The two do not survive.
/// @par Errors  BadArgument also where one is not a quad, or both share a vertex.
[[nodiscard]] Expected<Edit> add_handle(const PolygonSoup& soup, FaceId one, FaceId other);

/// Collapse a quad along a diagonal: the corner that a half-edge leaves from and the opposite one become one vertex
/// midway, and the quad two edges.
/// @par Errors  BadArgument also where the face is not a quad inside the surface, or the result would not be simple:
///              the two corners have another neighbour in common, or another corner has fewer than four faces.
[[nodiscard]] Expected<Edit> collapse_quad(const PolygonSoup& soup, HalfedgeId corner);

/// Two true correspondences one after the other.
/// @param first   source to middle.
/// @param second  middle to target, ascending by its source.
/// @param target  the last soup, for the sizes of its faces.
/// @return        source to target, in the order of `first`.
[[nodiscard]] std::vector<FacePair> chained(const std::vector<FacePair>& first, const std::vector<FacePair>& second,
                                            const PolygonSoup& target);

}  // namespace quadmatch::shapes
