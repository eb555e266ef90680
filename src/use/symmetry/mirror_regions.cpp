#include "mirror_regions.hpp"

#include <algorithm>
#include <cstdint>

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// Grows one region after the other.
class Divider {
 public:
  Divider(const Mesh& mesh, const PerFan<VertexCode>& codes, const MirrorMap& map,
          const std::function<bool(FaceId)>& wanted)
      : mesh_(mesh),
        codes_(codes),
        map_(map),
        wanted_(wanted),
        region_(mesh.face_count(), kNone),
        image_(mesh.vertex_count()),
        origin_(mesh.vertex_count()) {}

  std::vector<Region> divide() {
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (is_free(FaceId(f))) grow(FaceId(f));
    }
    std::stable_sort(regions_.begin(), regions_.end(),
                     [](const Region& a, const Region& b) { return a.faces.size() > b.faces.size(); });
    return std::move(regions_);
  }

 private:
  /// The partner of a vertex in the region that asked last.
  struct Stamped {
    std::uint32_t region = kNone;
    VertexId vertex;
  };

  [[nodiscard]] bool is_free(FaceId f) const { return region_[f] == kNone && map_.image(f).valid() && wanted_(f); }

  void grow(FaceId seed) {
    number_ = static_cast<std::uint32_t>(regions_.size());
    regions_.push_back({.orientation = Orientation::Reversing});
    take(seed);
    for (std::size_t here = 0; here < regions_.back().faces.size(); ++here) {
      for (const HalfedgeId h : mesh_.halfedges(regions_.back().faces[here].source)) {
        const HalfedgeId beside = mesh_.twin(h);
        if (!beside.valid() || !is_free(mesh_.face(beside)) || map_.image(beside) != mesh_.twin(map_.image(h)))
          continue;
        if (fits(mesh_.face(beside))) take(mesh_.face(beside));
      }
    }
  }

  [[nodiscard]] bool is_in(FaceId f) const { return region_[f] == number_; }

  /// Would the region stay sound?
  [[nodiscard]] bool fits(FaceId f) const {
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      const HalfedgeId there = map_.image(h);
      const VertexId v = mesh_.origin(h), w = mesh_.tip(there);
      if (image_[v].region == number_ && image_[v].vertex != w) return false;
      if (origin_[w].region == number_ && origin_[w].vertex != v) return false;
      const HalfedgeId beside = mesh_.twin(h), opposite = mesh_.twin(there);
      const bool same = beside.valid() && opposite.valid() && map_.image(beside) == opposite;
      if (same) continue;
      if (beside.valid() && is_in(mesh_.face(beside))) return false;
      if (opposite.valid() && map_.image(opposite).valid() && is_in(mesh_.face(map_.image(opposite)))) return false;
    }
    return true;
  }

  void take(FaceId f) {
    region_[f] = number_;
    Region& region = regions_.back();
    const HalfedgeId there = map_.image(mesh_.first(f));
    region.faces.push_back({f, mesh_.face(there), mesh_.corner(mesh_.next(there))});
    for (const HalfedgeId h : mesh_.halfedges(f)) {
      const VertexId v = mesh_.origin(h), w = mesh_.tip(map_.image(h));
      const bool is_new = image_[v].region != number_;
      image_[v] = {number_, w};
      origin_[w] = {number_, v};
      if (!is_new) continue;
      const VertexCode left = codes_[mesh_.fan(h)], right = codes_[mesh_.fan(mesh_.next(map_.image(h)))];
      region.evidence.source_extraordinary += left.extraordinary();
      region.evidence.target_extraordinary += right.extraordinary();
      region.evidence.agreeing += left.extraordinary() && left == right;
    }
  }

  const Mesh& mesh_;
  const PerFan<VertexCode>& codes_;
  const MirrorMap& map_;
  const std::function<bool(FaceId)>& wanted_;
  PerFace<std::uint32_t> region_;
  PerVertex<Stamped> image_, origin_;
  std::vector<Region> regions_;
  std::uint32_t number_ = 0;
};

}  // namespace

PerHalfedge<HalfedgeId> images_of(const Mesh& mesh, const Mesh& other, const std::vector<Region>& regions) {
  PerHalfedge<HalfedgeId> images(mesh.halfedge_count());
  for (const Region& region : regions) {
    for (const FacePair& pair : region.faces) {
      const std::uint32_t size = mesh.size(pair.source);
      for (std::uint32_t corner = 0; corner < size; ++corner) {
        // From v to w, so from the image of w to that of v: the half-edge that leaves the image of the next corner.
        const std::uint32_t tip = image_corner(region.orientation, pair.rotation, (corner + 1) % size, size);
        images[HalfedgeId(mesh.first(pair.source).value + corner)] = HalfedgeId(other.first(pair.target).value + tip);
      }
    }
  }
  return images;
}

std::vector<Region> regions_of(const Mesh& mesh, const PerFan<VertexCode>& codes, const MirrorMap& map,
                               const std::function<bool(FaceId)>& wanted) {
  return Divider(mesh, codes, map, wanted).divide();
}

std::vector<VertexPair> vertices_of(const Mesh& mesh, const std::vector<Region>& regions, bool mutual) {
  PerVertex<VertexId> image(mesh.vertex_count()), origin(mesh.vertex_count());
  for (const Region& region : regions) {
    for (const FacePair& pair : region.faces) {
      const std::uint32_t size = mesh.size(pair.source);
      for (std::uint32_t corner = 0; corner < size; ++corner) {
        const std::uint32_t other = image_corner(region.orientation, pair.rotation, corner, size);
        const VertexId v = mesh.origin(HalfedgeId(mesh.first(pair.source).value + corner));
        const VertexId w = mesh.origin(HalfedgeId(mesh.first(pair.target).value + other));
        if (image[v].valid() || origin[w].valid()) continue;
        if (mutual && v != w && (image[w].valid() || origin[v].valid())) continue;
        image[v] = w;
        origin[w] = v;
        if (mutual) {
          image[w] = v;
          origin[v] = w;
        }
      }
    }
  }
  std::vector<VertexPair> pairs;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (image[VertexId(v)].valid()) pairs.push_back({VertexId(v), image[VertexId(v)]});
  }
  return pairs;
}

}  // namespace quadmatch::use
