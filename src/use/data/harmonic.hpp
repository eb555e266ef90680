#pragma once
/// Values between known ones, so that each is the weighted mean of its neighbours: harmonic interpolation on a graph.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::use {

/// Two neighbours; several edges between the same two add up.
struct WeightedEdge {
  std::uint32_t one, other;
  double weight;  ///< more than 0
};

/// A value of `components` numbers at each node, as far as it is known.
struct GraphValues {
  std::uint32_t components = 1;
  std::vector<std::uint8_t> known = {};  ///< one per node
  std::vector<double> values = {};       ///< #nodes by components, row by row
};

/// Give every node that hangs together with a known one the harmonic value, and make it known. Others stay unknown.
/// @par Cost  one sparse Cholesky factorisation over the unknown nodes (Eigen's SimplicialLDLT).
void interpolate(const std::vector<WeightedEdge>& edges, GraphValues& graph);

/// How strongly the ends of a half-edge hold together: the inverse of its length, in units of the mean, so that linear
/// data stay linear along rows of unequal quads too. 1 where there are no positions.
[[nodiscard]] std::vector<double> edge_weights(const Mesh& mesh);

}  // namespace quadmatch::use
