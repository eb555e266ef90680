#pragma once
/// PLY's texture coordinates, a list of two numbers for each corner of a face, as data of corners and back.

#include <optional>

#include <quadmatch/io/mesh_file.hpp>

namespace quadmatch::use {

/// The list `texcoord` of a file's faces, if each has none or two numbers for each corner.
[[nodiscard]] const Property* find_texture_list(const MeshFile& file);

/// Texture coordinates of a file, from its pool or else from its list; corners at a vertex that have the same share
/// one.
[[nodiscard]] std::optional<IndexedAttribute> texture_coordinates_of(const MeshFile& file);

/// The list again, of the types of `like`.
[[nodiscard]] Property texture_list_of(const Mesh& mesh, const IndexedAttribute& pool, const Property& like);

}  // namespace quadmatch::use
