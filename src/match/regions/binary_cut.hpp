#pragma once
/// Choose yes or no for many things at once, at the least total cost: a minimum cut (Kolmogorov & Zabih 2004).

#include <cstdint>
#include <utility>
#include <vector>

namespace quadmatch::regions {

/// Costs are fixed-point, so that the answer is the same on every machine.
class BinaryCut {
 public:
  explicit BinaryCut(std::uint32_t count) : no_(count, 0), yes_(count, 0) {}

  /// What thing `i` costs by itself.
  void add_cost(std::uint32_t i, double if_no, double if_yes);
  /// What two things cost together. Costs for which two equal answers together cost more than two different ones
  /// (not submodular) are lowered until they do not.
  void add_pair_cost(std::uint32_t i, std::uint32_t j, double no_no, double no_yes, double yes_no, double yes_yes);

  /// The cheapest answers; where several are, with the fewest yes.
  /// @par Cost  that of Boykov & Kolmogorov's algorithm, linear in practice.
  [[nodiscard]] std::vector<bool> solve() const;
  /// By how much some answers are cheaper than all no.
  [[nodiscard]] double gain(const std::vector<bool>& yes) const;

 private:
  struct Link {
    std::uint32_t from, to;
    std::int64_t capacity;  // paid where `from` is yes and `to` is no
  };
  std::vector<std::int64_t> no_, yes_;
  std::vector<Link> links_;
};

}  // namespace quadmatch::regions
