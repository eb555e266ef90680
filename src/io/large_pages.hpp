#pragma once
/// Memory that is about to be filled, once and from front to end.

#include <cstddef>
#include <vector>

namespace quadmatch::io {

/// Ask the system for large pages behind a large block: to touch a small page first costs as much time as to scan it.
/// A hint, of no effect where the system has none.
void prefer_large_pages(void* begin, std::size_t size);

/// Reserve room in a vector, on large pages if there is much of it.
template <class T>
void reserve_on_large_pages(std::vector<T>& vector, std::size_t count) {
  vector.reserve(count);
  prefer_large_pages(vector.data(), count * sizeof(T));
}

}  // namespace quadmatch::io
