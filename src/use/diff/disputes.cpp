#include "disputes.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include <quadmatch/mesh/disjoint_sets.hpp>

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Unmatched faces, by the connected piece they are in.
struct Pieces {
  PerFace<std::uint32_t> of_face;
  std::uint32_t count = 0;
};

Pieces find_pieces(const Side& side) {
  const Mesh& mesh = *side.mesh;
  Pieces pieces{PerFace<std::uint32_t>(mesh.face_count(), kNone)};
  std::vector<FaceId> to_visit;
  for (std::uint32_t lowest = 0; lowest < mesh.face_count(); ++lowest) {
    if (side.is_matched(FaceId(lowest)) || pieces.of_face[FaceId(lowest)] != kNone) continue;
    pieces.of_face[FaceId(lowest)] = pieces.count;
    to_visit.assign(1, FaceId(lowest));
    while (!to_visit.empty()) {
      const FaceId here = to_visit.back();
      to_visit.pop_back();
      for (const HalfedgeId h : mesh.halfedges(here)) {
        if (side.beyond(h) != Beyond::Unmatched) continue;
        const FaceId next = mesh.face(mesh.twin(h));
        if (pieces.of_face[next] != kNone) continue;
        pieces.of_face[next] = pieces.count;
        to_visit.push_back(next);
      }
    }
    ++pieces.count;
  }
  return pieces;
}

std::vector<Dispute> find_disputes(const Sides& sides) {
  const Mesh& source = *sides.source.mesh;
  std::vector<Dispute> disputes;
  for (std::uint32_t k = 0; k < source.halfedge_count(); ++k) {
    const HalfedgeId h(k);
    const HalfedgeId image = sides.source.image[h];
    if (!image.valid()) continue;
    const Beyond there = sides.source.beyond(h), here = sides.target.beyond(image);
    const bool both_end = there == Beyond::Nothing && here == Beyond::Nothing;
    const bool both_go_on = there == Beyond::Matched && here == Beyond::Matched &&
                            sides.source.image[source.twin(h)] == sides.target.mesh->twin(image);
    if (!both_end && !both_go_on) disputes.push_back({h, image, there, here});
  }
  return disputes;
}

/// Disputes come first in the sets, then the pieces of the source, then those of the target.
class Gathering {
 public:
  explicit Gathering(const Sides& sides)
      : sides_(sides),
        disputes_(find_disputes(sides)),
        source_pieces_(find_pieces(sides.source)),
        target_pieces_(find_pieces(sides.target)),
        number_(sides.source.mesh->halfedge_count(), kNone),
        sets_(first_target_piece() + target_pieces_.count) {
    for (std::uint32_t d = 0; d < disputes_.size(); ++d) number_[disputes_[d].source] = d;
  }

  std::vector<Area> areas() {
    for (std::uint32_t d = 0; d < disputes_.size(); ++d) join_across(d);
    join_at_vertices(&Dispute::source, sides_.source);
    join_at_vertices(&Dispute::target, sides_.target);
    std::vector<Area> areas = gather();
    add_loose_vertices(areas);
    return areas;
  }

 private:
  [[nodiscard]] std::uint32_t first_source_piece() const { return static_cast<std::uint32_t>(disputes_.size()); }
  [[nodiscard]] std::uint32_t first_target_piece() const { return first_source_piece() + source_pieces_.count; }

  /// With what lies beyond it, in both meshes.
  void join_across(std::uint32_t d) {
    const Dispute& dispute = disputes_[d];
    const Mesh &source = *sides_.source.mesh, &target = *sides_.target.mesh;
    if (dispute.in_source != Beyond::Nothing) {
      const HalfedgeId other = source.twin(dispute.source);
      sets_.join(d, dispute.in_source == Beyond::Matched
                        ? number_[other]
                        : first_source_piece() + source_pieces_.of_face[source.face(other)]);
    }
    if (dispute.in_target != Beyond::Nothing) {
      const HalfedgeId other = target.twin(dispute.target);
      sets_.join(d, dispute.in_target == Beyond::Matched
                        ? number_[sides_.target.image[other]]
                        : first_target_piece() + target_pieces_.of_face[target.face(other)]);
    }
  }

  /// A slit is one thing, and what frays at its end belongs to it; areas that only touch are two.
  void join_at_vertices(HalfedgeId Dispute::*half, const Side& side) {
    const Mesh& mesh = *side.mesh;
    PerVertex<std::uint32_t> cut_at(mesh.vertex_count(), kNone);
    for (const bool cuts : {true, false}) {
      for (std::uint32_t d = 0; d < disputes_.size(); ++d) {
        if (disputes_[d].is_cut() != cuts) continue;
        const HalfedgeId h = disputes_[d].*half;
        for (const VertexId v : {mesh.origin(h), mesh.tip(h)}) {
          if (cut_at[v] != kNone) sets_.join(d, cut_at[v]);
          if (cuts && cut_at[v] == kNone) cut_at[v] = d;
        }
      }
    }
  }

