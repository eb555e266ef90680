#pragma once
/// Medians and other quantiles.

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadmatch::regions {

/// The number that `n` others come before, in order of size; reorders them. O(#numbers).
/// @pre n < #numbers
template <class Number>
Number nth_smallest(std::vector<Number>& numbers, std::size_t n) {
  const auto place = numbers.begin() + static_cast<std::ptrdiff_t>(n);
  std::nth_element(numbers.begin(), place, numbers.end());
  return *place;
}

}  // namespace quadmatch::regions
