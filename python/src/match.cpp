// Match and Region, their arrays seen without a copy; match, verify, and match files.

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/verify/verify.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "errors.hpp"
#include "fitting.hpp"
#include "match_options.hpp"
#include "watch.hpp"

namespace quadmatch::python {
namespace {

/// A region of a match, which it keeps alive.
using RegionHandle = std::shared_ptr<Region>;

MatchHandle find_match(const MeshHandle& source, const MeshHandle& target, const MatchWords& words,
                       py::object progress) {
  MatchOptions options = taken(options_of(words, source->mesh, target->mesh));
  Watch watch(std::move(progress), words.time_limit);
  options.progress = watch.progress_function();
  MatchResult result;
  Verdict verdict;
  {
    const py::gil_scoped_release released;
    result = match(source->mesh, target->mesh, options);
    verdict = verify(source->mesh, target->mesh, result.match, 1);
  }
  watch.finish(result.match.matched_faces(), std::min(source->mesh.face_count(), target->mesh.face_count()));
  check_sound(verdict);
  return std::make_shared<MatchFile>(
      MatchFile{side_of(*source), side_of(*target), std::move(result.match), settings_of(words), result.optimality});
}

py::dict verified(const MeshHandle& source, const MeshHandle& target, const MatchHandle& match, std::size_t kept) {
  check_fits(*match, *source, *target);
  Verdict verdict;
  {
    const py::gil_scoped_release released;
    verdict = verify(source->mesh, target->mesh, match->match, kept);
  }
  py::list faults;
  for (const Fault& fault : verdict.faults) faults.append(fault.message);
  return py::dict(py::arg("fault_count") = verdict.fault_count, py::arg("faults") = py::tuple(faults),
                  py::arg("matched_faces") = verdict.matched_faces, py::arg("largest_region") = verdict.largest_region,
                  py::arg("matched_vertices") = verdict.matched_vertices);
}

MatchHandle read_file_of(const std::string& path) {
  Expected<MatchFile> file = [&] {
    const py::gil_scoped_release released;
    return read_match(path);
  }();
  return std::make_shared<MatchFile>(taken(std::move(file)));
}

void write_file_of(const std::string& path, const MatchHandle& match) {
  const Expected<void> written = [&] {
    const py::gil_scoped_release released;
    return write_match(path, *match);
  }();
  if (!written) raise(written.error());
}

std::vector<RegionHandle> regions_of(const MatchHandle& match) {
  std::vector<RegionHandle> regions;
  for (Region& region : match->match.regions) regions.emplace_back(match, &region);
  return regions;
}

py::object optimality_of(const MatchFile& match) {
  if (!match.optimality) return py::none();
  const Optimality& found = *match.optimality;
  constexpr std::array kDecisions{"not asked", "yes", "no", "unknown"};
  return py::dict(py::arg("bound") = found.bound, py::arg("proved") = found.proved, py::arg("nodes") = found.nodes,
                  py::arg("at_least") = found.at_least,
                  py::arg("decision") = kDecisions.at(static_cast<std::size_t>(found.decision)));
}

/// For each element of the source its partner, or -1.
py::array face_map(const MatchFile& match) {
  std::vector<std::int32_t> partner(match.source.faces, -1);
  for (const Region& region : match.match.regions) {
    for (const FacePair& pair : region.faces) {
      partner[pair.source.value] = static_cast<std::int32_t>(pair.target.value);
    }
  }
  return owned(std::move(partner));
}
py::array vertex_map(const MatchFile& match) {
  std::vector<std::int32_t> partner(match.source.vertices, -1);
  for (const VertexPair& pair : match.match.vertices) {
    partner[pair.source.value] = static_cast<std::int32_t>(pair.target.value);
  }
  return owned(std::move(partner));
}

template <class Member>
auto of_match(Member member) {
  return [member](const MatchFile& file) { return member(file.match); };
}

void bind_region(py::module_& module) {
  py::class_<Region, RegionHandle>(module, "Region")
      .def_property_readonly("reversing",
                             [](const Region& region) { return region.orientation == Orientation::Reversing; })
      .def_property_readonly("faces",
                             [](const py::object& self) { return ids_view(self.cast<RegionHandle>()->faces, self); })
      .def_property_readonly("waves",
                             [](const py::object& self) { return ids_view(self.cast<RegionHandle>()->waves, self); })
      .def_property_readonly("agreeing", [](const Region& region) { return region.evidence.agreeing; })
      .def_property_readonly("source_extraordinary",
                             [](const Region& region) { return region.evidence.source_extraordinary; })
      .def_property_readonly("target_extraordinary",
                             [](const Region& region) { return region.evidence.target_extraordinary; })
      .def_property_readonly("confidence", [](const Region& region) { return region.evidence.confidence(); })
      .def_readonly("ways", &Region::ways)
      .def_readonly("ambiguous", &Region::ambiguous);
}

void bind_match_file(py::module_& module) {
  py::class_<MatchFile, MatchHandle>(module, "Match")
      .def_property_readonly("source_path", [](const MatchFile& match) { return py::bytes(match.source.path); })
      .def_property_readonly("target_path", [](const MatchFile& match) { return py::bytes(match.target.path); })
      .def_property_readonly("source_faces", [](const MatchFile& match) { return match.source.faces; })
      .def_property_readonly("target_faces", [](const MatchFile& match) { return match.target.faces; })
      .def_property_readonly("source_vertices", [](const MatchFile& match) { return match.source.vertices; })
      .def_property_readonly("target_vertices", [](const MatchFile& match) { return match.target.vertices; })
      .def_property_readonly("matched_faces", of_match([](const Match& match) { return match.matched_faces(); }))
      .def_property_readonly("complete", of_match([](const Match& match) { return match.complete; }))
      .def_property_readonly("regions", &regions_of)
      .def_property_readonly(
          "vertices", [](const py::object& self) { return ids_view(self.cast<MatchHandle>()->match.vertices, self); })
      .def_property_readonly("face_map", &face_map)
      .def_property_readonly("vertex_map", &vertex_map)
      .def_property_readonly("settings", [](const MatchFile& match) { return match.settings; })
      .def_property_readonly("optimality", &optimality_of);
}

}  // namespace

void bind_match(py::module_& module) {
  bind_region(module);
  bind_match_file(module);
  module.def(
      "match",
      [](const MeshHandle& source, const MeshHandle& target, std::string algorithm, std::string orientation,
         bool positions, std::vector<std::string> without, double min_confidence, std::uint32_t min_region,
         std::uint32_t rounds, bool arc_lengths, bool waves, std::uint32_t at_least, double time_limit,
         std::vector<std::array<std::int64_t, 4>> anchors, py::object progress) {
        const MatchWords words{std::move(algorithm),
                               std::move(orientation),
                               positions,
                               std::move(without),
                               min_confidence,
                               min_region,
                               rounds,
                               arc_lengths,
                               waves,
                               at_least,
                               time_limit,
                               std::move(anchors)};
        return find_match(source, target, words, std::move(progress));
      },
      py::arg("source"), py::arg("target"), py::kw_only(), py::arg("algorithm"), py::arg("orientation"),
      py::arg("positions"), py::arg("without"), py::arg("min_confidence"), py::arg("min_region"), py::arg("rounds"),
      py::arg("arc_lengths"), py::arg("waves"), py::arg("at_least"), py::arg("time_limit"), py::arg("anchors"),
      py::arg("progress"));
  module.def("verify", &verified, py::arg("source"), py::arg("target"), py::arg("match"), py::arg("kept"));
  module.def("read_match", &read_file_of, py::arg("path"));
  module.def("write_match", &write_file_of, py::arg("path"), py::arg("match"));
}

}  // namespace quadmatch::python
