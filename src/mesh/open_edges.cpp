#include "open_edges.hpp"

#include <algorithm>
#include <tuple>

namespace quadmatch {

OpenEdges::OpenEdges(const Mesh& mesh) {
  for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
    const HalfedgeId h(number);
    if (mesh.twin(h).valid()) continue;
    const VertexId from = mesh.origin(h);
    const VertexId to = mesh.tip(h);
    if (from != to) uses_.push_back({std::min(from, to), std::max(from, to), h});
  }
  std::sort(uses_.begin(), uses_.end(), [](const OpenUse& a, const OpenUse& b) {
    return std::tie(a.low, a.high, a.halfedge) < std::tie(b.low, b.high, b.halfedge);
  });
}

}  // namespace quadmatch
