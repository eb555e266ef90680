#pragma once
/// Catmull-Clark refinement: how a coarse cage becomes a smooth quad mesh, and a small mesh a large one.

#include <array>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

/// Refine once: a face of n corners becomes n quads, a mesh of quads four times as many.
///
/// Of V vertices, E edges and F faces the result has V + E + F vertices, in that order: the old vertices keep their
/// numbers; edge points are ordered by the lower, then the upper end; face points follow the faces. The quads of a
/// face are consecutive; the k-th begins at its corner k and goes on along its side k.
///
/// An edge is a pair of vertices, however many faces use it and in whatever direction, so a refined mesh is as
/// connected as it was before. Edges of other than two faces (boundaries, non-manifold edges) stay sharp: their
/// points are midpoints; a vertex on exactly two of them follows the boundary rule, on any other number it stays put.
///
/// @param soup  any polygons, degenerate ones too; without positions only the connectivity is refined.
/// @pre V + E + F < 2^32 - 1, and every corner is a vertex
/// @par Source  Catmull and Clark 1978; boundaries as in DeRose, Kass and Truong 1998.
/// @par Cost    O(#V + #corners) time and memory, O(d log d) at a vertex of d edges.
[[nodiscard]] PolygonSoup catmull_clark(const PolygonSoup& soup);

/// The same, `steps` times.
[[nodiscard]] PolygonSoup catmull_clark(PolygonSoup soup, unsigned steps);

/// u, v of a corner.
using TextureCoordinate = std::array<double, 2>;

/// Texture coordinates of the refined mesh, by linear interpolation within each face, so that seams stay seams.
/// @param soup         before refinement.
/// @param coordinates  one per corner of it.
/// @return             one per corner of catmull_clark(soup).
[[nodiscard]] std::vector<TextureCoordinate> refine_coordinates(const PolygonSoup& soup,
                                                                const std::vector<TextureCoordinate>& coordinates);

}  // namespace quadmatch::shapes
