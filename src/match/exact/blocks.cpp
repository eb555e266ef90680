#include "blocks.hpp"

#include <algorithm>
#include <queue>
#include <tuple>

namespace quadmatch::exact {
namespace {

constexpr std::uint32_t kFar = 0xffffffff;
constexpr int kRecentrings = 5;

class Parting {
 public:
  Parting(const Mesh& mesh, const std::vector<FaceId>& faces, const PerFace<std::uint8_t>& free)
      : mesh_(mesh), free_(free), distance_(mesh.face_count(), kFar), block_of_(mesh.face_count(), kFar) {
    for (const FaceId face : faces) {
      if (free[face] != 0) faces_.push_back(face);
    }
  }

  [[nodiscard]] std::uint32_t face_count() const { return static_cast<std::uint32_t>(faces_.size()); }

  /// Centres, each as far as can be from those before it.
  std::vector<FaceId> spread(std::uint32_t count, FaceId first) {
    std::vector<FaceId> centres{first};
    for (const FaceId face : faces_) distance_[face] = kFar;
    relax(first, 0);
    while (centres.size() < count) {
      const auto nearer = [&](FaceId a, FaceId b) { return distance_[a] < distance_[b]; };
      centres.push_back(*std::max_element(faces_.begin(), faces_.end(), nearer));
      relax(centres.back(), 0);
    }
    return centres;
  }

  /// Blocks that grow around their centres face by face, always the smallest.
  std::vector<Block> grow(const std::vector<FaceId>& centres) {
    for (const FaceId face : faces_) block_of_[face] = kFar;
    std::vector<Block> blocks;
    std::vector<std::size_t> next_face(centres.size(), 0);  // its neighbours are being taken
    std::priority_queue<std::tuple<std::size_t, std::uint32_t>, std::vector<std::tuple<std::size_t, std::uint32_t>>,
                        std::greater<>>
        smallest;
    for (std::uint32_t b = 0; b < centres.size(); ++b) {
      blocks.push_back({centres[b]});
      block_of_[centres[b]] = b;
      smallest.emplace(1, b);
    }
    while (!smallest.empty()) {
      const std::uint32_t b = std::get<1>(smallest.top());
      smallest.pop();
      if (take_next(blocks[b], b, next_face[b])) smallest.emplace(blocks[b].size(), b);
    }
    return blocks;
  }

  /// The face of a block that is farthest from all others.
  FaceId middle(const Block& block, std::uint32_t number) {
    std::vector<FaceId> queue;
    for (const FaceId face : block) distance_[face] = kFar;
    for (const FaceId face : block) {
      for (const HalfedgeId h : mesh_.halfedges(face)) {
        const HalfedgeId across = mesh_.twin(h);
        if (!across.valid() || block_of_[mesh_.face(across)] == number) continue;
        distance_[face] = 0;
        queue.push_back(face);
        break;
      }
    }
    if (queue.empty()) return block.front();
    for (std::size_t next = 0; next < queue.size(); ++next) {
      for_neighbours(queue[next], [&](FaceId beside) {
        if (block_of_[beside] != number || distance_[beside] != kFar) return;
        distance_[beside] = distance_[queue[next]] + 1;
        queue.push_back(beside);
      });
    }
    return queue.back();
  }

 private:
  template <class Do>
  void for_neighbours(FaceId face, Do&& act) const {
    for (const HalfedgeId h : mesh_.halfedges(face)) {
      const HalfedgeId across = mesh_.twin(h);
      if (across.valid() && free_[mesh_.face(across)] != 0) act(mesh_.face(across));
    }
  }

  void relax(FaceId from, std::uint32_t distance) {
    std::vector<FaceId> queue{from};
    distance_[from] = distance;
    for (std::size_t next = 0; next < queue.size(); ++next) {
      const FaceId here = queue[next];
      for_neighbours(here, [&](FaceId beside) {
        if (distance_[beside] <= distance_[here] + 1) return;
        distance_[beside] = distance_[here] + 1;
        queue.push_back(beside);
      });
    }
  }

  bool take_next(Block& block, std::uint32_t number, std::size_t& next_face) {
    for (; next_face < block.size(); ++next_face) {
      for (const HalfedgeId h : mesh_.halfedges(block[next_face])) {
        const HalfedgeId across = mesh_.twin(h);
        if (!across.valid()) continue;
        const FaceId beside = mesh_.face(across);
        if (free_[beside] == 0 || block_of_[beside] != kFar) continue;
        block_of_[beside] = number;
        block.push_back(beside);
        return true;
      }
    }
    return false;
  }

  const Mesh& mesh_;
  const PerFace<std::uint8_t>& free_;
  std::vector<FaceId> faces_;
  PerFace<std::uint32_t> distance_;
  PerFace<std::uint32_t> block_of_;
};

}  // namespace

std::vector<Block> part_into_blocks(const Mesh& mesh, const std::vector<FaceId>& faces,
                                    const PerFace<std::uint8_t>& free, std::uint32_t count, std::mt19937& random) {
  Parting parting(mesh, faces, free);
  count = std::min(count, parting.face_count());
  if (count == 0) return {};
  std::vector<FaceId> free_faces;
  for (const FaceId face : faces) {
    if (free[face] != 0) free_faces.push_back(face);
  }
  const auto start = static_cast<std::size_t>(random() % free_faces.size());
  std::vector<FaceId> centres = parting.spread(count, free_faces[start]);
  std::vector<Block> blocks = parting.grow(centres);
  for (int again = 0; again < kRecentrings; ++again) {
    for (std::uint32_t b = 0; b < blocks.size(); ++b) centres[b] = parting.middle(blocks[b], b);
    blocks = parting.grow(centres);
  }
  return blocks;
}

}  // namespace quadmatch::exact
