// quadmatch._core: the library as Python calls it. No logic here: the package around it turns what users have into
// arrays, and this turns arrays into meshes and calls the library, with the GIL released while it works.

#include "bindings.hpp"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The library behind the package quadmatch; use that.";
  module.attr("version") = QUADMATCH_VERSION;
  quadmatch::python::bind_mesh(module);
  quadmatch::python::bind_match(module);
  quadmatch::python::bind_transfer(module);
  quadmatch::python::bind_symmetry(module);
  quadmatch::python::bind_diff(module);
  quadmatch::python::bind_merge(module);
  quadmatch::python::bind_analysis(module);
}
