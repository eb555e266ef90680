#include "clusters.hpp"

#include <quadmatch/mesh/disjoint_sets.hpp>

namespace quadmatch::canonical {

Clusters clusters_of(const Mesh& mesh) {
  Clusters clusters{connected_components(mesh), {}, {}, {}, {}};
  const auto count = static_cast<std::uint32_t>(clusters.components.face_count.size());
  DisjointSets tied(count);
  std::vector<bool> is_split_at(count, false);
  if (!mesh.split_vertices().empty()) {
    PerVertex<std::uint32_t> component_at(mesh.vertex_count(), VertexId::kNone);
    for (const VertexId v : mesh.split_vertices()) component_at[v] = count;  // none met yet
    for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
      const HalfedgeId h(number);
      std::uint32_t& met = component_at[mesh.origin(h)];
      if (met == VertexId::kNone) continue;
      const std::uint32_t component = clusters.components.of_face[mesh.face(h)];
      is_split_at[component] = true;
      if (met == count) met = component;
      tied.join(met, component);
    }
  }
  clusters.of_component.resize(count);
  for (std::uint32_t component = 0; component < count; ++component) {
    const std::uint32_t lowest = tied.find(component);
    if (lowest == component) {
      clusters.of_component[component] = clusters.size();
      clusters.first_face.emplace_back();
      clusters.is_single.push_back(true);
      clusters.is_clean.push_back(!is_split_at[component]);
    } else {
      clusters.is_single[clusters.of_component[lowest]] = false;
      clusters.of_component[component] = clusters.of_component[lowest];
    }
  }
  for (std::uint32_t f = mesh.face_count(); f-- > 0;) clusters.first_face[clusters.of_face(FaceId(f))] = FaceId(f);
  return clusters;
}

}  // namespace quadmatch::canonical
