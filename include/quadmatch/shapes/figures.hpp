#pragma once
/// The meshes of Figs. 4.1 and 4.2, which show why the greedy algorithm derails and the lazy-greedy one does not.

#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

/// M1: "This mesh has five extraordinary vertices, consisting of the four corners and the vertex marked start."
///
/// Reading: on a disk that cannot be. The numbers 4 - d of the inner vertices and 3 - d of the boundary vertices of a
/// quad mesh add up to 4 (2 - 2g - b), that is 4 on a disk; four corners of valence 2 make 4 already, and nothing is
/// left for "start". So ours is no disk: it has a small hole, whose rim passes through "start". Above "start" three
/// more columns of quads begin than there are below; the hole is where they begin. Its three sides are the columns'
/// lower ends, of which the outer two meet in "start", a boundary vertex of valence 7 that contributes the missing -4.
/// The caption then holds word for word, and the mesh is simple and well-formed.
struct Figure41 {
  PolygonSoup soup;
  /// The vertex marked "start".
  VertexId start;
  /// Leaves "start" along the rim of the hole.
  HalfedgeId seed;
};

/// M2: "an exact match for the quad mesh M1 except that three quads in the middle are compressed into individual
/// edges".
///
/// Reading: a quad squeezed flat between two opposite sides would make a triangle of each quad at its ends. So the
/// three quads, which stand in a row, are collapsed along parallel diagonals: together they become four edges in a
/// line, every other face stays a quad, and what lies above the row meets what lies below it out of step by one.
struct Figure42 {
  PolygonSoup soup;
  VertexId start;
  HalfedgeId seed;
  /// The true correspondence with M1: all its faces but three, ascending, of rotation 0. Its vertex map takes two
  /// vertices of M1 to one of M2 at three places, so that no single sound region can hold all of it.
  std::vector<FacePair> truth;
  /// The three quads of M1 that are squeezed in M2.
  std::vector<FaceId> squeezed;
};

[[nodiscard]] Figure41 fig_4_1();
[[nodiscard]] Figure42 fig_4_2();

}  // namespace quadmatch::shapes
