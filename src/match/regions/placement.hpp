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

/// Is one mesh the other, moved as a whole, as far as a sample of the matched faces tells? A tube turned by one step is
/// equal as connectivity goes.
[[nodiscard]] bool lies_well(const Workbench& bench);

}  // namespace quadmatch::regions
