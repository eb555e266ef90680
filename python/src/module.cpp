// quadmatch._core: the library as Python calls it. No logic here: the package around it turns what users have into
// arrays, and this turns arrays into meshes and calls the library, with the GIL released while it works.

#include <cstdlib>

#include "bindings.hpp"

namespace {

/// Let the allocator keep what is freed. glibc hands memory back to the system once twice as much lies idle as the
/// largest block that was ever freed, and has to ask for it anew, page by page, for the next mesh: a quarter of the
/// time of matching ten thousand faces. It goes by the largest block from now on; nothing is used for it.
void let_memory_be_kept() {
  constexpr std::size_t kBlock = std::size_t{8} << 20U;
  void* volatile block = std::malloc(kBlock);  // volatile: or the compiler leaves both calls out
  std::free(block);
}

}  // namespace

PYBIND11_MODULE(_core, module) {
  let_memory_be_kept();
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