  Area& area_of(std::uint32_t member, std::vector<Area>& areas) {
    const auto [place, is_new] = place_.try_emplace(sets_.find(member), areas.size());
    if (is_new) areas.emplace_back();
    return areas[place->second];
  }

  std::vector<Area> gather() {
    std::vector<Area> areas;
    for (std::uint32_t d = 0; d < disputes_.size(); ++d) area_of(d, areas).disputes.push_back(disputes_[d]);
    for (std::uint32_t p = 0; p < source_pieces_.count; ++p) ++area_of(first_source_piece() + p, areas).source_pieces;
    for (std::uint32_t p = 0; p < target_pieces_.count; ++p) ++area_of(first_target_piece() + p, areas).target_pieces;
    for (std::uint32_t f = 0; f < source_pieces_.of_face.size(); ++f) {
      const std::uint32_t piece = source_pieces_.of_face[FaceId(f)];
      if (piece != kNone) area_of(first_source_piece() + piece, areas).source_faces.emplace_back(f);
    }
    for (std::uint32_t f = 0; f < target_pieces_.of_face.size(); ++f) {
      const std::uint32_t piece = target_pieces_.of_face[FaceId(f)];
      if (piece != kNone) area_of(first_target_piece() + piece, areas).target_faces.emplace_back(f);
    }
    return areas;
  }

  /// Pieces that met in one vertex and do not any more, or the other way round: no edge tells of it.
  void add_loose_vertices(std::vector<Area>& areas) const {
    const std::size_t first = areas.size();
    add_loose_vertices(sides_.source, *sides_.target.mesh, &Dispute::source, areas);
    for (std::size_t k = first; k < areas.size(); ++k) areas[k].torn = true;
    const std::size_t second = areas.size();
    add_loose_vertices(sides_.target, *sides_.source.mesh, &Dispute::target, areas);
    for (std::size_t k = second; k < areas.size(); ++k) {
      areas[k].joined = true;
      // Faces of the target, so far.
      for (FaceId& f : areas[k].met) f = sides_.source.mesh->face(sides_.target.image[sides_.target.mesh->first(f)]);
    }
  }

  /// An area for each vertex of several images and without a dispute.
  void add_loose_vertices(const Side& side, const Mesh& other, HalfedgeId Dispute::*half,
                          std::vector<Area>& areas) const {
    const Mesh& mesh = *side.mesh;
    PerVertex<std::uint8_t> settled(mesh.vertex_count(), 0);
    for (const Dispute& dispute : disputes_) settled[mesh.origin(dispute.*half)] = settled[mesh.tip(dispute.*half)] = 1;
    PerVertex<VertexId> image(mesh.vertex_count());
    PerVertex<std::size_t> place(mesh.vertex_count(), 0);
    const auto each_corner = [&](auto&& visit) {
      for (std::uint32_t k = 0; k < mesh.halfedge_count(); ++k) {
        const HalfedgeId h(k);
        if (side.image[h].valid() && settled[mesh.origin(h)] == 0) visit(h, mesh.origin(h));
      }
    };
    each_corner([&](HalfedgeId h, VertexId v) {
      const VertexId w = corner_image(side, other, h);
      if (!image[v].valid()) image[v] = w;
      if (image[v] == w || place[v] != 0) return;
      areas.emplace_back();
      place[v] = areas.size();
    });
    each_corner([&](HalfedgeId h, VertexId v) {
      if (place[v] != 0) areas[place[v] - 1].met.push_back(mesh.face(h));
    });
  }

  /// Where the corner lies that a half-edge leaves from. Its own side and the one before meet there, and so do the
  /// images of both, whichever way round.
  static VertexId corner_image(const Side& side, const Mesh& other, HalfedgeId h) {
    const HalfedgeId here = side.image[h], before = side.image[side.mesh->prev(h)];
    return other.next(before) == here ? other.origin(here) : other.origin(before);
  }

  const Sides& sides_;
  std::vector<Dispute> disputes_;
  Pieces source_pieces_, target_pieces_;
  PerHalfedge<std::uint32_t> number_;
  DisjointSets sets_;
  std::map<std::uint32_t, std::size_t> place_;
};

}  // namespace

std::vector<Area> find_areas(const Sides& sides) { return Gathering(sides).areas(); }

}  // namespace quadmatch::use
