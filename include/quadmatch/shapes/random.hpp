#pragma once
/// Random numbers that are the same on every machine: the standard fixes std::mt19937_64 to the bit, but neither
/// std::shuffle nor its distributions, so those are our own.

#include <cstdint>
#include <random>
#include <utility>
#include <vector>

namespace quadmatch::shapes {

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// A number in 0 ... bound - 1, each equally likely.
  /// @pre bound > 0
  [[nodiscard]] std::uint32_t below(std::uint32_t bound);

  /// The numbers 0 ... count - 1 in random order (Fisher and Yates).
  [[nodiscard]] std::vector<std::uint32_t> permutation(std::uint32_t count);

 private:
  std::mt19937_64 engine_;
};

}  // namespace quadmatch::shapes
