// Connected components of the dual graph (§2.1), by flooding from the lowest face not yet reached.

#include <quadmatch/mesh/components.hpp>

#include <quadmatch/mesh/large_pages.hpp>

namespace quadmatch {

Components connected_components(const Mesh& mesh) {
  constexpr std::uint32_t kUnreached = FaceId::kNone;
  Components components{PerFace<std::uint32_t>(mesh.face_count(), kUnreached), {}};
  std::vector<FaceId> reached;
  reserve_on_large_pages(reached, mesh.face_count());
  for (std::uint32_t lowest = 0; lowest < mesh.face_count(); ++lowest) {
    if (components.of_face[FaceId(lowest)] != kUnreached) continue;
    const auto number = static_cast<std::uint32_t>(components.face_count.size());
    reached.assign(1, FaceId(lowest));
    components.of_face[FaceId(lowest)] = number;
    for (std::size_t here = 0; here < reached.size(); ++here) {
      for (const HalfedgeId h : mesh.halfedges(reached[here])) {
        const HalfedgeId other = mesh.twin(h);
        if (!other.valid() || components.of_face[mesh.face(other)] != kUnreached) continue;
        mesh.prefetch_twins(other);  // its turn comes a whole wave later
        components.of_face[mesh.face(other)] = number;
        reached.push_back(mesh.face(other));
      }
    }
    components.face_count.push_back(static_cast<std::uint32_t>(reached.size()));
  }
  return components;
}

}  // namespace quadmatch
