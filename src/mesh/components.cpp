// Connected components of the dual graph (§2.1), by flooding from the lowest face not yet reached.

#include <quadmatch/mesh/components.hpp>

namespace quadmatch {

Components connected_components(const Mesh& mesh) {
  constexpr std::uint32_t kUnreached = FaceId::kNone;
  Components components{PerFace<std::uint32_t>(mesh.face_count(), kUnreached), {}};
  std::vector<FaceId> to_visit;
  for (std::uint32_t lowest = 0; lowest < mesh.face_count(); ++lowest) {
    if (components.of_face[FaceId(lowest)] != kUnreached) continue;
    const auto number = static_cast<std::uint32_t>(components.face_count.size());
    std::uint32_t faces = 0;
    to_visit.assign(1, FaceId(lowest));
    components.of_face[FaceId(lowest)] = number;
    while (!to_visit.empty()) {
      const FaceId face = to_visit.back();
      to_visit.pop_back();
      ++faces;
      for (const HalfedgeId h : mesh.halfedges(face)) {
        const HalfedgeId other = mesh.twin(h);
        if (!other.valid() || components.of_face[mesh.face(other)] != kUnreached) continue;
        components.of_face[mesh.face(other)] = number;
        to_visit.push_back(mesh.face(other));
      }
    }
    components.face_count.push_back(faces);
  }
  return components;
}

}  // namespace quadmatch
