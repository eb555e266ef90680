#pragma once
/// The order of the result, and bringing a file into it.

#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>

#include "../transfer/correspondence.hpp"

namespace quadmatch::use {

/// The elements of the target in the order of the result.
struct Numbering {
  std::vector<VertexId> vertices;
  std::vector<FaceId> faces;
  /// Of each of these faces the corner at which it begins.
  std::vector<HalfedgeId> first_corners;
};

/// As the target has them.
[[nodiscard]] Numbering as_it_is(const Mesh& target);

/// Matched elements in the source's order, then the others in the target's. Vertices that no face uses take the places
/// of the source's where both have equally many of them.
[[nodiscard]] Numbering like_source(const Mesh& source, const Mesh& target, const Correspondence& from);

/// The file with its vertices, faces and corners renumbered, and all that belongs to them with them: properties, corner
/// data, carried lines, the vertices that further elements of PLY name. Face records are left to the caller.
/// @par Errors  as of Mesh::build.
[[nodiscard]] Expected<MeshFile> renumbered(MeshFile file, const Numbering& numbering);

/// The vertices that a PLY file's edges and the like name, by their new numbers. Where it names none by a usual name, a
/// note says so.
void renumber_further(FurtherElement& element, const std::vector<std::uint32_t>& new_vertex,
                      std::vector<std::string>& notes);

}  // namespace quadmatch::use
