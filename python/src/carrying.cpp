#include "carrying.hpp"

#include <pybind11/stl.h>

namespace quadmatch::python {

const char* name_of(Domain domain) {
  switch (domain) {
    case Domain::Vertex:
      return "vertex";
    case Domain::Corner:
      return "corner";
    case Domain::Face:
      return "face";
    default:
      return "further";
  }
}

py::list as_list(const std::vector<TransferredAttribute>& attributes) {
  py::list list;
  for (const TransferredAttribute& attribute : attributes) {
    list.append(py::dict(py::arg("name") = attribute.name, py::arg("domain") = name_of(attribute.domain),
                         py::arg("carried") = attribute.carried, py::arg("kept") = attribute.kept,
                         py::arg("filled") = attribute.filled, py::arg("without") = attribute.without,
                         py::arg("remarks") = py::tuple(py::cast(attribute.remarks))));
  }
  return list;
}

}  // namespace quadmatch::python
