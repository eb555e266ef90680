#pragma once
/// Well-behaved small meshes for tests, made in code and named for what they stress.
/// All have positions, and faces counter-clockwise seen from outside (from above where they are flat).

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

// Surfaces with a boundary.

/// m by n quads in the plane. Vertex (i, j) has number j (m + 1) + i, quad (i, j) number j m + i and starts at its
/// lower left corner. @pre m, n >= 1
[[nodiscard]] PolygonSoup grid(std::uint32_t m, std::uint32_t n);
/// An open tube: m quads around, n along, no extraordinary vertex. @pre m >= 3, n >= 1
[[nodiscard]] PolygonSoup cylinder(std::uint32_t m, std::uint32_t n);
/// n grids of k by k quads around vertex 0 of valence n, like the petals of a flower. @pre n >= 3, k >= 1
[[nodiscard]] PolygonSoup star(std::uint32_t n, std::uint32_t k);

// Closed surfaces.

/// m quads around, n along; all vertices regular, every map of it ambiguous. @pre m, n >= 3
[[nodiscard]] PolygonSoup torus(std::uint32_t m, std::uint32_t n);
/// Six quads: every vertex has valence 3, none is regular.
[[nodiscard]] PolygonSoup cube();
/// A cube of k by k quads a side: eight vertices of valence 3, alike. @pre k >= 1
[[nodiscard]] PolygonSoup cube_subdivided(std::uint32_t k);
/// The same connectivity, round: a sphere whose eight corners have valence 3. @pre k >= 1
[[nodiscard]] PolygonSoup sphere(std::uint32_t k);
/// n quads between two n-gons: a mesh of mixed polygons, all vertices of valence 3. @pre n >= 3, n = 4 is a cube
[[nodiscard]] PolygonSoup prism(std::uint32_t n);
/// A plate with m by n square holes through it: genus m n, many parts alike. @pre m, n >= 1
[[nodiscard]] PolygonSoup grating(std::uint32_t m, std::uint32_t n);
/// Fig. 2.1's dog toy of genus g: g + 1 tubes of `rings` quads' length join two poles, two vertices at each pole
/// having valence 2 g + 2. Obs. 2.2's construction (see observation_2_2), refined enough to be simple.
/// 4 (g + 1) rings quads. @pre genus >= 1, rings >= 2
[[nodiscard]] PolygonSoup dog_toy(std::uint32_t genus, std::uint32_t rings = 2);

// Several pieces.

/// All the soups in one, in order, their vertices and faces renumbered consecutively. Positions are kept where every
/// soup has them.
[[nodiscard]] PolygonSoup disjoint_union(const std::vector<PolygonSoup>& soups);
/// n cubes in a row: components that only positions can tell apart. @pre n >= 1
[[nodiscard]] PolygonSoup many_components(std::uint32_t n);

}  // namespace quadmatch::shapes
