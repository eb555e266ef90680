#pragma once
/// Objects, groups, materials and smoothing groups: records of OBJ that hold from a face on, as states of faces.

#include <vector>

#include <quadmatch/io/mesh_file.hpp>

#include "element_data.hpp"

namespace quadmatch::use {

/// The result's records. Each face has the state it takes from the source or keeps; a record is written where the
/// record behind the state changes, in the order of the result. A face without a value after one with a value is
/// preceded by `g default`, `s off`, or `o` or `usemtl` without a name. With Fill::Keep, faces that are not matched are
/// in the object in which most of those are that shared one with them.
///
/// @param faces  the faces of the target in the order of the result.
[[nodiscard]] std::vector<FaceRecord> carry_face_records(const MeshFile& source, const MeshFile& target,
                                                         const ElementMap& map, const std::vector<FaceId>& faces,
                                                         const TransferOptions& options,
                                                         std::vector<TransferredAttribute>& report);

}  // namespace quadmatch::use
