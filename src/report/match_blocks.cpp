#include "match_blocks.hpp"

#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::report {
namespace {

constexpr std::uint32_t kNoRegion = 0xffffffff;

Packer pairs_of(const Match& match) {
  Packer packer;
  FacePair before{FaceId(0), FaceId(0)};
  for (const Region& region : match.regions) {
    for (const FacePair& pair : region.faces) {
      packer.add_step(before.source.value, pair.source.value);
      packer.add_step(before.target.value, pair.target.value);
      packer.add(pair.rotation);
      before = pair;
    }
  }
  return packer;
}

Packer waves_of(const Match& match) {
  Packer packer;
  for (const Region& region : match.regions) packer.add_list(region.waves);
  return packer;
}

/// A bit for each half-edge: does another region begin behind it? Both its half-edges have it.
Packer borders_of(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  PerFace<std::uint32_t> region_of(mesh.face_count(), kNoRegion);
  for (std::uint32_t r = 0; r < match.regions.size(); ++r) {
    for (const FacePair& pair : match.regions[r].faces) region_of[pair.*side] = r;
  }
  std::vector<bool> on_border(mesh.halfedge_count(), false);
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId other = mesh.twin(HalfedgeId(h));
    if (!other.valid()) continue;
    const std::uint32_t here = region_of[mesh.face(HalfedgeId(h))];
    const std::uint32_t there = region_of[mesh.face(other)];
    on_border[h] = here != there && here != kNoRegion && there != kNoRegion;
  }
  Packer packer;
  packer.add_bits(on_border);
  return packer;
}

std::vector<std::uint32_t> numbers_of(const std::vector<FaceId>& faces) {
  std::vector<std::uint32_t> numbers;
  numbers.reserve(faces.size());
  for (const FaceId face : faces) numbers.push_back(face.value);
  return numbers;
}

}  // namespace

void add_match(Blocks& blocks, const Mesh& source, const Mesh& target, const Match& match) {
  blocks.add("pairs", pairs_of(match));
  blocks.add("waves", waves_of(match));
  blocks.add("source.borders", borders_of(source, match, &FacePair::source));
  blocks.add("target.borders", borders_of(target, match, &FacePair::target));
}

void add_changes(Blocks& blocks, const std::vector<ReportChange>& changes) {
  Packer packer;
  for (const ReportChange& change : changes) {
    packer.add_list(numbers_of(change.source_faces));
    packer.add_list(numbers_of(change.target_faces));
  }
  blocks.add("changes", packer);
}

}  // namespace quadmatch::report
