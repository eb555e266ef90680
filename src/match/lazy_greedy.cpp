// §4.5.3, the lazy-greedy heuristic: "extend mu in each iteration by adding the matches defined by a largest connected
// component (i.e., path or cycle) in L".
//
// Lazy, since it postpones matches that would be valid but belong to a small component: the quads on both sides of a
// squeezed row are matched long before anyone ventures across it (Fig 4.5).

#include "compatibility.hpp"

namespace quadmatch {
namespace {

constexpr std::size_t kFacesBetweenReports = 1 << 16;

/// Reading: members of one component can contradict each other far away from where they are linked; they are accepted
/// in the order of the wavefront, and one that does not fit those before it is passed over.
void accept_component(Growth& growth, const std::vector<CompatibilityGraph::Member>& component) {
  bool previous_is_in = false;
  for (const auto& [candidate, across_vertex] : component) {
    const FaceId q = growth.source().face(candidate.source);
    const bool is_in = growth.is_matched(q) && growth.image(candidate.source) == candidate.target;
    const bool joins = !across_vertex || previous_is_in;
    previous_is_in = is_in || (joins && growth.fits(candidate));
    if (previous_is_in && !is_in) growth.accept(candidate);
  }
}

}  // namespace

bool grow_lazily(Growth& growth, const GrowthProgress& progress) {
  CompatibilityGraph graph(growth);
  graph.extend(0);
  std::size_t report = kFacesBetweenReports;
  for (auto component = graph.take_largest(); !component.empty(); component = graph.take_largest()) {
    const std::size_t before = growth.matched_faces();
    accept_component(growth, component);
    graph.extend(before);
    if (growth.matched_faces() > before) growth.end_wave();
    if (progress && growth.matched_faces() >= report) {
      if (!progress(growth.matched_faces())) return false;
      report = growth.matched_faces() + kFacesBetweenReports;
    }
  }
  return true;
}

}  // namespace quadmatch
