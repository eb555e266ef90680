#pragma once
/// Where each element of the target takes its data from: a match, seen from the target, element by element.

#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>
#include <quadmatch/use/transfer.hpp>

namespace quadmatch::use {

/// By elements of the target; not valid where nothing is carried to.
struct Correspondence {
  PerFace<FaceId> faces;
  PerHalfedge<HalfedgeId> corners;
  /// Both copies of a vertex that was torn apart take their data from the one it was.
  PerVertex<VertexId> vertices;
  /// The same, one-to-one: what `match.vertices` says.
  PerVertex<VertexId> partners;
};

/// The regions of a sound match that are to be carried; the others are entered in the report, with the counts.
/// Where regions disagree at a vertex, `match.vertices` decides, and then the region that comes first.
[[nodiscard]] Correspondence correspond(const Mesh& source, const Mesh& target, const Match& match,
                                        const TransferOptions& options, TransferReport& report);

}  // namespace quadmatch::use
