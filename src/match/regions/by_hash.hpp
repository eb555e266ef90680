#pragma once
/// Order by hashes, in linear time: their first bits alone spread them evenly.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadmatch::regions {

/// Sort things by 64-bit numbers that are well mixed, and what has equal ones by `<`.
/// @param hash_of  says the number of a thing, which `<` of things compares first.
/// @par Cost       O(n), and O(m log m) where m share their first bits.
template <class Thing, class HashOf>
void sort_by_hash(std::vector<Thing>& things, HashOf hash_of) {
  const auto shift = 64 - std::max(1, static_cast<int>(std::bit_width(things.size())));
  std::vector<std::uint32_t> end((std::size_t{1} << (64 - shift)) + 1, 0);
  for (const Thing& thing : things) ++end[(hash_of(thing) >> shift) + 1];
  for (std::size_t bucket = 1; bucket < end.size(); ++bucket) end[bucket] += end[bucket - 1];
  std::vector<Thing> sorted(things.size());
  for (const Thing& thing : things) sorted[end[hash_of(thing) >> shift]++] = thing;
  std::uint32_t first = 0;  // each bucket's end has moved to where the next begins
  for (std::size_t bucket = 0; bucket + 1 < end.size(); ++bucket) {
    const auto begin = sorted.begin() + first, last = sorted.begin() + end[bucket];
    first = end[bucket];
    if (last - begin > 1 && !std::is_sorted(begin, last)) std::sort(begin, last);
  }
  things = std::move(sorted);
}

}  // namespace quadmatch::regions
