#pragma once
/// Where the source lies in the space of the target: a similarity, if there is one that lays many vertices on vertices.

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "mending.hpp"
#include "similarity.hpp"

namespace quadmatch::regions {

/// The vertices of a mesh in a grid of cubes, to find those near a point.
class VertexGrid {
 public:
  /// @param cell  side of a cube, about as far as will be asked for.
  VertexGrid(const Mesh& mesh, double cell);
  /// The nearest vertex within a distance, not valid if there is none.
  [[nodiscard]] VertexId nearest(const Point& p, double distance) const;
  [[nodiscard]] bool any_within(const Point& p, double distance) const;

 private:
  using Cell = std::array<std::int64_t, 3>;
  template <class Visit>
  void near(const Point& p, double distance, Visit visit) const;
  [[nodiscard]] Cell cell_of(const Point& p) const;
  [[nodiscard]] static std::uint64_t key_of(const Cell& cell);

  const Mesh& mesh_;
  double cell_;
  std::vector<std::pair<std::uint64_t, VertexId>> vertices_;  // by key
};

/// The mean length of the edges of a mesh, 0 if it has none.
[[nodiscard]] double mean_edge(const Mesh& mesh);

/// Choose among no motion at all and the best fits of what is matched: the whole, and its largest regions.
/// @return  nothing where none lays three vertices in ten on vertices: the model is posed, or another.
/// @pre     both meshes have positions.
[[nodiscard]] std::optional<Similarity> find_placement(const Workbench& bench, const VertexGrid& target_grid,
                                                       double edge);

/// Is one mesh the other, moved as a whole, as far as a sample of the matched faces tells? A tube turned by one step is
/// equal as connectivity goes.
[[nodiscard]] bool lies_well(const Workbench& bench);

}  // namespace quadmatch::regions
