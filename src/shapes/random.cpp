#include <quadmatch/shapes/random.hpp>

#include <cassert>
#include <limits>
#include <numeric>

namespace quadmatch::shapes {

std::uint32_t Random::below(std::uint32_t bound) {
  assert(bound > 0);
  // What lies beyond the last whole multiple of `bound` would favour small numbers, so it is drawn again.
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  const std::uint64_t limit = most - most % bound;
  std::uint64_t drawn = engine_();
  while (drawn >= limit) drawn = engine_();
  return static_cast<std::uint32_t>(drawn % bound);
}

std::vector<std::uint32_t> Random::permutation(std::uint32_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  for (std::uint32_t left = count; left > 1; --left) std::swap(order[left - 1], order[below(left)]);
  return order;
}

}  // namespace quadmatch::shapes
