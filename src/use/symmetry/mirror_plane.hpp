#pragma once
/// The plane between the two sides of a model.

#include <optional>
#include <span>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/use/symmetry.hpp>

namespace quadmatch::use {

/// Of the size of a model, by how much half of the vertices may miss their partners in a plane that tells something.
constexpr double kPlaneFits = 0.005;

/// The mean length of the edges; 0 without positions.
[[nodiscard]] double mean_edge(const Mesh& mesh);

/// The plane in which the mirror images of vertices are nearest to their partners: least squares, then with less and
/// less weight for those that are far off, so that one sculpted cheek does not tilt it.
///
/// @param pairs  each of two partners, or of a vertex of the centre line with itself.
/// @return       nothing without pairs or positions.
/// @par Cost     O(#pairs), of which a sample is looked at.
[[nodiscard]] std::optional<MirrorPlane> fit_plane(const Mesh& mesh, std::span<const VertexPair> pairs);

/// The plane x, y or z = constant, through the middle of the model, in which most vertices have a vertex opposite; the
/// first of them if they are alike.
/// @pre       the mesh has positions.
/// @par Cost  O(#V log #V).
[[nodiscard]] MirrorPlane likely_plane(const Mesh& mesh, double edge);

}  // namespace quadmatch::use
