// transfer: the library's, its report as plain values.

#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <quadmatch/use/transfer.hpp>

#include "bindings.hpp"
#include "errors.hpp"
#include "fitting.hpp"
#include "words.hpp"

namespace quadmatch::python {
namespace {

constexpr Words<bool Carry::*, 9> kKinds{{{"uv", &Carry::texture_coordinates},
                                          {"colours", &Carry::colours},
                                          {"properties", &Carry::properties},
                                          {"groups", &Carry::groups},
                                          {"materials", &Carry::materials},
                                          {"smoothing", &Carry::smoothing},
                                          {"normals", &Carry::normals},
                                          {"positions", &Carry::positions},
                                          {"none", nullptr}}};
constexpr Words<Fill, 3> kFills{{{"keep", Fill::Keep}, {"none", Fill::None}, {"smooth", Fill::Smooth}}};

/// What `only` names; all that is carried by default where it names nothing.
Carry carry_of(const std::vector<std::string>& only) {
  if (only.empty()) return {};
  Carry carry = Carry::nothing();
  for (const std::string& word : only) {
    if (bool Carry::*const wanted = taken(meaning(kKinds, "only", word))) carry.*wanted = true;
  }
  return carry;
}

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

py::dict as_dict(const TransferredAttribute& attribute) {
  return py::dict(py::arg("name") = attribute.name, py::arg("domain") = name_of(attribute.domain),
                  py::arg("carried") = attribute.carried, py::arg("kept") = attribute.kept,
                  py::arg("filled") = attribute.filled, py::arg("without") = attribute.without,
                  py::arg("remarks") = py::tuple(py::cast(attribute.remarks)));
}

py::dict as_dict(const LeftOutRegion& part) {
  const bool ambiguous = part.reason == LeftOutRegion::Reason::Ambiguous;
  return py::dict(py::arg("reason") = ambiguous ? "ambiguous" : "low confidence", py::arg("region") = part.region,
                  py::arg("faces") = part.faces, py::arg("first_source") = part.first_source.value,
                  py::arg("first_target") = part.first_target.value, py::arg("ways") = part.ways,
                  py::arg("confidence") = part.confidence);
}

py::dict as_dict(const TransferReport& report) {
  py::list attributes, left_out;
  for (const TransferredAttribute& attribute : report.attributes) attributes.append(as_dict(attribute));
  for (const LeftOutRegion& part : report.left_out) left_out.append(as_dict(part));
  return py::dict(py::arg("attributes") = attributes, py::arg("left_out") = left_out, py::arg("faces") = report.faces,
                  py::arg("vertices") = report.vertices, py::arg("matched_faces") = report.matched_faces,
                  py::arg("matched_vertices") = report.matched_vertices, py::arg("reversing") = report.reversing);
}

py::tuple carry_over(const MeshHandle& source, const MeshHandle& target, const MatchHandle& match,
                     const std::vector<std::string>& only, const std::string& fill, bool order, bool allow_ambiguous,
                     double min_confidence, bool positions) {
  const TransferOptions options{.carry = carry_of(only),
                                .fill = taken(meaning(kFills, "fill", fill)),
                                .order = order,
                                .allow_ambiguous = allow_ambiguous,
                                .positions = positions,
                                .least_confidence = min_confidence};
  if (const Expected<void> fine = check_share("min_confidence", min_confidence); !fine) raise(fine.error());
  check_fits(*match, *source, *target);
  Expected<Transferred> result = [&] {
    const py::gil_scoped_release released;
    return transfer(*source, *target, match->match, options);
  }();
  Transferred transferred = taken(std::move(result));
  return py::make_tuple(std::make_shared<MeshFile>(std::move(transferred.file)), as_dict(transferred.report));
}

}  // namespace

void bind_transfer(py::module_& module) {
  module.def("transfer", &carry_over, py::arg("source"), py::arg("target"), py::arg("match"), py::kw_only(),
             py::arg("only"), py::arg("fill"), py::arg("order"), py::arg("allow_ambiguous"), py::arg("min_confidence"),
             py::arg("positions"));
}

}  // namespace quadmatch::python
