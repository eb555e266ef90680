#include "left_over.hpp"

#include <algorithm>
#include <utility>

#include "mirror_plane.hpp"
#include "mirror_regions.hpp"
#include "one_sided.hpp"

namespace quadmatch::use {
namespace {

/// Rows of faces about what is left over that tell how it lies. With more, they count for more than it does.
constexpr int kRowsAround = 2;
/// Fewer faces that were cut off could lie anywhere.
constexpr std::size_t kLeastIsland = 4;

}  // namespace

LeftOver::LeftOver(const Mesh& mesh, const PerFan<VertexCode>& codes, const Components& components,
                   const std::vector<bool>& settled, ImageOptions options, MirrorMap& map)
    : mesh_(mesh), codes_(codes), components_(components), settled_(settled), options_(options), map_(map) {}

void LeftOver::lay() {
  const std::vector<FaceId> left = faces();
  if (left.empty() || 2 * left.size() > mesh_.face_count()) return;
  const MirrorPlane plane = fit_plane(mesh_, pairs_laid()).value_or(MirrorPlane());
  const PerFace<std::int8_t> sides =
      sides_of(mesh_, components_, regions_of(mesh_, codes_, map_, [](FaceId) { return true; }));
  std::vector<FaceId> in_front, behind;
  for (const FaceId face : with_rows_around(left)) {
    if (sides[face] != 0) (sides[face] > 0 ? in_front : behind).push_back(face);
  }
  lay_parts(PartMesh(mesh_, std::move(in_front)), PartMesh(mesh_, std::move(behind)), plane);
  const PartMesh part(mesh_, faces());
  lay_parts(part, part, plane);
}

std::vector<FaceId> LeftOver::faces() const {
  std::vector<FaceId> left;
  for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
    if (!map_.image(FaceId(f)).valid()) left.push_back(FaceId(f));
  }
  return left;
}

/// Faces and some rows around them, with what is laid opposite; ascending.
std::vector<FaceId> LeftOver::with_rows_around(const std::vector<FaceId>& faces) const {
  PerFace<std::uint8_t> seen(mesh_.face_count(), 0);
  std::vector<FaceId> reached;
  const auto reach = [&](FaceId face) {
    if (!face.valid() || seen[face] != 0) return;
    seen[face] = 1;
    reached.push_back(face);
  };
  for (const FaceId face : faces) reach(face);
  std::size_t here = 0;
  for (int row = 0; row < kRowsAround; ++row) {
    for (const std::size_t end = reached.size(); here < end; ++here) {
      for (const HalfedgeId h : mesh_.halfedges(reached[here])) {
        const HalfedgeId beside = mesh_.twin(h);
        if (!beside.valid()) continue;
        reach(mesh_.face(beside));
        reach(map_.image(mesh_.face(beside)));
      }
    }
  }
  std::sort(reached.begin(), reached.end());
  return reached;
}

/// Lay what matches with the mirror image of the other part, and the same back again.
void LeftOver::lay_parts(const PartMesh& front, const PartMesh& back, const MirrorPlane& plane) {
  if (front.mesh().face_count() == 0 || back.mesh().face_count() == 0) return;
  const bool is_same = &front == &back;
  const Match there = match_with_image(front.mesh(), back.mesh(), plane, options_);
  const PerHalfedge<HalfedgeId> images = images_of(front.mesh(), back.mesh(), there.regions);
  const PerHalfedge<HalfedgeId> returns =
      is_same
          ? images
          : images_of(back.mesh(), front.mesh(), match_with_image(back.mesh(), front.mesh(), plane, options_).regions);
  for (const Region& region : there.regions) {
    for (const FacePair& pair : region.faces) {
      const HalfedgeId first = front.mesh().first(pair.source);
      if (returns[images[first]] != first) continue;
      const Germ germ{front.to_whole(first), back.to_whole(images[first])};
      const bool is_doubtful = settled_[components_.of_face[mesh_.face(germ.from)]] && plane.error > kPlaneFits;
      const bool is_free = region.faces.size() >= kLeastIsland && (is_same || !is_doubtful);
      map_.lay(germ, is_free ? Fit::Free : Fit::Vertices);
    }
  }
}

std::vector<VertexPair> LeftOver::pairs_laid() const {
  std::vector<VertexPair> pairs;
  for (std::uint32_t v = 0; v < mesh_.vertex_count(); ++v) {
    if (map_.image(VertexId(v)).valid()) pairs.push_back({VertexId(v), map_.image(VertexId(v))});
  }
  return pairs;
}

}  // namespace quadmatch::use
