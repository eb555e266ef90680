#pragma once
/// Meshes that break a condition of §2.1, each in one way: what dirty files hold, as small as can be.

#include <cstdint>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

// Not orientable: the faces are wound alike as far as they go round, and one seam is left where they cannot be.

/// n quads around with half a twist; the seam is one edge, between the last quad and the first. @pre n >= 3
[[nodiscard]] PolygonSoup mobius_strip(std::uint32_t n);
/// m quads around, n along, closed up turned over; the seam is the loop of m edges between the last row and the
/// first. @pre m, n >= 3
[[nodiscard]] PolygonSoup klein_bottle(std::uint32_t m, std::uint32_t n);

// Edges of more than two faces.

/// Three quads at one edge, the pages at their spine: condition 3.
[[nodiscard]] PolygonSoup book();
/// The proof of Obs. 2.2 as a file would hold it: 2 poles, each split in a top and a bottom vertex, joined by tubes of
/// two quads each: 4 vertices and as many quads as one likes, genus tubes - 1.
///
/// Reading: an edge of a file is a pair of vertices, and all 4 `tubes` edges of this surface join one of four pairs, so
/// every edge is non-manifold in the file although the surface is smooth. `dog_toy` is the simple mesh of that surface.
/// @pre tubes >= 2
[[nodiscard]] PolygonSoup observation_2_2(std::uint32_t tubes);

// Vertices of several fans: condition 1.

/// Two cubes that share one vertex.
[[nodiscard]] PolygonSoup hourglass();
/// Two quads that share one vertex: the boundary passes it twice, condition 2.
[[nodiscard]] PolygonSoup bow_tie();

// Faces that do not fit.

/// Two quads side by side, the second turned over.
[[nodiscard]] PolygonSoup wrongly_wound();
/// A square frame as one ten-sided face, joined to itself along the cut to the quad in its middle.
[[nodiscard]] PolygonSoup self_glued_face();
/// A row of three quads, the middle one with two corners merged into one, written twice.
[[nodiscard]] PolygonSoup degenerate_face();
/// A cube whose last face stands in the file twice: condition 4.
[[nodiscard]] PolygonSoup duplicate_faces();
/// Two quads on an L of five edges: they meet in two edges, around a vertex of valence 2; condition 4.
[[nodiscard]] PolygonSoup overlapping_faces();
/// One quad among ten vertices: 1, 3, 5 and 7 are used.
[[nodiscard]] PolygonSoup unused_vertices();

}  // namespace quadmatch::shapes
