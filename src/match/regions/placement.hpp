#pragma once
/// Where the source lies in the space of the target: a similarity, if there is one that lays many vertices on vertices.

#include <optional>

#include "mending.hpp"
#include "similarity.hpp"

namespace quadmatch::regions {

/// Choose among no motion at all and the best fits of what is matched: the whole, and its largest regions.
/// @return  nothing where none lays three vertices in ten on vertices: the model is posed, or another.
/// @pre     both meshes have positions.
[[nodiscard]] std::optional<Similarity> find_placement(const Workbench& bench, const VertexGrid& target_grid);

/// A similarity that holds near one place.
struct LocalPlacement {
  Similarity similarity;
  double error;  ///< how far, root mean square, the vertices it was learnt from are from their images
};

/// Where the surroundings of a point of the source come to lie, as far as the matched faces nearest to it tell: a posed
/// model lies nowhere as a whole, but its parts stay where they are beside each other.
/// @return    nothing where too little is matched.
/// @pre       both meshes have positions.
/// @par Cost  O(#matched faces).
[[nodiscard]] std::optional<LocalPlacement> local_placement(const Workbench& bench, const Point& point);

/// Is one mesh the other, moved as a whole, as far as a sample of the matched faces tells? A tube turned by one step is
/// equal as connectivity goes.
[[nodiscard]] bool lies_well(const Workbench& bench);

}  // namespace quadmatch::regions
