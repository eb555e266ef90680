#pragma once
/// Sets that are united and never divided (union-find): each is named by its lowest member, so no name depends on the
/// order of the unions.

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace quadmatch {

class DisjointSets {
 public:
  /// 0 ... count - 1, each alone.
  explicit DisjointSets(std::uint32_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  /// The lowest member of the set of `a`. Amortised O(log count).
  [[nodiscard]] std::uint32_t find(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a > b) std::swap(a, b);
    parent_[b] = a;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace quadmatch
