#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include <quadmatch/mesh/large_pages.hpp>

using namespace quadmatch;

namespace {

/// Enough for large pages, and for small ones at both ends.
constexpr std::size_t kMany = 3'000'001;

}  // namespace

TEST_CASE("a large array holds the values it was filled with, also where it held others before") {
  std::vector<std::uint32_t> numbers(5, 1);
  assign_on_large_pages(numbers, kMany, 7U);
  CHECK(numbers.size() == kMany);
  CHECK(std::all_of(numbers.begin(), numbers.end(), [](std::uint32_t number) { return number == 7; }));
}

TEST_CASE("asking for large pages does not touch what is in a block already") {
  std::vector<std::uint8_t> bytes(kMany);
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<std::uint8_t>(k * k >> 3U);
  const std::vector<std::uint8_t> before = bytes;
  prefer_large_pages(bytes.data() + 1, bytes.size() - 1);
  CHECK(bytes == before);
}

TEST_CASE("bits can be many too") {
  std::vector<bool> bits;
  assign_on_large_pages(bits, 64 * kMany, true);
  CHECK(bits.size() == 64 * kMany);
  CHECK(bits[kMany]);
}

TEST_CASE("making room a little at a time moves the array seldom, and keeps what is in it") {
  std::vector<std::uint32_t> numbers;
  int moves = 0;
  for (std::uint32_t k = 0; k < 100'000; ++k) {
    const std::size_t room = numbers.capacity();
    reserve_more_on_large_pages(numbers, 1);
    moves += numbers.capacity() != room;
    numbers.push_back(k);
  }
  CHECK(moves < 20);
  CHECK(numbers[4711] == 4711);
  reserve_more_on_large_pages(numbers, kMany);
  CHECK(numbers.capacity() >= 100'000 + kMany);
}
