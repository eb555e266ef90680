#include "edit_support.hpp"

#include <algorithm>
#include <utility>

#include <quadmatch/mesh/check.hpp>

namespace quadmatch::shapes {

Unexpected<Error> does_not_fit(std::string message) {
  return Unexpected(Error{ErrorCode::BadArgument, std::move(message)});
}

Expected<Mesh> build_with_face(const PolygonSoup& soup, FaceId face) {
  Expected<Mesh> mesh = Mesh::build(soup);
  if (mesh && face.value >= mesh->face_count()) return does_not_fit("there is no face " + to_string(face));
  return mesh;
}

Expected<Mesh> build_with_halfedge(const PolygonSoup& soup, HalfedgeId halfedge) {
  Expected<Mesh> mesh = Mesh::build(soup);
  if (mesh && halfedge.value >= mesh->halfedge_count()) {
    return does_not_fit("there is no half-edge " + to_string(halfedge));
  }
  return mesh;
}

std::vector<bool> patch_around(const Mesh& mesh, FaceId centre, std::uint32_t count) {
  std::vector<bool> members(mesh.face_count(), false);
  std::vector<FaceId> queue = {centre};
  members[centre.value] = true;
  for (std::size_t burning = 0; burning < queue.size(); ++burning) {
    for (const HalfedgeId h : mesh.halfedges(queue[burning])) {
      const HalfedgeId beyond = mesh.twin(h);
      if (!beyond.valid() || queue.size() >= count || members[mesh.face(beyond).value]) continue;
      members[mesh.face(beyond).value] = true;
      queue.push_back(mesh.face(beyond));
    }
  }
  return members;
}

bool is_inside(const Mesh& mesh, HalfedgeId corner) {
  const auto split = mesh.split_vertices();
  return !mesh.is_boundary(mesh.fan(corner)) && !std::binary_search(split.begin(), split.end(), mesh.origin(corner));
}

Expected<Edit> as_clean_as_before(const Mesh& before, Edit edit) {
  if (edit.soup.corners.empty()) return does_not_fit("no face would be left");
  const Expected<Mesh> after = Mesh::build(edit.soup);
  if (!after) return Unexpected(after.error());
  const CheckReport old = check(before, 0), now = check(*after, 0);
  for (std::size_t kind = 0; kind < now.departure_counts.size(); ++kind) {
    if (now.departure_counts[kind] <= old.departure_counts[kind]) continue;
    return does_not_fit(std::string("the result would not be well-formed: ") + to_string(DepartureKind(kind)));
  }
  return edit;
}

}  // namespace quadmatch::shapes
