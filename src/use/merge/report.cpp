#include "report.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace quadmatch::use {
namespace {

template <class Id>
void sort_and_unite(std::vector<Id>& ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

bool is_elsewhere(const ThreeMeshes& meshes, Side side, const InThree<HalfedgeId>& corner) {
  const Mesh &base = mesh_of(meshes, Side::Base), &mesh = mesh_of(meshes, side);
  if (base.positions().empty() || mesh.positions().empty()) return false;
  return base.positions()[base.origin(corner[Side::Base]).value] != mesh.positions()[mesh.origin(corner[side]).value];
}

/// What a side did at a vertex of the base.
struct VertexChange {
  bool used = false, changed = false, moved = false;
};

PerVertex<VertexChange> vertex_changes(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions,
                                       Side side) {
  const Mesh& base = mesh_of(meshes, Side::Base);
  PerVertex<VertexChange> changes(base.vertex_count());
  for (std::uint32_t c = 0; c < cells.corners.size(); ++c) {
    const InThree<HalfedgeId>& corner = cells.corners[c];
    if (!corner[Side::Base].valid()) continue;
    VertexChange& change = changes[base.origin(corner[Side::Base])];
    if (std::exchange(change.used, true)) continue;  // where nothing is changed, all its corners say the same
    change.changed = junctions.at(c).by(side);
    if (!change.changed) change.moved = is_elsewhere(meshes, side, corner);
  }
  return changes;
}

/// In the middle of these vertices.
Point centre_of(const Mesh& mesh, const std::vector<VertexId>& vertices) {
  Point centre = {};
  if (mesh.positions().empty()) return centre;
  for (const VertexId v : vertices) {
    for (std::size_t k = 0; k < 3; ++k) {
      centre[k] += mesh.positions()[v.value][k] / static_cast<double>(vertices.size());
    }
  }
  return centre;
}

/// What building a mesh finds of itself.
std::map<DepartureKind, std::size_t> departures_of(const Mesh& mesh) {
  std::map<DepartureKind, std::size_t> counts;
  for (const Seam& seam : mesh.seams()) {
    ++counts[seam.kind == SeamKind::NonManifold ? DepartureKind::NonManifoldEdge
             : seam.kind == SeamKind::Winding   ? DepartureKind::InconsistentWinding
                                                : DepartureKind::DegenerateFace];
  }
  if (!mesh.split_vertices().empty()) counts[DepartureKind::DisconnectedVertex] = mesh.split_vertices().size();
  return counts;
}

}  // namespace

SideChanges changes_of(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions, Side side) {
  SideChanges changes;
  for (const InThree<FaceId>& faces : cells.faces) {
    const bool before = faces[Side::Base].valid(), after = faces[side].valid();
    changes.matched_faces += before && after ? 1 : 0;
    changes.removed_faces += before && !after ? 1 : 0;
    changes.added_faces += !before && after ? 1 : 0;
  }
  for (const VertexChange& change : vertex_changes(meshes, cells, junctions, side)) {
    changes.changed_vertices += change.changed ? 1 : 0;
    changes.moved_vertices += change.moved ? 1 : 0;
  }
  return changes;
}

std::vector<ConflictArea> conflict_areas(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions,
                                         const Layout& layout, const Mesh& result) {
  std::vector<ConflictArea> areas(junctions.areas);
  for (std::uint32_t c = 0; c < cells.corners.size(); ++c) {
    const HalfedgeId h = cells.corners[c][Side::Base];
    if (!junctions.at(c).in_conflict() || !h.valid()) continue;
    areas[junctions.at(c).area].base_vertices.push_back(mesh_of(meshes, Side::Base).origin(h));
  }
  for (std::size_t cell = 0; cell < cells.faces.size(); ++cell) {
    const InThree<FaceId>& faces = cells.faces[cell];
    const Junction& junction = junctions.at(cells.first_corner[cell]);
    if (!junction.in_conflict() || faces[Side::Ours].valid() == faces[Side::Theirs].valid()) continue;
    ConflictArea& area = areas[junction.area];
    if (faces[Side::Base].valid()) {
      area.base_faces.push_back(faces[Side::Base]);
    } else if (faces[Side::Ours].valid()) {
      area.ours_faces.push_back(faces[Side::Ours]);
    } else {
      area.theirs_faces.push_back(faces[Side::Theirs]);
    }
  }
  for (std::uint32_t v = 0; v < layout.vertices.size(); ++v) {
    const std::uint32_t j = layout.vertices[v].junction;
    if (j == MergedVertex::kNoJunction || !junctions.list[j].in_conflict()) continue;
    areas[junctions.list[j].area].merged_vertices.emplace_back(v);
  }
  for (ConflictArea& area : areas) {
    sort_and_unite(area.base_vertices);
    sort_and_unite(area.base_faces);
    const bool in_base = !area.base_vertices.empty();
    area.centre =
        in_base ? centre_of(mesh_of(meshes, Side::Base), area.base_vertices) : centre_of(result, area.merged_vertices);
  }
  return areas;
}

std::vector<DoubtfulPart> doubtful_parts(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions,
                                         Side side, const Match& match) {
  constexpr double kConfident = 0.6;  // below, a region is rarely right (docs/design/007-belief.md)
  const Mesh& base = mesh_of(meshes, Side::Base);
  std::vector<DoubtfulPart> parts;
  PerVertex<VertexChange> changes;
  for (std::size_t r = 0; r < match.regions.size(); ++r) {
    const Region& region = match.regions[r];
    const double confidence = region.evidence.confidence();
    if (region.orientation != Orientation::Preserving || (!region.ambiguous && confidence >= kConfident)) continue;
    if (changes.size() == 0) changes = vertex_changes(meshes, cells, junctions, other(side));
    const bool concerned = std::any_of(region.faces.begin(), region.faces.end(), [&](const FacePair& pair) {
      const HalfedgeRange corners = base.halfedges(pair.source);
      return std::any_of(corners.begin(), corners.end(), [&](HalfedgeId h) {
        const VertexChange& change = changes[base.origin(h)];
        return change.changed || change.moved;
      });
    });
    if (!concerned) continue;
    parts.push_back({side, r, static_cast<std::uint32_t>(region.faces.size()), region.faces.front().source,
                     region.faces.front().target, region.ambiguous, region.ways, confidence});
  }
  return parts;
}

std::vector<DepartureKind> new_departures(const ThreeMeshes& meshes, const Mesh& result) {
  const std::map<DepartureKind, std::size_t> counts = departures_of(result);
  std::array<std::map<DepartureKind, std::size_t>, 3> before;
  for (std::size_t k = 0; k < before.size() && !counts.empty(); ++k) before[k] = departures_of(*meshes[k]);
  std::vector<DepartureKind> kinds;
  for (const auto& [kind, count] : counts) {
    const std::size_t base = before[0][kind], ours = before[1][kind], theirs = before[2][kind];
    const std::size_t both = ours + theirs > base ? ours + theirs - base : 0;  // each side's own ones
    if (count > std::max({base, ours, theirs, both})) kinds.push_back(kind);
  }
  return kinds;
}

}  // namespace quadmatch::use
