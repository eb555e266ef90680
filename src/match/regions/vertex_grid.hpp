#pragma once
/// Vertices by where they are.

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::regions {

/// The vertices of a mesh in a grid of cubes, to find those near a point.
class VertexGrid {
 public:
  /// @param cell  side of a cube, about as far as will be asked for; positive.
  /// @pre         the mesh has positions and outlives the grid.
  /// @par Cost    O(V).
  VertexGrid(const Mesh& mesh, double cell);
  [[nodiscard]] double cell() const { return cell_; }
  /// The nearest vertex within a distance, not valid if there is none.
  [[nodiscard]] VertexId nearest(const Point& p, double distance) const;
  [[nodiscard]] bool any_within(const Point& p, double distance) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  template <class Visit>
  void near(const Point& p, double distance, Visit visit) const;
  [[nodiscard]] Cell cell_of(const Point& p) const;
  [[nodiscard]] static std::uint64_t key_of(const Cell& cell);
  [[nodiscard]] std::size_t bucket_of(std::uint64_t key) const { return key >> shift_; }

  const Mesh& mesh_;
  double cell_;
  std::vector<std::pair<std::uint64_t, VertexId>> vertices_;  // with their keys, bucket by bucket, ascending in each
  std::vector<std::uint32_t> first_;                          // of each bucket in vertices_, and the end
  int shift_ = 0;
};

/// The mean length of the edges of a mesh, 0 if it has none.
[[nodiscard]] double mean_edge(const Mesh& mesh);

}  // namespace quadmatch::regions
