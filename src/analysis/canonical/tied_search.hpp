#pragma once
/// The canonical order of components that share vertices, where a walk across edges sees only one of them.

#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/analysis/group_order.hpp>
#include <quadmatch/mesh/mesh.hpp>

#include "images.hpp"
#include "partition.hpp"
#include "tangle.hpp"
#include "writer.hpp"

namespace quadmatch::canonical {

/// A cluster's faces in canonical order, each by the half-edge it is read from, and how many symmetries there are.
struct TiedOrder {
  std::vector<HalfedgeId> faces;
  GroupOrder symmetries;
};

/// Finds it by refinement and trial, as graph canonisers do (McKay's nauty, Junttila and Kaski's bliss), on pieces
/// instead of vertices:
///
/// 1. Refine the partition of half-edges and vertices. Vertices in a cell of their own are as good as numbered; pieces
///    whose half-edges are, too, are written.
/// 2. The rest falls apart at numbered vertices. Parts do not see each other: each is ordered by itself, and equal ones
///    change places at will.
/// 3. A part of one piece is written from each half-edge of its rarest cell, and the least writing wins.
/// 4. In a part of several pieces single out each member of the smallest cell in turn, go on with 1, and take what
///    comes out least. Members that a symmetry found so far lays on one that was tried are passed over; to find it, the
///    first way down from each is compared with those from the others.
class TiedSearch {
 public:
  /// @param writer  of the same mesh.
  TiedSearch(const Mesh& mesh, Writer& writer);

  /// @param faces  of one cluster.
  /// @par Cost     O(n log^2 n) where refinement tells all apart or what it leaves is symmetric; exponential in the
  ///               worst case, since any graph can be built of pieces that touch in vertices.
  [[nodiscard]] TiedOrder order(std::span<const FaceId> faces);

 private:
  /// What comes out of a part. Two parts of tangles that were partitioned alike have the same key exactly if some map
  /// between them keeps cells and numbered vertices; their faces in order are such a map.
  struct Solution {
    std::vector<std::uint32_t> key;
    std::vector<HalfedgeId> faces;
    GroupOrder symmetries;
    bool is_canonical = true;  ///< false where the first way down was taken though there were others
  };
  enum class Depth { Full, FirstWayDown };

  [[nodiscard]] Solution settle(const Tangle& tangle, const Partition& partition, std::uint32_t next_number,
                                Depth depth);
  void write_settled(const Tangle& tangle, const Partition& partition, std::uint32_t next_number, Solution& solution);
  void append_parts(std::vector<Solution>& parts, Solution& solution);
  [[nodiscard]] Solution solve_part(const Tangle& tangle, const Partition& partition,
                                    std::span<const std::uint32_t> halfedges, std::uint32_t next_number, Depth depth);
  [[nodiscard]] Solution write_piece(const Tangle& tangle, const Partition& partition, std::uint32_t next_number);
  [[nodiscard]] Solution branch(const Tangle& tangle, const Partition& partition, std::uint32_t next_number,
                                Depth depth);
  void join_images(const Tangle& tangle, std::span<const std::uint32_t> members, const Solution& one,
                   const Solution& other, DisjointSets& joined);

  const Mesh& mesh_;
  Writer& writer_;
  Images images_;
  GivenNumbers given_;
};

}  // namespace quadmatch::canonical
