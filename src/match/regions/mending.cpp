#include "mending.hpp"

#include <algorithm>
#include <set>

namespace quadmatch::regions {

std::vector<std::vector<HalfedgeId>> faces_by_region(const Workbench& bench, const std::vector<SizedRegion>& regions) {
  const Mesh& source = bench.sides.source.mesh;
  std::vector<std::vector<HalfedgeId>> faces(bench.patchwork.region_count());
  if (regions.empty()) return faces;
  for (const SizedRegion& region : regions) faces[region.number].reserve(region.faces);
  PerFace<char> listed(source.face_count(), false);
  for (const HalfedgeId entry : bench.patchwork.history()) {
    const FaceId face = source.face(entry);
    if (!bench.patchwork.is_matched(face) || listed[face]) continue;
    listed[face] = true;
    std::vector<HalfedgeId>& entries = faces[bench.patchwork.region(face)];
    if (entries.capacity() > 0) entries.push_back(entry);
  }
  return faces;
}

std::vector<SizedRegion> largest_first(const Patchwork& patchwork) {
  std::vector<SizedRegion> regions;
  for (std::uint32_t region = 0; region < patchwork.region_count(); ++region) {
    if (const std::uint32_t faces = patchwork.faces_of_region(region); faces > 0) regions.push_back({region, faces});
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [](const SizedRegion& a, const SizedRegion& b) { return a.faces > b.faces; });
  return regions;
}

namespace {

/// How many faces beside a matched one lie beside its image?
int neighbours_in_place(const Workbench& bench, FaceId face) {
  int count = 0;
  for (const HalfedgeId h : bench.sides.source.mesh.halfedges(face)) {
    count += bench.patchwork.beyond(h, bench.patchwork.image(h)) == Beyond::InPlace;
  }
  return count;
}

}  // namespace

std::size_t drop_misfits(Workbench& bench) {
  constexpr int kEnough = 2;  // neighbours that hold a face, however badly it fits: all of those within a region
  const Mesh& source = bench.sides.source.mesh;
  std::set<FaceId> doubtful;
  for (const HalfedgeId entry : bench.rim.entries()) doubtful.insert(source.face(entry));
  std::size_t dropped = 0;
  for (const FaceId face : doubtful) {
    if (!bench.patchwork.is_matched(face) || neighbours_in_place(bench, face) >= kEnough) continue;
    if (bench.misfit.present_cost(bench.patchwork, face) <= Misfit::kUnmatched) continue;
    bench.patchwork.lift(face);
    ++dropped;
    for (const HalfedgeId h : source.halfedges(face)) {
      // One that has passed already was held by this one; the next round will see it.
      if (const HalfedgeId beside = source.twin(h); beside.valid()) doubtful.insert(source.face(beside));
    }
  }
  return dropped;
}

}  // namespace quadmatch::regions
