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

/// A component C of more faces than the best region can hold a better region only if that loses at most
/// D = |C| - best - 1 of them. To show that none does, show for two disjoint blocks of it that none loses at most d of
/// the one, and none at most D - d - 1 of the other; each block likewise, down to blocks of which nothing may be lost.
/// Such a block has but one place for each image of its first face.
class Solver {
 public:
  /// @param target  as it is laid: for Reversing, in the mirror.
  Solver(const Mesh& source, const Mesh& target, Orientation orientation, Incumbent& incumbent, Budget& budget);

  /// Look for a good region first: what a search need not find saves most of it.
  void probe();

  /// Try to prove that nothing is better, with some patience; more in the next round.
  void round();

  /// No region laid this way has more faces than this, or than the incumbent asks for.
  [[nodiscard]] std::uint32_t bound() const;
  [[nodiscard]] bool finished() const { return bound() <= incumbent_.to_beat; }

 private:
  struct Part {
    Block faces;
    std::uint32_t budget = 0;  // losses
    std::int64_t promise = 0;  // the more, the sooner it is tried
  };
  struct Placement {
    HalfedgeId there;  // lies under the first half-edge of the block
    std::uint32_t disagreeing;
  };

  void choose_side();
  [[nodiscard]] std::uint32_t losses_needed() const;
  bool prove(const Block& faces, std::uint32_t budget);
  bool prove_inner(const Part& part);
  bool prove_both(Part& one, Part& two);
  bool prove_whole(const Block& block);
  std::array<Part, 2> parts_of(const Block& faces, std::uint32_t budget);
  [[nodiscard]] std::vector<HalfedgeId> ways_through(const Block& block) const;
  bool place(const Block& block, const std::vector<HalfedgeId>& ways, HalfedgeId there, Rim* rim);
  std::vector<Placement> placements(const Block& block, const std::vector<HalfedgeId>& ways);
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
  std::vector<Block> component_faces_;      // of that side
  std::vector<std::uint32_t> most_losses_;  // that every better region in a component is known to have
  std::uint32_t component_ = 0;             // being proved
  std::uint32_t losses_ = 0;                // of a better region in it, by what is proved in this round
  PerFace<std::uint8_t> matched_;           // faces of that side in the incumbent
  std::mt19937 random_{1};
  double patience_ = 30000;  // nodes below one placement
};

}  // namespace quadmatch::exact
