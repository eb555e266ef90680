#pragma once
/// What edits share: building the mesh they look at, refusing, patches.

#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/shapes/edit.hpp>

namespace quadmatch::shapes {

[[nodiscard]] Unexpected<Error> does_not_fit(std::string message);

/// The mesh of a soup. @par Errors  as of Mesh::build; BadArgument where the element does not exist.
[[nodiscard]] Expected<Mesh> build_with_face(const PolygonSoup& soup, FaceId face);
[[nodiscard]] Expected<Mesh> build_with_halfedge(const PolygonSoup& soup, HalfedgeId halfedge);

/// The first `count` faces that a fire from `centre` reaches across edges, as flags.
[[nodiscard]] std::vector<bool> patch_around(const Mesh& mesh, FaceId centre, std::uint32_t count);

/// Is a corner's vertex inside the surface, and are its faces one fan?
[[nodiscard]] bool is_inside(const Mesh& mesh, HalfedgeId corner);

/// The edit, if it has a face and adds nothing to what `check` finds in the mesh before it.
[[nodiscard]] Expected<Edit> as_clean_as_before(const Mesh& before, Edit edit);

}  // namespace quadmatch::shapes
