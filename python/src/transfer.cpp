// transfer: the library's, its report as plain values.

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

#include <quadmatch/use/transfer.hpp>

#include "bindings.hpp"
#include "carrying.hpp"
#include "errors.hpp"
#include "fitting.hpp"
#include "words.hpp"

namespace quadmatch::python {
namespace {

/// What `only` names, or nothing at all: for the order alone.
constexpr Words<bool Carry::*, kCarried.size() + 1> words_of_only() {
  Words<bool Carry::*, kCarried.size() + 1> words{};
  std::copy(kCarried.begin(), kCarried.end(), words.begin());
  words.back() = {"none", nullptr};
  return words;
}
constexpr Words<Fill, 3> kFills{{{"keep", Fill::Keep}, {"none", Fill::None}, {"smooth", Fill::Smooth}}};

py::dict as_dict(const LeftOutRegion& part) {
  const bool ambiguous = part.reason == LeftOutRegion::Reason::Ambiguous;
  return py::dict(py::arg("reason") = ambiguous ? "ambiguous" : "low confidence", py::arg("region") = part.region,
                  py::arg("faces") = part.faces, py::arg("first_source") = part.first_source.value,
                  py::arg("first_target") = part.first_target.value, py::arg("ways") = part.ways,
                  py::arg("confidence") = part.confidence);
}

py::dict as_dict(const TransferReport& report) {
  py::list left_out;
  for (const LeftOutRegion& part : report.left_out) left_out.append(as_dict(part));
  return py::dict(py::arg("attributes") = as_list(report.attributes), py::arg("left_out") = left_out,
                  py::arg("faces") = report.faces, py::arg("vertices") = report.vertices,
                  py::arg("matched_faces") = report.matched_faces,
                  py::arg("matched_vertices") = report.matched_vertices, py::arg("reversing") = report.reversing);
}

py::tuple carry_over(const MeshHandle& source, const MeshHandle& target, const MatchHandle& match,
                     const std::vector<std::string>& only, const std::string& fill, bool order, bool allow_ambiguous,
                     double min_confidence, bool positions) {
  const TransferOptions options{.carry = taken(carry_of(words_of_only(), only, Carry{})),
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
