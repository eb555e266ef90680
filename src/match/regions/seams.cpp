#include <cstdint>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

constexpr int kPasses = 2;

/// The faces of a region that have changed since, or that lie beside one that has: where else its map could be carried
/// on was tried then.
std::vector<HalfedgeId> changed_faces(const Workbench& bench, const std::vector<HalfedgeId>& faces,
                                      std::uint32_t since) {
  const Mesh& source = bench.sides.source.mesh;
  const auto has_changed = [&](FaceId face) { return bench.patchwork.changed_at(face) > since; };
  const auto is_near = [&](FaceId face) {
    for (const HalfedgeId h : source.halfedges(face)) {
      if (const HalfedgeId beside = source.twin(h); beside.valid() && has_changed(source.face(beside))) return true;
    }
    return false;
  };
  if (since == 0) return faces;
  std::vector<HalfedgeId> changed;
  for (const HalfedgeId entry : faces) {
    if (const FaceId face = source.face(entry); has_changed(face) || is_near(face)) changed.push_back(entry);
  }
  return changed;
}

}  // namespace

std::size_t move_seams(Workbench& bench, SeamsAtRest& rest) {
  std::size_t changed = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench);
    std::size_t changed_now = 0;
    rest.resize(faces.size(), 0);
    for (const std::uint32_t region : largest_first(faces)) {
      const std::vector<HalfedgeId> from = changed_faces(bench, faces[region], rest[region]);
      if (from.empty()) continue;
      extend_region(bench, from, region, most_faces_beyond(faces[region].size()));
      const std::size_t changed_here = expand(bench, region);
      if (changed_here == 0) rest[region] = bench.patchwork.changes();
      changed_now += changed_here;
    }
    changed += changed_now;
    if (changed_now == 0) break;
  }
  bench.ghost.restart();
  return changed;
}

}  // namespace quadmatch::regions
