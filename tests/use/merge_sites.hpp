#pragma once
/// The same edit at the same place of a mesh and of an edited copy of it: the truth that merges are held against.

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/random.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch::test {

enum class EditKind { Delete, Extrude, Loop, Unloop, Twist, Rip, Refine, Collapse, Handle };
inline constexpr std::uint32_t kEditKinds = 9;

inline const char* name_of(EditKind kind) {
  constexpr const char* kNames[] = {"delete", "extrude", "loop",     "unloop", "twist",
                                    "rip",    "refine",  "collapse", "handle"};
  return kNames[static_cast<std::size_t>(kind)];
}

/// An edit at a place, by half-edges of the mesh it is meant for.
struct Site {
  EditKind kind = EditKind::Delete;
  HalfedgeId at, other;

  [[nodiscard]] std::string name() const { return name_of(kind) + (" at " + to_string(at)); }
};

inline Site random_site(const Mesh& mesh, shapes::Random& random) {
  return {static_cast<EditKind>(random.below(kEditKinds)), HalfedgeId(random.below(mesh.halfedge_count())),
          HalfedgeId(random.below(mesh.halfedge_count()))};
}

inline Expected<shapes::Edit> made(const PolygonSoup& soup, const Mesh& mesh, const Site& site) {
  switch (site.kind) {
    case EditKind::Delete:
      return shapes::delete_patch(soup, mesh.face(site.at), 8);
    case EditKind::Extrude:
      return shapes::extrude_patch(soup, mesh.face(site.at), 6, 0.05);
    case EditKind::Loop:
      return shapes::insert_edge_loop(soup, site.at);
    case EditKind::Unloop:
      return shapes::remove_edge_loop(soup, site.at);
    case EditKind::Twist:
      return shapes::twist_ring(soup, site.at, 1);
    case EditKind::Rip:
      return shapes::rip_edges(soup, site.at, 4);
    case EditKind::Refine:
      return shapes::refine_patch(soup, mesh.face(site.at), 4);
    case EditKind::Collapse:
      return shapes::collapse_quad(soup, site.at);
    case EditKind::Handle:
      break;
  }
  return shapes::add_handle(soup, mesh.face(site.at), mesh.face(site.other));
}

/// A mesh and how it came from another; surviving faces keep their first corners.
class Edited {
 public:
  explicit Edited(const PolygonSoup& soup) : soup_(soup), mesh_(build(soup)) {
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) truth_.push_back({FaceId(f), FaceId(f), 0});
  }

  [[nodiscard]] const PolygonSoup& soup() const { return soup_; }
  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

  /// Edit it at a place of the mesh it came from. False where the place is gone or the edit does not fit.
  [[nodiscard]] bool apply(const Mesh& base, Site site) {
    site.at = now(base, site.at);
    site.other = now(base, site.other);
    if (!site.at.valid() || (site.kind == EditKind::Handle && !site.other.valid())) return false;
    Expected<shapes::Edit> edit = made(soup_, mesh_, site);
    if (!edit) return false;
    truth_ = shapes::chained(truth_, edit->truth, edit->soup);
    soup_ = std::move(edit->soup);
    mesh_ = build(soup_);
    return true;
  }

  /// The vertices of the mesh it came from whose faces are others now, or joined in another way.
  [[nodiscard]] std::vector<bool> touched(const Mesh& base) const {
    std::vector<VertexId> image(base.vertex_count()), origin(mesh_.vertex_count());
    std::vector<bool> touched(base.vertex_count(), false), seen_here(mesh_.halfedge_count(), false);
    std::vector<bool> seen(base.halfedge_count(), false);
    for (const FacePair& pair : truth_) {
      for (std::uint32_t k = 0; k < base.size(pair.source); ++k) {
        const HalfedgeId there(base.first(pair.source).value + k), here(mesh_.first(pair.target).value + k);
        const VertexId v = base.origin(there), w = mesh_.origin(here);
        seen[there.value] = seen_here[here.value] = true;
        if (!image[v.value].valid()) image[v.value] = w;
        if (!origin[w.value].valid()) origin[w.value] = v;
        if (image[v.value] != w) touched[v.value] = true;
        if (origin[w.value] != v) touched[v.value] = touched[origin[w.value].value] = true;
      }
    }
    for (std::uint32_t h = 0; h < base.halfedge_count(); ++h) {
      if (!seen[h]) touched[base.origin(HalfedgeId(h)).value] = true;
    }
    for (std::uint32_t h = 0; h < mesh_.halfedge_count(); ++h) {
      const VertexId v = seen_here[h] ? VertexId() : origin[mesh_.origin(HalfedgeId(h)).value];
      if (v.valid()) touched[v.value] = true;
    }
    return touched;
  }

 private:
  [[nodiscard]] HalfedgeId now(const Mesh& base, HalfedgeId there) const {
    const FaceId face = base.face(there);
    const auto pair = std::lower_bound(truth_.begin(), truth_.end(), face,
                                       [](const FacePair& p, FaceId source) { return p.source < source; });
    if (pair == truth_.end() || pair->source != face) return {};
    return HalfedgeId(mesh_.first(pair->target).value + base.corner(there));
  }

  PolygonSoup soup_;
  Mesh mesh_;
  std::vector<FacePair> truth_;  ///< ascending by source
};

/// And all vertices that share a face with one of them.
inline std::vector<bool> widened(const Mesh& mesh, const std::vector<bool>& vertices) {
  std::vector<bool> wider = vertices;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const HalfedgeRange corners = mesh.halfedges(FaceId(f));
    if (std::none_of(corners.begin(), corners.end(), [&](HalfedgeId h) { return vertices[mesh.origin(h).value]; })) {
      continue;
    }
    for (const HalfedgeId h : corners) wider[mesh.origin(h).value] = true;
  }
  return wider;
}

inline bool meet(const std::vector<bool>& a, const std::vector<bool>& b) {
  for (std::size_t v = 0; v < a.size(); ++v) {
    if (a[v] && b[v]) return true;
  }
  return false;
}

}  // namespace quadmatch::test
