#pragma once
/// The largest region of two tiny meshes, by trying every connected set of source faces in every placement. Plain sets
/// and maps; knows the definition and nothing of the search.

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::test {

class ExactOracle {
 public:
  /// @pre source has at most 20 faces. @param target as it is laid: in the mirror for reversing.
  ExactOracle(const Mesh& source, const Mesh& target) : source_(source), target_(target) {
    for (std::uint32_t f = 0; f < source.face_count(); ++f) {
      std::uint32_t beside = 0;
      for (const HalfedgeId h : source.halfedges(FaceId(f))) {
        if (source.twin(h).valid()) beside |= 1U << source.face(source.twin(h)).value;
      }
      beside_.push_back(beside);
    }
  }

  [[nodiscard]] std::uint32_t largest() const {
    std::uint32_t best = 0;
    for (std::uint32_t set = 1; set < (1U << source_.face_count()); ++set) {
      const auto size = static_cast<std::uint32_t>(std::popcount(set));
      if (size > best && size <= target_.face_count() && is_connected(set) && has_placement(set)) best = size;
    }
    return best;
  }

 private:
  /// Half-edge of the source onto half-edge of the target.
  using Images = std::map<HalfedgeId, HalfedgeId>;

  [[nodiscard]] bool is_connected(std::uint32_t set) const {
    std::uint32_t reached = set & (~set + 1);
    while (true) {
      std::uint32_t more = reached;
      for (std::uint32_t f = 0; f < beside_.size(); ++f) {
        if ((reached >> f & 1U) != 0) more |= beside_[f] & set;
      }
      if (more == reached) return reached == set;
      reached = more;
    }
  }

  [[nodiscard]] bool has_placement(std::uint32_t set) const {
    const FaceId seed(static_cast<std::uint32_t>(std::countr_zero(set)));
    for (std::uint32_t t = 0; t < target_.halfedge_count(); ++t) {
      Images images;
      std::vector<FaceId> faces;
      if (lay(seed, source_.first(seed), HalfedgeId(t), set, images, faces) && is_region(images, faces, set)) {
        return true;
      }
    }
    return false;
  }

  /// Lay a face and all of the set that can be reached from it.
  bool lay(FaceId face, HalfedgeId s, HalfedgeId t, std::uint32_t set, Images& images,
           std::vector<FaceId>& faces) const {
    if (source_.size(face) != target_.size(target_.face(t))) return false;
    faces.push_back(face);
    for (std::uint32_t corner = 0; corner < source_.size(face); ++corner) {
      images[s] = t;
      s = source_.next(s);
      t = target_.next(t);
    }
    for (const HalfedgeId h : source_.halfedges(face)) {
      const HalfedgeId across = source_.twin(h);
      if (!across.valid() || (set >> source_.face(across).value & 1U) == 0 || images.count(across) != 0) continue;
      const HalfedgeId across_target = target_.twin(images[h]);
      if (!across_target.valid()) return false;
      if (!lay(source_.face(across), across, across_target, set, images, faces)) return false;
    }
    return true;
  }

  /// Sentences 2, 3 and 5 of the definition.
  [[nodiscard]] bool is_region(const Images& images, const std::vector<FaceId>& faces, std::uint32_t set) const {
    std::map<VertexId, VertexId> image, origin;
    std::map<FaceId, FaceId> face_of_target;
    for (const FaceId face : faces) {
      const FaceId there = target_.face(images.at(source_.first(face)));
      if (!face_of_target.emplace(there, face).second) return false;
    }
    for (const auto& [s, t] : images) {
      const VertexId v = source_.origin(s), w = target_.origin(t);
      if (image.emplace(v, w).first->second != w || origin.emplace(w, v).first->second != v) return false;
      const HalfedgeId b = source_.twin(s), c = target_.twin(t);
      const bool matched = b.valid() && (set >> source_.face(b).value & 1U) != 0;
      const bool matched_there = c.valid() && face_of_target.count(target_.face(c)) != 0;
      if (matched != matched_there || (matched && images.at(b) != c)) return false;
    }
    return true;
  }

  const Mesh& source_;
  const Mesh& target_;
  std::vector<std::uint32_t> beside_;
};

}  // namespace quadmatch::test
