// Symmetry, its arrays seen without a copy; symmetry and symmetrize.

#include <array>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <quadmatch/use/symmetry.hpp>
#include <quadmatch/verify/verify.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "carrying.hpp"
#include "errors.hpp"
#include "fitting.hpp"
#include "watch.hpp"

namespace quadmatch::python {
namespace {

/// A mirror, and its match as Python sees matches.
struct FoundMirror {
  Symmetry symmetry;
  MatchHandle match;
};

using MirrorHandle = std::shared_ptr<FoundMirror>;

constexpr Words<MirrorSide, 6> kSides{{{"+x", {0, true}},
                                       {"-x", {0, false}},
                                       {"+y", {1, true}},
                                       {"-y", {1, false}},
                                       {"+z", {2, true}},
                                       {"-z", {2, false}}}};

std::vector<std::pair<std::string, std::string>> settings_of(bool positions) {
  return {{"program", "quadmatch " QUADMATCH_VERSION " (Python)"},
          {"verb", "symmetry"},
          {"positions", positions ? "true" : "false"}};
}

MirrorHandle find_mirror(const MeshHandle& mesh, bool positions, py::object progress) {
  Watch watch(std::move(progress), 0);
  const SymmetryOptions options{.positions = positions, .progress = watch.progress_function()};
  Symmetry symmetry;
  Verdict verdict;
  {
    const py::gil_scoped_release released;
    symmetry = find_symmetry(mesh->mesh, options);
    verdict = verify(mesh->mesh, mesh->mesh, symmetry.match, 1);
  }
  watch.finish(symmetry.match.matched_faces(), mesh->mesh.face_count());
  check_sound(verdict);
  MatchHandle match = std::make_shared<MatchFile>(
      MatchFile{side_of(*mesh), side_of(*mesh), symmetry.match, settings_of(positions), {}});
  return std::make_shared<FoundMirror>(FoundMirror{std::move(symmetry), std::move(match)});
}

py::tuple copy_side(const MeshHandle& mesh, const MirrorHandle& mirror, const std::string& side,
                    const std::vector<std::string>& only) {
  const SymmetrizeOptions options{.from = taken(meaning(kSides, "side", side)),
                                  .carry = taken(carry_of(kCarried, only, SymmetrizeOptions::positions_only()))};
  check_fits(*mirror->match, *mesh, *mesh);
  Expected<Symmetrized> result = [&] {
    const py::gil_scoped_release released;
    return symmetrize(*mesh, mirror->symmetry, options);
  }();
  Symmetrized done = taken(std::move(result));
  return py::make_tuple(std::make_shared<MeshFile>(std::move(done.file)),
                        py::dict(py::arg("moved") = done.moved, py::arg("farthest") = done.farthest,
                                 py::arg("attributes") = as_list(done.report.attributes)));
}

py::dict line_of(const py::object& self) {
  const CentreLine& line = self.cast<MirrorHandle>()->symmetry.line;
  return py::dict(py::arg("vertices") = ids_view(line.vertices, self), py::arg("edges") = ids_view(line.edges, self),
                  py::arg("crossed_edges") = ids_view(line.crossed_edges, self),
                  py::arg("faces") = ids_view(line.faces, self));
}

py::object plane_of(const FoundMirror& mirror) {
  const std::optional<MirrorPlane>& plane = mirror.symmetry.plane;
  if (!plane) return py::none();
  return py::dict(py::arg("normal") = py::tuple(py::cast(plane->normal)), py::arg("offset") = plane->offset,
                  py::arg("error") = plane->error, py::arg("fits") = plane->fits());
}

template <class Member>
auto of_symmetry(Member member) {
  return [member](const FoundMirror& mirror) { return mirror.symmetry.*member; };
}

template <class Member>
auto ids_of(Member member) {
  return [member](const py::object& self) { return ids_view(self.cast<MirrorHandle>()->symmetry.*member, self); };
}

}  // namespace

void bind_symmetry(py::module_& module) {
  py::class_<FoundMirror, MirrorHandle>(module, "Symmetry")
      .def_property_readonly("match", [](const FoundMirror& mirror) { return mirror.match; })
      .def_property_readonly("line", &line_of)
      .def_property_readonly("plane", &plane_of)
      .def_property_readonly("unpaired_faces", ids_of(&Symmetry::unpaired_faces))
      .def_property_readonly("unpaired_vertices", ids_of(&Symmetry::unpaired_vertices))
      .def_property_readonly("faces", of_symmetry(&Symmetry::faces))
      .def_property_readonly("vertices", of_symmetry(&Symmetry::vertices))
      .def_property_readonly("face_pairs", of_symmetry(&Symmetry::face_pairs))
      .def_property_readonly("vertex_pairs", of_symmetry(&Symmetry::vertex_pairs))
      .def_property_readonly("mirrors", of_symmetry(&Symmetry::mirrors))
      .def_property_readonly("maybe_more", of_symmetry(&Symmetry::maybe_more))
      .def_property_readonly("complete", of_symmetry(&Symmetry::complete))
      .def_property_readonly("whole", [](const FoundMirror& mirror) { return mirror.symmetry.whole(); });

  module.def("symmetry", &find_mirror, py::arg("mesh"), py::kw_only(), py::arg("positions"), py::arg("progress"));
  module.def("symmetrize", &copy_side, py::arg("mesh"), py::arg("symmetry"), py::kw_only(), py::arg("side"),
             py::arg("only"));
}

}  // namespace quadmatch::python
