#pragma once
/// Large arrays on large pages. To touch a small page first costs as much time as to scan it, and a mesh that is walked
/// about in touches more of them than the processor keeps in mind.

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace quadmatch {

/// Ask the system for large pages behind a large block that is about to be filled.
/// A hint, of no effect where the system has none, where the block is small, and where it was touched before.
void prefer_large_pages(void* begin, std::size_t size);

/// Reserve room in a vector, on large pages if there is much of it.
template <class T>
void reserve_on_large_pages(std::vector<T>& vector, std::size_t count) {
  if (count <= vector.capacity()) return;
  vector.reserve(count);
  if constexpr (!std::is_same_v<T, bool>) prefer_large_pages(vector.data(), count * sizeof(T));  // bits are small
}

/// Reserve room for so many more than there are, and for twice as many as there was room for: so that all of many calls
/// cost no more than one.
template <class T>
void reserve_more_on_large_pages(std::vector<T>& vector, std::size_t more) {
  const std::size_t needed = vector.size() + more;
  if (needed > vector.capacity()) reserve_on_large_pages(vector, std::max(needed, 2 * vector.capacity()));
}

/// So many equal values in place of what a vector has, on large pages if they are many.
template <class T>
void assign_on_large_pages(std::vector<T>& vector, std::size_t count, const T& value) {
  reserve_on_large_pages(vector, count);
  vector.assign(count, value);
}

}  // namespace quadmatch
