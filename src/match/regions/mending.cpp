#include "mending.hpp"

#include <algorithm>

namespace quadmatch::regions {

std::vector<std::vector<HalfedgeId>> faces_by_region(const Workbench& bench) {
  const Mesh& source = bench.sides.source.mesh;
  std::vector<std::vector<HalfedgeId>> faces(bench.patchwork.region_count());
  PerFace<bool> listed(source.face_count(), false);
  for (const HalfedgeId entry : bench.patchwork.history()) {
    const FaceId face = source.face(entry);
    if (!bench.patchwork.is_matched(face) || listed[face]) continue;
    listed[face] = true;
    faces[bench.patchwork.region(face)].push_back(entry);
  }
  return faces;
}

std::vector<std::uint32_t> largest_first(const std::vector<std::vector<HalfedgeId>>& faces) {
  std::vector<std::uint32_t> regions;
  for (std::uint32_t region = 0; region < faces.size(); ++region) {
    if (!faces[region].empty()) regions.push_back(region);
  }
  std::stable_sort(regions.begin(), regions.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return faces[a].size() > faces[b].size(); });
  return regions;
}

namespace {

/// How many faces beside a matched one lie beside its image?
int neighbours_in_place(const Workbench& bench, FaceId face) {
  const Mesh& source = bench.sides.source.mesh;
  int count = 0;
  for (const HalfedgeId h : source.halfedges(face)) {
    const HalfedgeId beside = source.twin(h);
    count += beside.valid() && bench.patchwork.is_matched(source.face(beside)) &&
             bench.patchwork.image(beside) == bench.sides.target.mesh.twin(bench.patchwork.image(h));
  }
  return count;
}

}  // namespace

std::size_t drop_misfits(Workbench& bench) {
  constexpr int kEnough = 2;  // neighbours that hold a face, however badly it fits
  const Mesh& source = bench.sides.source.mesh;
  std::size_t dropped = 0;
  for (std::uint32_t f = 0; f < source.face_count(); ++f) {
    if (!bench.patchwork.is_matched(FaceId(f))) continue;
    if (bench.misfit.present_cost(bench.patchwork, FaceId(f)) <= Misfit::kUnmatched) continue;
    if (neighbours_in_place(bench, FaceId(f)) >= kEnough) continue;
    bench.patchwork.lift(FaceId(f));
    ++dropped;
  }
  return dropped;
}

}  // namespace quadmatch::regions
