#include <quadmatch/shapes/edit.hpp>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <string>

#include <quadmatch/mesh/mesh.hpp>

#include "edit_support.hpp"
#include "geometry.hpp"
#include "redraft.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

/// The mean normal of the patch (Newell's formula), of unit length; zero where the soup is flat or has no positions.
Point mean_normal(const PolygonSoup& soup, const std::vector<bool>& members) {
  Point sum = {};
  if (soup.positions.empty()) return sum;
  for (std::uint32_t f = 0; f < members.size(); ++f) {
    if (!members[f]) continue;
    const auto corners = corners_of(soup, f);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      sum = sum + cross(soup.positions[corners[k].value], soup.positions[corners[(k + 1) % corners.size()].value]);
    }
  }
  return dot(sum, sum) > 0 ? normalized(sum) : sum;
}

/// The half-edges of the patch that the rest of the mesh is beyond.
std::vector<HalfedgeId> rim_of(const Mesh& mesh, const std::vector<bool>& members) {
  std::vector<HalfedgeId> rim;
  for (std::uint32_t f = 0; f < members.size(); ++f) {
    if (!members[f]) continue;
    for (const HalfedgeId h : mesh.halfedges(FaceId(f))) {
      if (!mesh.twin(h).valid() || !members[mesh.face(mesh.twin(h)).value]) rim.push_back(h);
    }
  }
  return rim;
}

/// The vertices that an edge joins to the origin of a half-edge, around its fan. @pre an inner fan.
std::set<VertexId> neighbours(const Mesh& mesh, HalfedgeId from) {
  std::set<VertexId> found;
  for (const HalfedgeId h : mesh.outgoing(mesh.fan(from))) found.insert(mesh.tip(h));
  return found;
}

/// How many faces around the origin of one half-edge also have that of another as a corner. @pre inner fans.
std::ptrdiff_t faces_with_both(const Mesh& mesh, HalfedgeId here, HalfedgeId there) {
  const auto has_other = [&](HalfedgeId outgoing) {
    const HalfedgeRange corners = mesh.halfedges(mesh.face(outgoing));
    return std::any_of(corners.begin(), corners.end(),
                       [&](HalfedgeId h) { return mesh.origin(h) == mesh.origin(there); });
  };
  std::ptrdiff_t count = 0;
  for (const HalfedgeId h : mesh.outgoing(mesh.fan(here))) count += has_other(h) ? 1 : 0;
  return count;
}

/// Why the quad cannot be collapsed so that the corner meets the opposite one, if it cannot.
std::optional<std::string> obstacle_to_collapse(const Mesh& mesh, HalfedgeId corner) {
  const FaceId face = mesh.face(corner);
  if (mesh.size(face) != 4) return to_string(face) + " is not a quad";
  for (const HalfedgeId h : mesh.halfedges(face)) {
    if (!is_inside(mesh, h)) return to_string(mesh.origin(h)) + " is not inside the surface";
  }
  const HalfedgeId side = mesh.next(corner), opposite = mesh.next(side), other_side = mesh.next(opposite);
  for (const HalfedgeId h : {side, other_side}) {
    if (mesh.valence(mesh.fan(h)) < 4) return to_string(mesh.origin(h)) + " would be left with two faces";
  }
  const std::set<VertexId> here = neighbours(mesh, corner), there = neighbours(mesh, opposite);
  std::vector<VertexId> common;
  std::set_intersection(here.begin(), here.end(), there.begin(), there.end(), std::back_inserter(common));
  if (common.size() != 2 || here.count(mesh.origin(opposite)) > 0 || faces_with_both(mesh, corner, opposite) != 1) {
    return to_string(mesh.origin(corner)) + " and " + to_string(mesh.origin(opposite)) + " meet elsewhere too";
  }
  return std::nullopt;
}

}  // namespace

Expected<Edit> delete_patch(const PolygonSoup& soup, FaceId centre, std::uint32_t count) {
  const Expected<Mesh> mesh = build_with_face(soup, centre);
  if (!mesh) return Unexpected(mesh.error());
  const std::vector<bool> members = patch_around(*mesh, centre, count);
  if (std::find(members.begin(), members.end(), false) == members.end()) return does_not_fit("no face would be left");
  Redraft draft(soup);
  for (std::uint32_t f = 0; f < members.size(); ++f) {
    if (!members[f]) draft.keep(FaceId(f));
  }
  return draft.finish();
}

Expected<Edit> extrude_patch(const PolygonSoup& soup, FaceId centre, std::uint32_t count, double height) {
  const Expected<Mesh> mesh = build_with_face(soup, centre);
  if (!mesh) return Unexpected(mesh.error());
  const std::vector<bool> members = patch_around(*mesh, centre, count);
  const std::vector<HalfedgeId> rim = rim_of(*mesh, members);
  if (rim.empty()) return does_not_fit("the patch is a whole component and has no rim");

  Redraft draft(soup);
  std::vector<VertexId> lifted(soup.vertex_count);  // the copy of each rim vertex
  for (const HalfedgeId h : rim) {
    VertexId& copy = lifted[mesh->origin(h).value];
    if (copy.valid()) return does_not_fit("the rim of the patch passes " + to_string(mesh->origin(h)) + " twice");
    copy = draft.add_vertex({mesh->origin(h)});
  }
  std::set<VertexId> top;
  for (std::uint32_t f = 0; f < members.size(); ++f) {
    const auto corners = corners_of(soup, f);
    std::vector<VertexId> renamed(corners.begin(), corners.end());
    if (members[f]) {
      for (VertexId& v : renamed) v = lifted[v.value].valid() ? lifted[v.value] : v;
      top.insert(renamed.begin(), renamed.end());
    }
    draft.keep(FaceId(f), renamed);
  }
  const Point up = height * mean_normal(soup, members);
  for (const VertexId v : top) draft.move_vertex(v, up);
  for (const HalfedgeId h : rim) {
    const VertexId from = mesh->origin(h), to = mesh->tip(h);
    draft.add({from, to, lifted[to.value], lifted[from.value]});
  }
  return draft.finish();
}

Expected<Edit> collapse_quad(const PolygonSoup& soup, HalfedgeId corner) {
  const Expected<Mesh> mesh = build_with_halfedge(soup, corner);
  if (!mesh) return Unexpected(mesh.error());
  if (const auto obstacle = obstacle_to_collapse(*mesh, corner)) return does_not_fit(*obstacle);

  Redraft draft(soup);
  const VertexId kept = mesh->origin(corner), merged = mesh->origin(mesh->next(mesh->next(corner)));
  draft.move_halfway(kept, merged);
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    if (FaceId(f) == mesh->face(corner)) continue;
    const auto corners = corners_of(soup, f);
    std::vector<VertexId> renamed(corners.begin(), corners.end());
    std::replace(renamed.begin(), renamed.end(), merged, kept);
    draft.keep(FaceId(f), renamed);
  }
  return draft.finish();
}

std::vector<FacePair> chained(const std::vector<FacePair>& first, const std::vector<FacePair>& second,
                              const PolygonSoup& target) {
  std::vector<FacePair> both;
  for (const FacePair& pair : first) {
    const auto after = std::lower_bound(second.begin(), second.end(), pair.target,
                                        [](const FacePair& p, FaceId source) { return p.source < source; });
    if (after == second.end() || after->source != pair.target) continue;
    const auto size = static_cast<std::uint32_t>(corners_of(target, after->target.value).size());
    both.push_back({pair.source, after->target, (pair.rotation + after->rotation) % size});
  }
  return both;
}

}  // namespace quadmatch::shapes
