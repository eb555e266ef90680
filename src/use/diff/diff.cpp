// The match laid on both meshes, the areas where they go on differently, a name for each, and what moved.

#include <quadmatch/use/diff.hpp>

#include <algorithm>
#include <array>
#include <tuple>

#include <fmt/format.h>

#include <quadmatch/verify/verify.hpp>

#include "disputes.hpp"
#include "motion.hpp"
#include "naming.hpp"
#include "scene.hpp"
#include "sides.hpp"

namespace quadmatch {
namespace use {
namespace {

template <class IdType>
void sort_unique(std::vector<IdType>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// Vertices that a face uses.
PerVertex<std::uint8_t> used_vertices(const Mesh& mesh) {
  PerVertex<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const VertexId v : mesh.corners()) used[v] = 1;
  return used;
}

std::uint32_t count_set(const PerVertex<std::uint8_t>& flags) {
  return static_cast<std::uint32_t>(std::count(flags.begin(), flags.end(), 1));
}

/// Pairs of the match both of which a matched face still has, where regions were left out.
std::vector<VertexPair> laid_pairs(const Sides& sides, const Match& match) {
  const auto laid = [](const Side& side) {
    PerVertex<std::uint8_t> flags(side.mesh->vertex_count(), 0);
    for (std::uint32_t h = 0; h < side.mesh->halfedge_count(); ++h) {
      if (side.image[HalfedgeId(h)].valid()) flags[side.mesh->origin(HalfedgeId(h))] = 1;
    }
    return flags;
  };
  const PerVertex<std::uint8_t> there = laid(sides.source), here = laid(sides.target);
  std::vector<VertexPair> pairs;
  std::copy_if(match.vertices.begin(), match.vertices.end(), std::back_inserter(pairs),
               [&](const VertexPair& pair) { return there[pair.source] != 0 && here[pair.target] != 0; });
  return pairs;
}

class Naming {
 public:
  Naming(const Sides& sides, const std::vector<VertexPair>& pairs, bool positions)
      : sides_(sides),
        positions_(positions),
        has_partner_(sides.source.mesh->vertex_count(), 0),
        is_partner_(sides.target.mesh->vertex_count(), 0) {
    for (const VertexPair& pair : pairs) has_partner_[pair.source] = is_partner_[pair.target] = 1;
  }

  [[nodiscard]] Change change_of(Area area) const {
    Change change;
    const Name name = name_of(forwards(sides_, area, positions_));
    change.kind = name.kind;
    change.rows = name.rows;
    change.source_vertices = loose_vertices(sides_.source, has_partner_, area.source_faces, area, &Dispute::source);
    change.target_vertices = loose_vertices(sides_.target, is_partner_, area.target_faces, area, &Dispute::target);
    std::uint32_t sides_before = 0, sides_after = 0;
    for (const Dispute& dispute : area.disputes) {
      const bool before = dispute.in_source == Beyond::Matched, after = dispute.in_target == Beyond::Matched;
      if (before || after) change.rejoined.push_back(sides_.source.mesh->face(dispute.source));
      sides_before += before ? 1 : 0;
      sides_after += after ? 1 : 0;
    }
    change.edges = std::max(sides_before, sides_after) / 2;
    change.rejoined.insert(change.rejoined.end(), area.met.begin(), area.met.end());
    sort_unique(change.rejoined);
    change.source_faces = std::move(area.source_faces);
    change.target_faces = std::move(area.target_faces);
    return change;
  }

 private:
  [[nodiscard]] static std::vector<VertexId> loose_vertices(const Side& side, const PerVertex<std::uint8_t>& paired,
                                                            const std::vector<FaceId>& faces, const Area& area,
                                                            HalfedgeId Dispute::*half) {
    const Mesh& mesh = *side.mesh;
    std::vector<VertexId> loose;
    const auto add = [&](VertexId v) {
      if (paired[v] == 0) loose.push_back(v);
    };
    for (const FaceId f : faces) {
      for (const HalfedgeId h : mesh.halfedges(f)) add(mesh.origin(h));
    }
    for (const Dispute& dispute : area.disputes) {
      add(mesh.origin(dispute.*half));
      add(mesh.tip(dispute.*half));
    }
    sort_unique(loose);
    return loose;
  }

