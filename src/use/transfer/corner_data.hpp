#pragma once
/// Data of corners: they follow the rotation and the orientation of their faces.

#include <vector>

#include <quadmatch/io/mesh_file.hpp>

#include "correspondence.hpp"

namespace quadmatch::use {

struct CarriedCorners {
  IndexedAttribute attribute;
  /// Where each entry of the target's own pool is now, or kNoIndex.
  std::vector<std::uint32_t> own_entries;
};

/// The source's attribute on the corners of the target. The pool holds what is used of the source's, in its order, then
/// what is new, then what is used of the target's own.
/// @param own  the target's attribute of that name, or null.
[[nodiscard]] CarriedCorners carry_corners(const Mesh& target, const IndexedAttribute& source,
                                           const IndexedAttribute* own, const Correspondence& from, Fill fill,
                                           TransferredAttribute& report);

}  // namespace quadmatch::use
