#include "one_sided.hpp"

#include <cstdint>
#include <utility>

#include "mirror_regions.hpp"

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Gives a side to every face of components whose largest region has two.
class Sides {
 public:
  Sides(const Mesh& mesh, const Components& components, const std::vector<Region>& regions)
      : mesh_(mesh),
        images_(images_of(mesh, mesh, regions)),
        region_(mesh.face_count(), kNone),
        side_(mesh.face_count(), 0) {
    for (std::uint32_t r = 0; r < regions.size(); ++r) {
      for (const FacePair& pair : regions[r].faces) region_[pair.source] = r;
    }
    std::vector<bool> seen(components.face_count.size(), false);
    for (std::uint32_t r = 0; r < regions.size(); ++r) {
      const std::uint32_t component = components.of_face[regions[r].faces.front().source];
      if (seen[component]) continue;
      seen[component] = true;
      if (2 * regions[r].faces.size() > components.face_count[component]) divide(r, regions[r]);
    }
    spread();
  }

  [[nodiscard]] PerFace<std::int8_t> take() && { return std::move(side_); }

 private:
  [[nodiscard]] FaceId partner_of(FaceId f) const { return mesh_.face(images_[mesh_.first(f)]); }

  /// One side is what can be reached without crossing the line. There are two, or none.
  void divide(std::uint32_t number, const Region& region) {
    FaceId seed;
    for (const FacePair& pair : region.faces) {
      if (pair.source != pair.target && region_[pair.target] == number) seed = pair.source;
    }
    if (!seed.valid()) return;
    std::vector<FaceId> reached{seed};
    side_[seed] = 1;
    std::size_t own = 0;
    for (std::size_t here = 0; here < reached.size(); ++here) {
      own += side_[partner_of(reached[here])] != 0;
      for (const HalfedgeId h : mesh_.halfedges(reached[here])) {
        const HalfedgeId beside = mesh_.twin(h);
        if (!beside.valid() || images_[h] == beside) continue;
        const FaceId next = mesh_.face(beside);
        if (region_[next] != number || side_[next] != 0 || partner_of(next) == next) continue;
        side_[next] = 1;
        reached.push_back(next);
      }
    }
    std::size_t off_line = 0;
    for (const FacePair& pair : region.faces) off_line += pair.source != pair.target;
    const bool two = own == 0 && 2 * reached.size() == off_line;
    for (const FaceId face : reached) {
      side_[face] = two ? 1 : 0;
      if (two) side_[partner_of(face)] = -1;
    }
    if (!two) return;
    for (const FacePair& pair : region.faces) {
      if (side_[pair.source] != 0) sources_.push_back(pair.source);
    }
  }

  /// Other faces are on the side from which they are reached first.
  void spread() {
    for (std::size_t here = 0; here < sources_.size(); ++here) {
      for (const HalfedgeId h : mesh_.halfedges(sources_[here])) {
        const HalfedgeId beside = mesh_.twin(h);
        if (!beside.valid()) continue;
        const FaceId next = mesh_.face(beside);
        if (side_[next] != 0 || region_[next] == region_[sources_.front()]) continue;
        side_[next] = side_[sources_[here]];
        sources_.push_back(next);
      }
    }
  }

  const Mesh& mesh_;
  const PerHalfedge<HalfedgeId> images_;
  PerFace<std::uint32_t> region_;
  PerFace<std::int8_t> side_;
  std::vector<FaceId> sources_;
};

}  // namespace

PerFace<std::int8_t> sides_of(const Mesh& mesh, const Components& components, const std::vector<Region>& regions) {
  return Sides(mesh, components, regions).take();
}

std::vector<bool> one_sided(const PerFace<std::int8_t>& sides, const std::vector<Region>& regions) {
  std::vector<bool> result;
  for (const Region& region : regions) {
    std::size_t same = 0, across = 0;
    for (const FacePair& pair : region.faces) {
      const std::int8_t here = sides[pair.source], there = sides[pair.target];
      same += here != 0 && here == there;
      across += here != 0 && here == -there;
    }
    result.push_back(same > across);
  }
  return result;
}

}  // namespace quadmatch::use
