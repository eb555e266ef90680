#include "arrays.hpp"

#include <memory>
#include <utility>

namespace quadmatch::python {

py::array view_of(const py::dtype& type, const void* data, std::size_t rows, std::size_t columns,
                  const py::handle& owner) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (columns > 0) shape.push_back(static_cast<py::ssize_t>(columns));
  py::array array(type, std::move(shape), {}, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

py::array owned(std::vector<std::int32_t> numbers) {
  auto kept = std::make_unique<std::vector<std::int32_t>>(std::move(numbers));
  const std::vector<std::int32_t>& vector = *kept;
  const py::capsule owner(kept.release(), [](void* data) { delete static_cast<std::vector<std::int32_t>*>(data); });
  return py::array(py::dtype::of<std::int32_t>(), {static_cast<py::ssize_t>(vector.size())}, {}, vector.data(), owner);
}

}  // namespace quadmatch::python
