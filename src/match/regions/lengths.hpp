#pragma once
/// Lengths of a mesh.

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::regions {

/// Logarithms of the lengths of edges and diagonals of one mesh.
class Lengths {
 public:
  explicit Lengths(const Mesh& mesh);

  /// From the corner that h leaves, along its edge.
  [[nodiscard]] float edge(HalfedgeId h) const { return at_[h].edge; }
  /// From the corner that h leaves to the one after the next.
  [[nodiscard]] float diagonal(HalfedgeId h) const { return at_[h].diagonal; }
  /// The median over all half-edges. @pre there are some
  [[nodiscard]] float median_edge() const;

  /// Say that lengths seen from the face of h are larger by these logarithms.
  void stretch(HalfedgeId h, float edge, float diagonal) {
    at_[h].edge += edge;
    at_[h].diagonal += diagonal;
  }

 private:
  struct Pair {
    float edge = 0, diagonal = 0;  // side by side: they are asked for together
  };
  PerHalfedge<Pair> at_;
};

}  // namespace quadmatch::regions
