#pragma once
/// Where the gadgets of a cubic planar graph are drawn: how much room each vertex has, and where its chains leave it.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <quadmatch/shapes/cubic_graph.hpp>

namespace quadmatch::shapes {

struct Vector {
  double x = 0, y = 0;
};

[[nodiscard]] inline Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
[[nodiscard]] inline Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
[[nodiscard]] inline Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
/// A quarter turn to the left.
[[nodiscard]] inline Vector left_of(Vector a) { return {-a.y, a.x}; }

[[nodiscard]] inline double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
[[nodiscard]] inline double length(Vector a) { return std::sqrt(dot(a, a)); }
/// @pre a is not zero
[[nodiscard]] inline Vector unit(Vector a) { return (1.0 / length(a)) * a; }

/// A place of the graph's drawing, seen from one end of an edge.
struct Port {
  Vector leaving;  ///< unit vector along which the chain leaves the gadget
  Vector edge;     ///< unit vector along the edge
  double chain_half_width = 0;
};

/// The disk about a vertex of the graph that is its own.
struct Frame {
  Vector centre;
  double radius = 0;
  /// In the order of `turns`.
  std::array<Port, 3> ports = {};
  /// The graph's edges, counter-clockwise, from the lowest.
  std::array<std::uint32_t, 3> turns = {};
};

/// A frame for each vertex. Disks meet neither each other nor edges of other vertices.
[[nodiscard]] std::vector<Frame> frames_of(const CubicGraph& graph, const std::vector<GridPoint>& points);

}  // namespace quadmatch::shapes
