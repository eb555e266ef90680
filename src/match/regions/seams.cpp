#include <cstdint>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

constexpr int kPasses = 2;

/// Has a face of a region, or one beside it, changed since?
bool has_changed(const Workbench& bench, const std::vector<HalfedgeId>& faces, std::uint32_t since) {
  const Mesh& source = bench.sides.source.mesh;
  for (const HalfedgeId entry : faces) {
    if (bench.patchwork.changed_at(source.face(entry)) > since) return true;
    for (const HalfedgeId h : source.halfedges(source.face(entry))) {
      const HalfedgeId beside = source.twin(h);
      if (beside.valid() && bench.patchwork.changed_at(source.face(beside)) > since) return true;
    }
  }
  return false;
}

}  // namespace

std::size_t move_seams(Workbench& bench, SeamsAtRest& rest) {
  std::size_t changed = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench);
    std::size_t changed_now = 0;
    rest.resize(faces.size(), 0);
    for (const std::uint32_t region : largest_first(faces)) {
      if (!has_changed(bench, faces[region], rest[region])) continue;
      extend_region(bench, faces[region], region);
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
