#pragma once
/// Data of vertices, faces and corners that have a name, and positions.

#include <vector>

#include <quadmatch/io/mesh_file.hpp>

#include "correspondence.hpp"

namespace quadmatch::use {

/// Where elements of one domain take their data from, and how they lie side by side.
struct ElementMap {
  /// The element of the source for each of the target, or kNone.
  std::vector<std::uint32_t> from;
  /// The same, and for elements that are not matched that of the nearest one that is; empty unless data are filled.
  std::vector<std::uint32_t> nearest;

  static constexpr std::uint32_t kNone = 0xffffffffU;
};

[[nodiscard]] ElementMap vertex_map(const Mesh& target, const Correspondence& from, Fill fill);
[[nodiscard]] ElementMap face_map(const Mesh& target, const Correspondence& from, Fill fill);
[[nodiscard]] ElementMap corner_map(const Mesh& target, const Correspondence& from, Fill fill);

/// Is it a colour, in one of the ways in which files write colours? Numbers in bytes run to 255, others to 1.
[[nodiscard]] bool is_colour(const Property& property);

/// The source's property on the elements of the target.
/// @param own  the target's of that name and domain, or null. A list and a single number have nothing in common: then
///             the target's own is given up, with a remark.
[[nodiscard]] Property carry_property(const Mesh& target, const Property& source, const Property* own,
                                      const ElementMap& map, Fill fill, TransferredAttribute& report);

/// The source's positions on the matched vertices. With Fill::Smooth the others move along: the displacement is
/// interpolated. Else they stay, since a vertex must be somewhere.
[[nodiscard]] std::vector<Point> carry_positions(const Mesh& source, const Mesh& target, const ElementMap& map,
                                                 Fill fill, TransferredAttribute& report);

}  // namespace quadmatch::use
