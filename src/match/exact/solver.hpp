#pragma once
/// The largest region of two meshes, the target laid one way round: blocks, their placements, and searches below them.

#include <cstdint>
#include <random>
#include <vector>

#include <quadmatch/mesh/components.hpp>

#include "blocks.hpp"
#include "incumbent.hpp"
#include "partial.hpp"
#include "probe.hpp"
#include "search.hpp"

namespace quadmatch::exact {

/// A component C of more faces than the best region can hold a better region only if that loses at most |C| - best - 1
/// of them. So of |C| - best disjoint blocks of C one is in it whole. When no better region holds any of them, there is
/// none in C.
class Solver {
 public:
  /// @param target  as it is laid: for Reversing, in the mirror.
  Solver(const Mesh& source, const Mesh& target, Orientation orientation, Incumbent& incumbent, Budget& budget);

  /// Look for a good region first: what a search need not find saves most of it.
  void probe();

  /// Cut what is not proved yet into blocks, and try to prove each; those that take too long wait for the next round,
  /// which has other blocks and more patience.
  void round();

  /// No region laid this way has more faces than this, or than the incumbent asks for.
  [[nodiscard]] std::uint32_t bound() const;
  [[nodiscard]] bool finished() const { return bound() <= incumbent_.to_beat; }

 private:
  /// A block with a way to each face from one before it.
  struct PlacedBlock {
    Block faces;
    std::vector<HalfedgeId> ways;  // of faces[1 ...]: a half-edge of an earlier face, whose twin is in it
    std::uint32_t component = 0;
    std::uint32_t lost = 0;  // of its faces, in the incumbent
  };

  struct Placement {
    HalfedgeId there;  // lies under the first half-edge of the block
    std::uint32_t disagreeing;
  };

  void choose_side();
  [[nodiscard]] std::uint32_t missing_blocks(std::uint32_t component) const;
  std::vector<PlacedBlock> cut_into_blocks();
  std::vector<PlacedBlock> best_of_several_cuts();
  PlacedBlock with_ways(Block faces, std::uint32_t component) const;
  std::uint64_t count_placements(const std::vector<PlacedBlock>& blocks);
  bool place(const PlacedBlock& block, HalfedgeId there, Rim* rim);
  std::vector<Placement> placements(const PlacedBlock& block);
  bool prove(const PlacedBlock& block);
  void order(std::vector<PlacedBlock>& blocks) const;
  [[nodiscard]] bool must_stop() const { return budget_.stopped() || incumbent_.enough; }

  Orientation orientation_;
  Incumbent& incumbent_;
  Budget& budget_;
  Partial partial_;
  Probe probe_;
  Search search_;
  std::array<Components, 2> components_;
  Side side_ = kSource;  // whose blocks are proved
  bool side_chosen_ = false;
  std::vector<std::uint32_t> proved_;                 // blocks of each component of that side
  std::vector<std::vector<FaceId>> component_faces_;  // likewise
  PerFace<std::uint8_t> free_;                        // faces of that side in no proved block
  std::mt19937 random_{1};
  std::uint32_t rounds_ = 0;
  std::uint64_t patience_ = 3000;  // nodes below one placement
};

}  // namespace quadmatch::exact
