// Edits of a few faces: a slit, a patch split finer, a handle between two quads.

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/shapes/edit.hpp>

#include "edit_support.hpp"
#include "redraft.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

/// The edges of a slit that starts along a half-edge and goes on past the second edge to the right of where it comes
/// from, which is straight on where the vertex is regular.
Expected<std::vector<HalfedgeId>> slit_from(const Mesh& mesh, HalfedgeId start, std::uint32_t length) {
  std::vector<HalfedgeId> slit;
  std::set<VertexId> passed;
  HalfedgeId h = start;
  while (true) {
    if (!is_inside(mesh, h)) return does_not_fit(to_string(mesh.origin(h)) + " is not inside the surface");
    if (!passed.insert(mesh.origin(h)).second) return does_not_fit("the slit meets " + to_string(mesh.origin(h)));
    if (slit.size() == length) return slit;
    slit.push_back(h);
    const HalfedgeId beyond = mesh.twin(mesh.next(h));
    if (!beyond.valid()) return does_not_fit(to_string(mesh.tip(h)) + " is not inside the surface");
    h = mesh.next(beyond);
  }
}

/// New vertices in the middle of edges, one for each edge.
class Middles {
 public:
  explicit Middles(Redraft& draft) : draft_(draft) {}

  VertexId of(const Mesh& mesh, HalfedgeId h) {
    VertexId& middle = made_[std::minmax(mesh.origin(h), mesh.tip(h))];
    if (!middle.valid()) middle = draft_.add_vertex({mesh.origin(h), mesh.tip(h)});
    return middle;
  }
  [[nodiscard]] VertexId find(const Mesh& mesh, HalfedgeId h) const {
    const auto found = made_.find(std::minmax(mesh.origin(h), mesh.tip(h)));
    return found == made_.end() ? VertexId() : found->second;
  }

 private:
  Redraft& draft_;
  std::map<std::pair<VertexId, VertexId>, VertexId> made_;
};

/// The corners of a face with the new vertices on its sides.
std::vector<VertexId> with_middles(const Mesh& mesh, FaceId face, const Middles& middles) {
  std::vector<VertexId> corners;
  for (const HalfedgeId h : mesh.halfedges(face)) {
    corners.push_back(mesh.origin(h));
    if (const VertexId middle = middles.find(mesh, h); middle.valid()) corners.push_back(middle);
  }
  return corners;
}

void split_in_four(const Mesh& mesh, FaceId face, Middles& middles, Redraft& draft) {
  const HalfedgeId h = mesh.first(face);
  const HalfedgeId sides[4] = {h, mesh.next(h), mesh.next(mesh.next(h)), mesh.prev(h)};
  const VertexId centre =
      draft.add_vertex({mesh.origin(sides[0]), mesh.origin(sides[1]), mesh.origin(sides[2]), mesh.origin(sides[3])});
  for (std::size_t k = 0; k < 4; ++k) {
    draft.add({mesh.origin(sides[k]), middles.of(mesh, sides[k]), centre, middles.of(mesh, sides[(k + 3) % 4])});
  }
}

}  // namespace

Expected<Edit> rip_edges(const PolygonSoup& soup, HalfedgeId start, std::uint32_t length) {
  const Expected<Mesh> mesh = build_with_halfedge(soup, start);
  if (!mesh) return Unexpected(mesh.error());
  if (length < 2) return does_not_fit("a slit of one edge opens nothing");
  const Expected<std::vector<HalfedgeId>> slit = slit_from(*mesh, start, length);
  if (!slit) return Unexpected(slit.error());

  Redraft draft(soup);
  std::vector<VertexId> corners(soup.corners);
  for (std::size_t k = 1; k < slit->size(); ++k) {
    // The faces left of the slit, from the one before the edge it leaves by to the one behind the edge it comes by.
    const VertexId copy = draft.add_vertex({mesh->origin((*slit)[k])});
    const HalfedgeId last = mesh->next((*slit)[k - 1]);
    for (HalfedgeId h = (*slit)[k];; h = mesh->rotate_ccw(h)) {
      corners[h.value] = copy;
      if (h == last) break;
    }
  }
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    draft.keep(FaceId(f), std::span(corners).subspan(first_corner(soup, f), mesh->size(FaceId(f))));
  }
  return draft.finish();
}

Expected<Edit> refine_patch(const PolygonSoup& soup, FaceId centre, std::uint32_t count) {
  const Expected<Mesh> mesh = build_with_face(soup, centre);
  if (!mesh) return Unexpected(mesh.error());
  if (mesh->size(centre) != 4) return does_not_fit(to_string(centre) + " is not a quad");
  std::vector<bool> members = patch_around(*mesh, centre, count);
  for (std::uint32_t f = 0; f < members.size(); ++f) members[f] = members[f] && mesh->size(FaceId(f)) == 4;

  Redraft draft(soup);
  Middles middles(draft);
  for (std::uint32_t f = 0; f < members.size(); ++f) {
    if (!members[f]) continue;
    for (const HalfedgeId h : mesh->halfedges(FaceId(f))) middles.of(*mesh, h);
  }
  std::vector<std::vector<VertexId>> grown;  // neighbours, which get more corners
  for (std::uint32_t f = 0; f < members.size(); ++f) {
    if (members[f]) continue;
    std::vector<VertexId> corners = with_middles(*mesh, FaceId(f), middles);
    if (corners.size() == mesh->size(FaceId(f))) {
      draft.keep(FaceId(f));
    } else {
      grown.push_back(std::move(corners));
    }
  }
  for (const std::vector<VertexId>& corners : grown) draft.add(corners);
  for (std::uint32_t f = 0; f < members.size(); ++f) {
    if (members[f]) split_in_four(*mesh, FaceId(f), middles, draft);
  }
  return draft.finish();
}

Expected<Edit> add_handle(const PolygonSoup& soup, FaceId one, FaceId other) {
  const Expected<Mesh> mesh = build_with_face(soup, std::max(one, other));
  if (!mesh) return Unexpected(mesh.error());
  const auto a = corners_of(soup, one.value), b = corners_of(soup, other.value);
  for (const FaceId f : {one, other}) {
    if (mesh->size(f) != 4) return does_not_fit(to_string(f) + " is not a quad");
  }
  if (std::find_first_of(a.begin(), a.end(), b.begin(), b.end()) != a.end()) {
    return does_not_fit(to_string(one) + " and " + to_string(other) + " share a vertex");
  }
  Redraft draft(soup);
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    if (FaceId(f) != one && FaceId(f) != other) draft.keep(FaceId(f));
  }
  for (std::size_t k = 0; k < 4; ++k) draft.add({a[k], a[(k + 1) % 4], b[(7 - k) % 4], b[(4 - k) % 4]});
  return as_clean_as_before(*mesh, draft.finish());
}

}  // namespace quadmatch::shapes
