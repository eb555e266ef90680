#pragma once
/// Which faces any chain of fitting pairs can reach, whatever labels it gives them.

#include <cstdint>
#include <vector>

#include "partial.hpp"

namespace quadmatch::exact {

/// Walks the graph of pairs from the rim: a face may be reached by several pairs, each on a sheet of its own. Every
/// pair of a region is reached from the partial one by pairs of the region, so a face that no pair reaches is out.
class Sheets {
 public:
  explicit Sheets(const Partial& partial);

  /// Exclude the faces that no fitting pair reaches. Where the pairs are too many to be walked, nothing is done, and
  /// not tried again until the region has changed by a good deal.
  /// @return true if any was excluded.
  bool exclude_unreached(Partial& partial, const Rim& rim);

 private:
  bool walk(const Partial& partial, const Rim& rim);
  bool visit(const Partial& partial, const Pair& pair);
  bool note(const Pair& pair);
  bool exclude(Partial& partial, Side side);

  std::size_t most_pairs_;
  std::uint32_t stamp_ = 0;
  std::uint32_t given_up_at_ = 0xffffffff;  // size of the region when the pairs were too many
  struct Slot {
    std::uint32_t stamp = 0;
    Pair pair;
  };
  std::vector<Slot> slots_;  // open addressing, half empty at least; asked only whether a pair was seen
  std::size_t noted_ = 0;    // pairs in it
  std::vector<Pair> queue_;
  std::array<PerFace<std::uint32_t>, 2> reached_;
};

}  // namespace quadmatch::exact
