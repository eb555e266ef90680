// diff: the library's, its changes as plain values and arrays.

#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <quadmatch/use/diff.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "fitting.hpp"
#include "words.hpp"

namespace quadmatch::python {
namespace {

py::dict as_dict(Change change) {
  const std::size_t size = change.size();
  return py::dict(py::arg("kind") = to_string(change.kind), py::arg("size") = size, py::arg("rows") = change.rows,
                  py::arg("edges") = change.edges, py::arg("source_faces") = owned(std::move(change.source_faces)),
                  py::arg("target_faces") = owned(std::move(change.target_faces)),
                  py::arg("rejoined") = owned(std::move(change.rejoined)),
                  py::arg("source_vertices") = owned(std::move(change.source_vertices)),
                  py::arg("target_vertices") = owned(std::move(change.target_vertices)));
}

py::dict as_dict(const DiffTotals& totals) {
  return py::dict(py::arg("source_faces") = totals.source_faces, py::arg("target_faces") = totals.target_faces,
                  py::arg("source_vertices") = totals.source_vertices,
                  py::arg("target_vertices") = totals.target_vertices, py::arg("matched_faces") = totals.matched_faces,
                  py::arg("matched_vertices") = totals.matched_vertices,
                  py::arg("rejoined_faces") = totals.rejoined_faces, py::arg("turned_faces") = totals.turned_faces);
}

py::object as_object(const std::optional<WholeMotion>& motion) {
  if (!motion) return py::none();
  return py::dict(py::arg("degrees") = motion->degrees, py::arg("scale") = motion->scale,
                  py::arg("mirrored") = motion->mirrored, py::arg("shift") = motion->shift);
}

py::dict as_dict(const DoubtfulRegion& region) {
  return py::dict(py::arg("region") = region.region, py::arg("faces") = region.faces,
                  py::arg("first_source") = region.first_source.value,
                  py::arg("first_target") = region.first_target.value, py::arg("ways") = region.ways,
                  py::arg("ambiguous") = region.ambiguous, py::arg("confidence") = region.confidence,
                  py::arg("left_out") = region.left_out);
}

py::dict compare(const MeshHandle& source, const MeshHandle& target, const MatchHandle& match, bool ignore_positions,
                 double tolerance, double min_confidence) {
  for (const auto& [name, share] : {std::pair{"tolerance", tolerance}, std::pair{"min_confidence", min_confidence}}) {
    if (const Expected<void> fine = check_share(name, share); !fine) raise(fine.error());
  }
  check_fits(*match, *source, *target);
  Expected<Difference> result = [&] {
    const py::gil_scoped_release released;
    return diff(source->mesh, target->mesh, match->match,
                {.ignore_positions = ignore_positions, .tolerance = tolerance, .least_confidence = min_confidence});
  }();
  Difference difference = taken(std::move(result));
  const bool none = difference.none();
  py::list changes, doubtful;
  for (Change& change : difference.changes) changes.append(as_dict(std::move(change)));
  for (const DoubtfulRegion& region : difference.doubtful) doubtful.append(as_dict(region));
  return py::dict(py::arg("same") = none, py::arg("changes") = changes, py::arg("totals") = as_dict(difference.totals),
                  py::arg("moved") = owned(std::move(difference.moved)),
                  py::arg("whole_motion") = as_object(difference.whole_motion), py::arg("doubtful") = doubtful);
}

}  // namespace

void bind_diff(py::module_& module) {
  module.def("diff", &compare, py::arg("source"), py::arg("target"), py::arg("match"), py::kw_only(),
             py::arg("ignore_positions"), py::arg("tolerance"), py::arg("min_confidence"));
}

}  // namespace quadmatch::python
