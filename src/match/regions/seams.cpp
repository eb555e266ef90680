#include <cstdint>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

constexpr int kPasses = 2;

/// The faces at a region's rim that have changed since, or that lie beside one that has: where else its map could be
/// carried on was tried then.
std::vector<HalfedgeId> changed_rim(Workbench& bench, std::uint32_t region, std::uint32_t since) {
  const Mesh& source = bench.sides.source.mesh;
  const auto has_changed = [&](FaceId face) { return bench.patchwork.changed_at(face) > since; };
  const auto is_near = [&](FaceId face) {
    for (const HalfedgeId h : source.halfedges(face)) {
      if (const HalfedgeId beside = source.twin(h); beside.valid() && has_changed(source.face(beside))) return true;
    }
    return false;
  };
  std::vector<HalfedgeId> rim = bench.rim.entries(region);
  if (since == 0) return rim;
  std::erase_if(rim,
                [&](HalfedgeId entry) { return !has_changed(source.face(entry)) && !is_near(source.face(entry)); });
  return rim;
}

}  // namespace

std::size_t move_seams(Workbench& bench, SeamsAtRest& rest) {
  std::size_t changed = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    std::size_t changed_now = 0;
    rest.resize(bench.patchwork.region_count(), 0);
    for (const auto& [region, faces] : largest_first(bench.patchwork)) {
      extend_region(bench, changed_rim(bench, region, rest[region]), region, most_faces_beyond(faces));
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
