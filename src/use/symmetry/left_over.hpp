#pragma once
/// What an edit cut off from a mirror, and what lies opposite.

#include <vector>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/components.hpp>
#include <quadmatch/mesh/mesh.hpp>

#include "image_match.hpp"
#include "mirror_map.hpp"
#include "part_mesh.hpp"

namespace quadmatch::use {

/// The faces that are left over are parts of their own: first on the other side, told by what lies around, then
/// anywhere.
class LeftOver {
 public:
  /// @param settled  components of which the mirror was chosen among several
  LeftOver(const Mesh& mesh, const PerFan<VertexCode>& codes, const Components& components,
           const std::vector<bool>& settled, ImageOptions options, MirrorMap& map);

  /// Lay what matches. Where more than half is left over, there is no mirror to complete.
  /// @par Cost  that of four matches of what is left, and O(#faces).
  void lay();

 private:
  [[nodiscard]] std::vector<FaceId> faces() const;
  [[nodiscard]] std::vector<FaceId> with_rows_around(const std::vector<FaceId>& faces) const;
  [[nodiscard]] std::vector<VertexPair> pairs_laid() const;
  void lay_parts(const PartMesh& front, const PartMesh& back, const MirrorPlane& plane);

  const Mesh& mesh_;
  const PerFan<VertexCode>& codes_;
  const Components& components_;
  const std::vector<bool>& settled_;
  const ImageOptions options_;
  MirrorMap& map_;
};

}  // namespace quadmatch::use
