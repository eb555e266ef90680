#pragma once
/// NumPy arrays over memory of the library: read-only, not copied, keeping their owner alive.

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

#include <pybind11/numpy.h>

#include <quadmatch/mesh/ids.hpp>

namespace quadmatch::python {

namespace py = pybind11;

/// Rows of `columns` numbers; 0: an array of one axis.
[[nodiscard]] py::array view_of(const py::dtype& type, const void* data, std::size_t rows, std::size_t columns,
                                const py::handle& owner);

/// Elements of 32-bit ids as int32: ids are below 2^31 in all meshes that Python sees, and "none" reads as -1.
template <class Element>
[[nodiscard]] py::array ids_view(const Element* data, std::size_t count, const py::handle& owner) {
  constexpr std::size_t kIdBytes = 4;
  static_assert(std::is_standard_layout_v<Element> && sizeof(Element) % kIdBytes == 0);
  constexpr std::size_t kColumns = sizeof(Element) / kIdBytes;
  return view_of(py::dtype::of<std::int32_t>(), data, count, kColumns == 1 ? 0 : kColumns, owner);
}

[[nodiscard]] inline py::array numbers_view(const std::vector<double>& numbers, std::size_t columns,
                                            const py::handle& owner) {
  return view_of(py::dtype::of<double>(), numbers.data(), columns == 0 ? numbers.size() : numbers.size() / columns,
                 columns, owner);
}

/// A new array that takes over the vector.
[[nodiscard]] py::array owned(std::vector<std::int32_t> numbers);

}  // namespace quadmatch::python
