#pragma once
/// Regions that grow greedily: quick to find, often the largest already, and never proved so.

#include <vector>

#include <quadmatch/analysis/vertex_code.hpp>

#include "incumbent.hpp"
#include "partial.hpp"

namespace quadmatch::exact {

class Probe {
 public:
  Probe(Partial& partial, Orientation orientation, Incumbent& incumbent, Budget& budget);

  /// Grow what is committed now by every pair that fits, those first of which the fewest corners disagree, offer the
  /// region, and take the growth back.
  void grow(const Rim& rim);

  /// Grow from one pair, from many of them that `steps` allow for: all placements of a few faces of the source.
  void try_placements(std::uint64_t steps);

  /// Grow on from regions another algorithm found.
  void try_regions(const std::vector<std::vector<Pair>>& regions);

  /// Corners whose codes differ, of a pair.
  [[nodiscard]] std::uint32_t disagreeing_corners(const Pair& pair) const;

 private:
  static constexpr std::uint32_t kBuckets = 6;
  struct Queue {
    std::vector<Pair> pairs;
    std::size_t next = 0;
  };

  void push(const Pair& inside);

  Partial& partial_;
  Orientation orientation_;
  Incumbent& incumbent_;
  Budget& budget_;
  std::array<PerVertex<VertexCode>, 2> codes_;
  std::array<Queue, kBuckets> queues_;
};

}  // namespace quadmatch::exact
