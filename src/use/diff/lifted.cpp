#include "lifted.hpp"

#include <map>
#include <set>
#include <vector>

namespace quadmatch::use {
namespace {

/// The last side that is reached by going straight on from a side of a matched face through unmatched quads; not valid
/// where a boundary, another polygon or no end comes first.
HalfedgeId through_new_quads(const Side& side, HalfedgeId from) {
  const Mesh& mesh = *side.mesh;
  HalfedgeId here = from;
  for (std::uint32_t steps = 0; steps <= mesh.face_count(); ++steps) {
    const HalfedgeId entry = mesh.twin(here);
    if (!entry.valid()) return {};
    if (side.image[entry].valid()) return entry;
    if (mesh.size(mesh.face(entry)) != 4) return {};
    here = mesh.next(mesh.next(entry));
  }
  return {};
}

/// The side that is reached by going straight on from a side through so many quads; not valid where there are fewer.
HalfedgeId behind_quads(const Mesh& mesh, HalfedgeId from, std::size_t count) {
  for (std::size_t k = 0; k < count && from.valid(); ++k) {
    const HalfedgeId entry = mesh.twin(from);
    from = entry.valid() && mesh.size(mesh.face(entry)) == 4 ? mesh.next(mesh.next(entry)) : HalfedgeId();
  }
  return from.valid() ? mesh.twin(from) : from;
}

/// Lays the faces before on the faces after, from some rings inside the rim on.
class Inset {
 public:
  explicit Inset(const Scene& scene)
      : before_(*scene.before->mesh),
        after_(*scene.after->mesh),
        free_before_(scene.faces_before.begin(), scene.faces_before.end()),
        free_after_(scene.faces_after.begin(), scene.faces_after.end()) {}

  /// A face before, entered by one half-edge, on a face after, entered by another.
  bool lay(HalfedgeId there, HalfedgeId here) {
    std::vector<std::pair<HalfedgeId, HalfedgeId>> to_lay{{there, here}};
    while (!to_lay.empty()) {
      const auto [h, image] = to_lay.back();
      to_lay.pop_back();
      const auto [place, is_new] = image_.try_emplace(h, image);
      if (!is_new) {
        if (place->second != image) return false;
        continue;
      }
      const FaceId f = before_.face(h), g = after_.face(image);
      if (before_.size(f) != after_.size(g) || !free_after_.contains(g)) return false;
      lay_corners(h, image, to_lay);
      used_.insert(g);
    }
    return true;
  }

  [[nodiscard]] bool covers_all() const {
    return used_.size() == free_before_.size() && used_.size() <= free_after_.size();
  }

 private:
  void lay_corners(HalfedgeId h, HalfedgeId image, std::vector<std::pair<HalfedgeId, HalfedgeId>>& to_lay) {
    const HalfedgeId first = h;
    do {
      image_[h] = image;
      const HalfedgeId beyond = before_.twin(h), image_beyond = after_.twin(image);
      if (beyond.valid() && free_before_.contains(before_.face(beyond)) && image_beyond.valid()) {
        to_lay.emplace_back(beyond, image_beyond);
      }
      h = before_.next(h);
      image = after_.next(image);
    } while (h != first);
  }

  const Mesh &before_, &after_;
  std::set<FaceId> free_before_, free_after_, used_;
  std::map<HalfedgeId, HalfedgeId> image_;
};

}  // namespace

std::size_t count_walled(const Scene& scene) {
  std::size_t walled = 0;
  for (const RimSide& side : scene.rim) {
    if (side.in_before != Beyond::Matched || side.in_after != Beyond::Unmatched) continue;
    const HalfedgeId met = through_new_quads(*scene.after, side.after);
    if (met.valid() && scene.after->image[met] == scene.before->mesh->twin(side.before)) ++walled;
  }
  return walled;
}

bool is_lifted_patch(const Scene& scene) {
  if (scene.faces_before.empty() || scene.rim.empty() || scene.faces_after.size() <= scene.faces_before.size())
    return false;
  const Mesh &before = *scene.before->mesh, &after = *scene.after->mesh;
  const std::size_t depth = (scene.faces_after.size() - scene.faces_before.size()) / scene.rim.size();
  if (depth == 0) return false;
  Inset inset(scene);
  for (const RimSide& side : scene.rim) {
    if (side.in_before != Beyond::Unmatched || side.in_after != Beyond::Unmatched) continue;
    const HalfedgeId behind = behind_quads(after, side.after, depth);
    if (!behind.valid() || !inset.lay(before.twin(side.before), behind)) return false;
  }
  return inset.covers_all();
}

}  // namespace quadmatch::use
