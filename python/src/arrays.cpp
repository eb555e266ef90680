#include "arrays.hpp"

#include <utility>
#include <vector>

namespace quadmatch::python {

py::array array_over(const py::dtype& type, const void* data, std::size_t rows, std::size_t columns,
                     const py::handle& owner) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  if (columns > 0) shape.push_back(static_cast<py::ssize_t>(columns));
  return py::array(type, std::move(shape), {}, data, owner);
}

py::array view_of(const py::dtype& type, const void* data, std::size_t rows, std::size_t columns,
                  const py::handle& owner) {
  py::array array = array_over(type, data, rows, columns, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

}  // namespace quadmatch::python
