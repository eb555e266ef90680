// The matches that `merge` goes by.

#include <algorithm>
#include <utility>

#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/mesh/components.hpp>
#include <quadmatch/mesh/per_element.hpp>
#include <quadmatch/use/merge.hpp>

namespace quadmatch {
namespace {

/// The same faces of the same vertices in the same order: then only data were changed, or nothing.
bool are_numbered_alike(const Mesh& base, const Mesh& side) {
  if (base.vertex_count() != side.vertex_count() || base.face_count() != side.face_count()) return false;
  for (std::uint32_t f = 0; f < base.face_count(); ++f) {
    if (base.size(FaceId(f)) != side.size(FaceId(f))) return false;
  }
  return std::equal(base.corners().begin(), base.corners().end(), side.corners().begin());
}

/// Every face on itself.
Match identity(const Mesh& mesh) {
  const Components components = connected_components(mesh);
  Match match;
  match.regions.resize(components.face_count.size());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    match.regions[components.of_face[FaceId(f)]].faces.push_back({FaceId(f), FaceId(f), 0});
  }
  std::stable_sort(match.regions.begin(), match.regions.end(),
                   [](const Region& a, const Region& b) { return a.faces.size() > b.faces.size(); });
  PerVertex<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const VertexId v : mesh.corners()) used[v] = 1;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (used[VertexId(v)] != 0) match.vertices.push_back({VertexId(v), VertexId(v)});
  }
  return match;
}

/// Does it lay all faces of both on each other, so that corners meet in one exactly where they meet in the other?
bool is_isomorphism(const Mesh& base, const Mesh& side, const Match& match) {
  if (match.matched_faces() != base.face_count() || base.face_count() != side.face_count()) return false;
  PerVertex<VertexId> image(base.vertex_count()), origin(side.vertex_count());
  for (const Region& region : match.regions) {
    if (region.orientation != Orientation::Preserving) return false;
    for (const FacePair& pair : region.faces) {
      const std::uint32_t size = base.size(pair.source);
      for (std::uint32_t i = 0; i < size; ++i) {
        const VertexId here = base.origin(HalfedgeId(base.first(pair.source).value + i));
        const VertexId there = side.origin(
            HalfedgeId(side.first(pair.target).value + image_corner(region.orientation, pair.rotation, i, size)));
        if (!image[here].valid()) image[here] = there;
        if (!origin[there].valid()) origin[there] = here;
        if (image[here] != there || origin[there] != here) return false;
      }
    }
  }
  return true;
}

}  // namespace

Match match_side(const Mesh& base, const Mesh& side, const MatchOptions& options) {
  if (are_numbered_alike(base, side)) return identity(base);
  MatchOptions preserving = options;
  preserving.algorithm = Algorithm::Regions;
  preserving.orientation = OrientationChoice::Preserving;
  Match found = match(base, side, preserving).match;
  if (base.face_count() != side.face_count() || base.vertex_count() != side.vertex_count()) return found;
  if (!found.complete || is_isomorphism(base, side, found)) return found;
  // The matcher goes by what looks alike nearby; where both are the same as wholes, that is certain.
  IsomorphismResult same = find_isomorphism(base, side, IsomorphismKind::Preserving);
  return same.isomorphism ? std::move(same.isomorphism->match) : found;
}

}  // namespace quadmatch
