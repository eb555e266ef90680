#pragma once
/// Hops over quads that one mesh has and the other has not: what an edit inserted.

#include "mending.hpp"

namespace quadmatch::regions {

/// How far a hop may go.
constexpr int kMostHops = 2;

/// Where one lands beyond the pair of edges (s, t): half-edges across one or two free quads of one mesh, and across
/// none of the other.
/// @param visit  called with each landing, a pair of half-edges that leave the faces landed on.
template <class Visit>
void for_each_landing(const Workbench& bench, Candidate edges, Visit visit) {
  const Mesh& source = bench.sides.source.mesh;
  const Mesh& target = bench.sides.target.mesh;
  const auto across = [](const Mesh& mesh, HalfedgeId h, auto is_free) {
    const HalfedgeId entry = mesh.twin(h);
    if (!entry.valid() || mesh.size(mesh.face(entry)) != 4 || !is_free(mesh.face(entry))) return HalfedgeId();
    return mesh.next(mesh.next(entry));
  };
  const auto visit_valid = [&](Candidate landing) {
    if (landing.source.valid() && landing.target.valid()) visit(landing);
  };
  HalfedgeId over = edges.source;
  for (int hops = 0; hops < kMostHops; ++hops) {
    over = across(source, over, [&](FaceId f) { return !bench.patchwork.is_matched(f); });
    if (!over.valid()) break;
    visit_valid({source.twin(over), target.twin(edges.target)});
  }
  over = edges.target;
  for (int hops = 0; hops < kMostHops; ++hops) {
    over = across(target, over, [&](FaceId f) { return !bench.patchwork.is_taken(f); });
    if (!over.valid()) break;
    visit_valid({source.twin(edges.source), target.twin(over)});
  }
}

/// Does a matched face beyond a hop lie as it should?
/// @param counts  whether a region is to be heard.
template <class Counts>
[[nodiscard]] bool agrees_after_hop(const Workbench& bench, Candidate edges, Counts counts) {
  bool agrees = false;
  for_each_landing(bench, edges, [&](Candidate landing) {
    const FaceId face = bench.sides.source.mesh.face(landing.source);
    agrees = agrees || (bench.patchwork.is_matched(face) && bench.patchwork.image(landing.source) == landing.target &&
                        counts(bench.patchwork.region(face)));
  });
  return agrees;
}

}  // namespace quadmatch::regions
