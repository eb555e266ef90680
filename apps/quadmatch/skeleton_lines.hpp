#pragma once
/// The arcs of a skeleton graph as lines that any modelling program shows.

#include <string>

#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::cli {

/// OBJ text with one `l` record for each arc, through all its vertices, and a `v` record for each vertex on an arc.
/// @pre the mesh has positions.
[[nodiscard]] std::string lines_of(const Mesh& mesh, const ArcGraph& graph);

}  // namespace quadmatch::cli
