#include "images.hpp"

#include <algorithm>

namespace quadmatch::canonical {

template <class IdType, class Element>
void Images::join_elements(std::span<const HalfedgeId> faces, std::span<const HalfedgeId> images,
                           std::span<const IdType> members, DisjointSets& joined, Element element) {
  constexpr std::uint32_t kNone = IdType::kNone;
  if (member_.empty()) member_.assign(std::max(mesh_.halfedge_count(), mesh_.vertex_count()), kNone);
  for (std::uint32_t k = 0; k < members.size(); ++k) member_[members[k].value] = k;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    HalfedgeId here = faces[i], there = images[i];
    do {
      const std::uint32_t one = member_[element(here).value], other = member_[element(there).value];
      if (one != kNone && other != kNone) joined.join(one, other);
      here = mesh_.next(here);
      there = mesh_.next(there);
    } while (here != faces[i]);
  }
  for (const IdType member : members) member_[member.value] = kNone;
}

void Images::join(std::span<const HalfedgeId> faces, std::span<const HalfedgeId> images,
                  std::span<const HalfedgeId> members, DisjointSets& joined) {
  join_elements(faces, images, members, joined, [](HalfedgeId h) { return h; });
}

void Images::join(std::span<const HalfedgeId> faces, std::span<const HalfedgeId> images,
                  std::span<const VertexId> members, DisjointSets& joined) {
  join_elements(faces, images, members, joined, [this](HalfedgeId h) { return mesh_.origin(h); });
}

}  // namespace quadmatch::canonical
