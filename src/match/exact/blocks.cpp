#include "blocks.hpp"

#include <algorithm>

namespace quadmatch::exact {
namespace {

constexpr std::uint32_t kFar = 0xffffffff;
constexpr std::uint32_t kOutside = 0xffffffff, kNoBlock = 2;
constexpr int kRecentrings = 5;

class Parting {
 public:
  Parting(const Mesh& mesh, const std::vector<FaceId>& faces)
      : mesh_(mesh), faces_(faces), distance_(mesh.face_count(), kFar), block_of_(mesh.face_count(), kOutside) {
    for (const FaceId face : faces) block_of_[face] = kNoBlock;
  }

  /// A face as far as can be from another.
  FaceId farthest_from(FaceId face) {
    for (const FaceId each : faces_) distance_[each] = kFar;
    distance_[face] = 0;
    return spread({face}, [](FaceId) { return true; });
  }

  /// Blocks that grow around their centres face by face, always the smaller by its weight.
  std::array<Block, 2> grow(const std::array<FaceId, 2>& centres, const std::array<std::uint32_t, 2>& weights) {
    for (const FaceId face : faces_) block_of_[face] = kNoBlock;
    std::array<Block, 2> blocks;
    for (std::uint32_t b = 0; b < 2; ++b) {
      blocks[b].push_back(centres[b]);
      block_of_[centres[b]] = b;
    }
    std::array<std::size_t, 2> next_face{};  // whose neighbours are being taken
    std::array<bool, 2> growing{true, true};
    while (growing[0] || growing[1]) {
      const bool first_is_smaller = blocks[0].size() * weights[1] <= blocks[1].size() * weights[0];
      const std::uint32_t b = growing[0] && (first_is_smaller || !growing[1]) ? 0 : 1;
      growing[b] = take_next(blocks[b], b, next_face[b]);
    }
    return blocks;
  }

  /// The face of a block that is farthest from its rim.
  FaceId middle(const Block& block, std::uint32_t number) {
    std::vector<FaceId> rim;
    for (const FaceId face : block) {
      distance_[face] = kFar;
      const HalfedgeRange halfedges = mesh_.halfedges(face);
      const bool on_rim = std::any_of(halfedges.begin(), halfedges.end(), [&](HalfedgeId h) {
        return mesh_.twin(h).valid() && block_of_[mesh_.face(mesh_.twin(h))] != number;
      });
      if (on_rim) rim.push_back(face);
    }
    if (rim.empty()) return block.front();
    for (const FaceId face : rim) distance_[face] = 0;
    return spread(std::move(rim), [&](FaceId face) { return block_of_[face] == number; });
  }

 private:
  /// Breadth first from faces at distance 0; the last face reached.
  template <class Within>
  FaceId spread(std::vector<FaceId> queue, Within&& within) {
    for (std::size_t next = 0; next < queue.size(); ++next) {
      for (const HalfedgeId h : mesh_.halfedges(queue[next])) {
        if (!mesh_.twin(h).valid()) continue;
        const FaceId beside = mesh_.face(mesh_.twin(h));
        if (block_of_[beside] == kOutside || distance_[beside] != kFar || !within(beside)) continue;
        distance_[beside] = distance_[queue[next]] + 1;
        queue.push_back(beside);
      }
    }
    return queue.back();
  }

  bool take_next(Block& block, std::uint32_t number, std::size_t& next_face) {
    for (; next_face < block.size(); ++next_face) {
      for (const HalfedgeId h : mesh_.halfedges(block[next_face])) {
        if (!mesh_.twin(h).valid()) continue;
        const FaceId beside = mesh_.face(mesh_.twin(h));
        if (block_of_[beside] != kNoBlock) continue;
        block_of_[beside] = number;
        block.push_back(beside);
        return true;
      }
    }
    return false;
  }

  const Mesh& mesh_;
  const std::vector<FaceId>& faces_;
  PerFace<std::uint32_t> distance_;
  PerFace<std::uint32_t> block_of_;
};

}  // namespace

std::array<Block, 2> cut_in_two(const Mesh& mesh, const std::vector<FaceId>& faces,
                                std::array<std::uint32_t, 2> weights, std::mt19937& random) {
  Parting parting(mesh, faces);
  const FaceId somewhere = faces[random() % faces.size()];
  std::array<FaceId, 2> centres{parting.farthest_from(somewhere), {}};
  centres[1] = parting.farthest_from(centres[0]);
  std::array<Block, 2> blocks = parting.grow(centres, weights);
  for (int again = 0; again < kRecentrings; ++again) {
    for (std::uint32_t b = 0; b < 2; ++b) centres[b] = parting.middle(blocks[b], b);
    blocks = parting.grow(centres, weights);
  }
  return blocks;
}

}  // namespace quadmatch::exact
