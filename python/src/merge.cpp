// merge: the library's, its report as plain values and arrays.

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <quadmatch/use/merge.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "carrying.hpp"
#include "errors.hpp"
#include "fitting.hpp"
#include "watch.hpp"
#include "words.hpp"

namespace quadmatch::python {
namespace {

constexpr Words<Side, 2> kSides{{{"ours", Side::Ours}, {"theirs", Side::Theirs}}};

/// The match of a side to the base.
MatchHandle find_match_of_side(const MeshHandle& base, const MeshHandle& side, bool positions, py::object progress) {
  Watch watch(std::move(progress), 0);
  MatchOptions options;
  options.positions = positions;
  options.progress = watch.progress_function();
  Match match;
  {
    const py::gil_scoped_release released;
    match = match_side(base->mesh, side->mesh, options);
  }
  watch.finish(match.matched_faces(), std::min(base->mesh.face_count(), side->mesh.face_count()));
  return std::make_shared<MatchFile>(MatchFile{side_of(*base),
                                               side_of(*side),
                                               std::move(match),
                                               {{"program", "quadmatch " QUADMATCH_VERSION " (Python)"},
                                                {"verb", "merge"},
                                                {"positions", positions ? "true" : "false"}},
                                               {}});
}

py::dict as_dict(const SideChanges& changes) {
  return py::dict(py::arg("matched_faces") = changes.matched_faces, py::arg("removed_faces") = changes.removed_faces,
                  py::arg("added_faces") = changes.added_faces, py::arg("changed_vertices") = changes.changed_vertices,
                  py::arg("moved_vertices") = changes.moved_vertices);
}

py::dict as_dict(ConflictArea area) {
  return py::dict(py::arg("base_vertices") = owned(std::move(area.base_vertices)),
                  py::arg("base_faces") = owned(std::move(area.base_faces)),
                  py::arg("ours_faces") = owned(std::move(area.ours_faces)),
                  py::arg("theirs_faces") = owned(std::move(area.theirs_faces)),
                  py::arg("merged_vertices") = owned(std::move(area.merged_vertices)),
                  py::arg("centre") = py::tuple(py::cast(area.centre)));
}

py::dict as_dict(const ValueConflict& conflict) {
  return py::dict(py::arg("name") = conflict.name, py::arg("domain") = name_of(conflict.domain),
                  py::arg("count") = conflict.count, py::arg("first") = py::tuple(py::cast(conflict.first)));
}

py::dict as_dict(const MergedAttribute& attribute) {
  return py::dict(py::arg("name") = attribute.name, py::arg("domain") = name_of(attribute.domain),
                  py::arg("from_ours") = attribute.from_ours, py::arg("from_theirs") = attribute.from_theirs,
                  py::arg("remarks") = py::tuple(py::cast(attribute.remarks)));
}

py::dict as_dict(const DoubtfulPart& part) {
  return py::dict(py::arg("side") = part.side == Side::Ours ? "ours" : "theirs", py::arg("region") = part.region,
                  py::arg("faces") = part.faces, py::arg("first_base") = part.first_base.value,
                  py::arg("first_side") = part.first_side.value, py::arg("ways") = part.ways,
                  py::arg("ambiguous") = part.ambiguous, py::arg("confidence") = part.confidence);
}

template <class Entry>
py::list as_list(std::vector<Entry>& entries) {
  py::list list;
  for (Entry& entry : entries) list.append(as_dict(std::move(entry)));
  return list;
}

py::dict as_dict(Merged merged) {
  MergeReport& report = merged.report;
  py::list departures;
  for (const DepartureKind kind : report.new_departures) departures.append(to_string(kind));
  return py::dict(py::arg("face_origins") = owned(std::move(merged.face_origins)),
                  py::arg("vertex_origins") = owned(std::move(merged.vertex_origins)),
                  py::arg("ours") = as_dict(report.ours), py::arg("theirs") = as_dict(report.theirs),
                  py::arg("same_added_faces") = report.same_added_faces, py::arg("areas") = as_list(report.areas),
                  py::arg("values") = as_list(report.values), py::arg("attributes") = as_list(report.attributes),
                  py::arg("doubtful") = as_list(report.doubtful), py::arg("new_departures") = py::tuple(departures),
                  py::arg("carried_along") = report.carried_along);
}

py::tuple bring_together(const MeshHandle& base, const MeshHandle& ours, const MeshHandle& theirs,
                         const MatchHandle& to_ours, const MatchHandle& to_theirs, const std::string& prefer) {
  const MergeOptions options{.prefer = taken(meaning(kSides, "prefer", prefer))};
  check_fits(*to_ours, *base, *ours);
  check_fits(*to_theirs, *base, *theirs);
  Expected<Merged> result = [&] {
    const py::gil_scoped_release released;
    return merge(*base, *ours, *theirs, to_ours->match, to_theirs->match, options);
  }();
  Merged merged = taken(std::move(result));
  MeshHandle mesh = std::make_shared<MeshFile>(std::move(merged.file));
  return py::make_tuple(std::move(mesh), as_dict(std::move(merged)));
}

}  // namespace

void bind_merge(py::module_& module) {
  module.def("match_side", &find_match_of_side, py::arg("base"), py::arg("side"), py::kw_only(), py::arg("positions"),
             py::arg("progress"));
  module.def("merge", &bring_together, py::arg("base"), py::arg("ours"), py::arg("theirs"), py::arg("to_ours"),
             py::arg("to_theirs"), py::kw_only(), py::arg("prefer"));
}

}  // namespace quadmatch::python
