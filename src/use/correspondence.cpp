#include "correspondence.hpp"

#include <optional>

namespace quadmatch::use {
namespace {

std::optional<LeftOutRegion::Reason> reason_to_leave_out(const Region& region, const TransferOptions& options) {
  if (region.ambiguous && !options.allow_ambiguous) return LeftOutRegion::Reason::Ambiguous;
  if (region.evidence.confidence() < options.least_confidence) return LeftOutRegion::Reason::LowConfidence;
  return std::nullopt;
}

/// The pairs of one region, which comes after others.
void lay(const Mesh& source, const Mesh& target, const Region& region, const PerVertex<VertexId>& image_of,
         Correspondence& from) {
  for (const FacePair& pair : region.faces) {
    from.faces[pair.target] = pair.source;
    const std::uint32_t size = source.size(pair.source);
    for (std::uint32_t i = 0; i < size; ++i) {
      const HalfedgeId there(source.first(pair.source).value + i);
      const HalfedgeId here(target.first(pair.target).value + image_corner(region.orientation, pair.rotation, i, size));
      from.corners[here] = there;
      const VertexId vertex = source.origin(there);
      const VertexId image = target.origin(here);
      if (image_of[vertex] == image) {
        from.vertices[image] = from.partners[image] = vertex;
      } else if (!from.vertices[image].valid()) {
        from.vertices[image] = vertex;
      }
    }
  }
}

void count(const Mesh& target, const Correspondence& from, TransferReport& report) {
  PerVertex<std::uint8_t> used(target.vertex_count(), 0);
  for (const VertexId v : target.corners()) used[v] = 1;
  report.faces = target.face_count();
  for (std::uint32_t v = 0; v < target.vertex_count(); ++v) {
    report.vertices += used[VertexId(v)];
    report.matched_vertices += from.vertices[VertexId(v)].valid() ? 1 : 0;
  }
  for (const FaceId f : from.faces) report.matched_faces += f.valid() ? 1 : 0;
}

}  // namespace

Correspondence correspond(const Mesh& source, const Mesh& target, const Match& match, const TransferOptions& options,
                          TransferReport& report) {
  Correspondence from{PerFace<FaceId>(target.face_count()), PerHalfedge<HalfedgeId>(target.halfedge_count()),
                      PerVertex<VertexId>(target.vertex_count()), PerVertex<VertexId>(target.vertex_count())};
  PerVertex<VertexId> image_of(source.vertex_count());
  for (const VertexPair& pair : match.vertices) image_of[pair.source] = pair.target;
  for (std::size_t r = 0; r < match.regions.size(); ++r) {
    const Region& region = match.regions[r];
    if (const auto reason = reason_to_leave_out(region, options)) {
      report.left_out.push_back({*reason, r, static_cast<std::uint32_t>(region.faces.size()),
                                 region.faces.front().source, region.faces.front().target, region.ways,
                                 region.evidence.confidence()});
      continue;
    }
    lay(source, target, region, image_of, from);
    report.reversing = report.reversing || region.orientation == Orientation::Reversing;
  }
  count(target, from, report);
  return from;
}

}  // namespace quadmatch::use
