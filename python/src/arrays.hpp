#pragma once
/// NumPy arrays over memory of the library: read-only, not copied, keeping their owner alive.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>

#include <quadmatch/mesh/ids.hpp>

namespace quadmatch::python {

namespace py = pybind11;

/// Rows of `columns` numbers, writable; 0: an array of one axis.
[[nodiscard]] py::array array_over(const py::dtype& type, const void* data, std::size_t rows, std::size_t columns,
                                   const py::handle& owner);

/// The same, read-only.
[[nodiscard]] py::array view_of(const py::dtype& type, const void* data, std::size_t rows, std::size_t columns,
                                const py::handle& owner);

/// How many ids make up an element; 0 for a single one.
template <class Element>
constexpr std::size_t id_columns() {
  constexpr std::size_t kIdBytes = 4;
  static_assert(std::is_standard_layout_v<Element> && sizeof(Element) % kIdBytes == 0);
  return sizeof(Element) == kIdBytes ? 0 : sizeof(Element) / kIdBytes;
}

/// Elements of 32-bit ids as int32: ids are below 2^31 in all meshes that Python sees, and "none" reads as -1.
template <class Element>
[[nodiscard]] py::array ids_view(const Element* data, std::size_t count, const py::handle& owner) {
  return view_of(py::dtype::of<std::int32_t>(), data, count, id_columns<Element>(), owner);
}

template <class Element>
[[nodiscard]] py::array ids_view(const std::vector<Element>& elements, const py::handle& owner) {
  return ids_view(elements.data(), elements.size(), owner);
}

[[nodiscard]] inline py::array numbers_view(const std::vector<double>& numbers, std::size_t columns,
                                            const py::handle& owner) {
  return view_of(py::dtype::of<double>(), numbers.data(), columns == 0 ? numbers.size() : numbers.size() / columns,
                 columns, owner);
}

/// A new array, writable, that takes over a vector of 32-bit numbers or of rows of ids.
template <class Element>
[[nodiscard]] py::array owned(std::vector<Element> elements) {
  auto kept = std::make_unique<std::vector<Element>>(std::move(elements));
  const std::vector<Element>& vector = *kept;
  const py::capsule owner(kept.release(), [](void* data) { delete static_cast<std::vector<Element>*>(data); });
  return array_over(py::dtype::of<std::int32_t>(), vector.data(), vector.size(), id_columns<Element>(), owner);
}

}  // namespace quadmatch::python