  const Sides& sides_;
  bool positions_;
  PerVertex<std::uint8_t> has_partner_, is_partner_;
};

DiffTotals totals_of(const Sides& sides, const Match& match, const std::vector<VertexPair>& pairs,
                     double least_confidence) {
  const Mesh &source = *sides.source.mesh, &target = *sides.target.mesh;
  DiffTotals totals;
  totals.source_faces = source.face_count();
  totals.target_faces = target.face_count();
  totals.source_vertices = count_set(used_vertices(source));
  totals.target_vertices = count_set(used_vertices(target));
  totals.matched_vertices = static_cast<std::uint32_t>(pairs.size());
  for (const Region& region : match.regions) {
    if (region.evidence.confidence() < least_confidence) continue;
    const auto faces = static_cast<std::uint32_t>(region.faces.size());
    totals.matched_faces += faces;
    if (region.orientation == Orientation::Reversing) totals.turned_faces += faces;
  }
  return totals;
}

std::vector<DoubtfulRegion> doubts_of(const Match& match, double least_confidence) {
  std::vector<DoubtfulRegion> doubtful;
  for (std::size_t r = 0; r < match.regions.size(); ++r) {
    const Region& region = match.regions[r];
    const double confidence = region.evidence.confidence();
    const bool left_out = confidence < least_confidence;
    if (!region.ambiguous && !left_out) continue;
    doubtful.push_back({r, static_cast<std::uint32_t>(region.faces.size()), region.faces.front().source,
                        region.faces.front().target, region.ways, region.ambiguous, confidence, left_out});
  }
  return doubtful;
}

FaceId first_of(const std::vector<FaceId>& faces) { return faces.empty() ? FaceId() : faces.front(); }

void sort_changes(std::vector<Change>& changes) {
  const auto key = [](const Change& change) {
    return std::make_tuple(first_of(change.source_faces), first_of(change.target_faces), first_of(change.rejoined));
  };
  std::stable_sort(changes.begin(), changes.end(), [&](const Change& a, const Change& b) {
    return a.size() != b.size() ? a.size() > b.size() : key(a) < key(b);
  });
}

}  // namespace
}  // namespace use

const char* to_string(ChangeKind kind) {
  // In the order of the kinds.
  constexpr std::array kNames{
      "new component", "removed component", "addition", "deletion", "inserted loop", "removed loop",
      "extrusion",     "undone extrusion",  "opening",  "collapse", "refinement",    "coarsening",
      "bridge",        "undone bridge",     "rip",      "weld",     "re-attachment", "re-connection"};
  static_assert(kNames.size() == static_cast<std::size_t>(ChangeKind::Reconnection) + 1);
  return kNames[static_cast<std::size_t>(kind)];
}

ChangeKind inverse(ChangeKind kind) {
  if (kind >= ChangeKind::Reattachment) return kind;
  return static_cast<ChangeKind>(static_cast<std::uint8_t>(kind) ^ 1U);
}

Expected<Difference> diff(const Mesh& source, const Mesh& target, const Match& match, const DiffOptions& options) {
  const Verdict verdict = verify(source, target, match, 1);
  if (!verdict.sound()) {
    return Unexpected(Error{
        ErrorCode::MatchDoesNotFit,
        fmt::format("the match is not sound for these meshes: {}; match them again", verdict.faults.front().message)});
  }
  const use::Sides sides = use::lay_sides(source, target, match, options.least_confidence);
  const std::vector<VertexPair> pairs = use::laid_pairs(sides, match);
  Difference difference;
  difference.totals = use::totals_of(sides, match, pairs, options.least_confidence);
  const use::Naming naming(sides, pairs, !options.ignore_positions);
  for (use::Area& area : use::find_areas(sides)) difference.changes.push_back(naming.change_of(std::move(area)));
  use::sort_changes(difference.changes);
  std::vector<FaceId> rejoined;
  for (const Change& change : difference.changes) {
    rejoined.insert(rejoined.end(), change.rejoined.begin(), change.rejoined.end());
  }
  use::sort_unique(rejoined);
  difference.totals.rejoined_faces = static_cast<std::uint32_t>(rejoined.size());
  if (!options.ignore_positions) {
    use::Motion motion = use::find_motion(source, target, pairs, options.tolerance);
    difference.moved = std::move(motion.moved);
    difference.whole_motion = motion.whole;
  }
  difference.doubtful = use::doubts_of(match, options.least_confidence);
  return difference;
}

}  // namespace quadmatch
