// Edits along a poly-chord: an edge loop inserted, one removed, a ring turned.

#include <algorithm>
#include <optional>
#include <string>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/shapes/edit.hpp>

#include "edit_support.hpp"
#include "redraft.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

/// A poly-chord: the half-edges by which it enters its quads, in order.
struct Chord {
  std::vector<HalfedgeId> entries;
  bool closed = false;
};

/// Where the chord goes on behind the quad it entered by `entry`; not valid at the boundary.
/// @pre the face is a quad.
HalfedgeId entry_beyond(const Mesh& mesh, HalfedgeId entry) { return mesh.twin(mesh.next(mesh.next(entry))); }

/// Follow the chord from an entry to the boundary, or once round. A sentence where it cannot be followed.
std::optional<std::string> follow(const Mesh& mesh, HalfedgeId start, std::vector<bool>& crossed, Chord& chord) {
  for (HalfedgeId entry = start; entry.valid(); entry = entry_beyond(mesh, entry)) {
    const FaceId face = mesh.face(entry);
    if (mesh.size(face) != 4) return "the loop runs into " + to_string(face) + ", which is not a quad";
    if (crossed[face.value]) {
      chord.closed = entry == start;
      if (chord.closed) return std::nullopt;
      return "the loop would cross " + to_string(face) + " twice";
    }
    crossed[face.value] = true;
    chord.entries.push_back(entry);
  }
  return std::nullopt;
}

/// Turn a chord round: it enters each quad by the other side.
void reverse(const Mesh& mesh, Chord& chord) {
  std::reverse(chord.entries.begin(), chord.entries.end());
  for (HalfedgeId& entry : chord.entries) entry = mesh.next(mesh.next(entry));
}

Expected<Chord> chord_across(const Mesh& mesh, HalfedgeId edge) {
  Chord chord;
  std::vector<bool> crossed(mesh.face_count(), false);
  std::optional<std::string> obstacle = follow(mesh, edge, crossed, chord);
  if (!obstacle && !chord.closed) {
    reverse(mesh, chord);
    obstacle = follow(mesh, mesh.twin(edge), crossed, chord);
  }
  if (obstacle) return does_not_fit(*obstacle);
  return chord;
}

/// The faces of a chord, as flags.
std::vector<bool> faces_of(const Mesh& mesh, const Chord& chord) {
  std::vector<bool> members(mesh.face_count(), false);
  for (const HalfedgeId entry : chord.entries) members[mesh.face(entry).value] = true;
  return members;
}

/// The vertices on both sides of a chord, in pairs across it: by each entry, and by the last exit of one that is open.
struct Rungs {
  std::vector<VertexId> near, far;
};

Rungs rungs_of(const Mesh& mesh, const Chord& chord) {
  Rungs rungs;
  for (const HalfedgeId entry : chord.entries) {
    rungs.near.push_back(mesh.origin(entry));
    rungs.far.push_back(mesh.tip(entry));
  }
  if (!chord.closed) {
    const HalfedgeId exit = mesh.next(mesh.next(chord.entries.back()));
    rungs.near.push_back(mesh.tip(exit));
    rungs.far.push_back(mesh.origin(exit));
  }
  return rungs;
}

/// A vertex that occurs twice among the rungs.
std::optional<VertexId> met_twice(const Rungs& rungs) {
  std::vector<VertexId> all = rungs.near;
  all.insert(all.end(), rungs.far.begin(), rungs.far.end());
  std::sort(all.begin(), all.end());
  const auto twice = std::adjacent_find(all.begin(), all.end());
  return twice == all.end() ? std::nullopt : std::optional(*twice);
}

}  // namespace

Expected<Edit> insert_edge_loop(const PolygonSoup& soup, HalfedgeId crossed) {
  const Expected<Mesh> mesh = build_with_halfedge(soup, crossed);
  if (!mesh) return Unexpected(mesh.error());
  const Expected<Chord> chord = chord_across(*mesh, crossed);
  if (!chord) return Unexpected(chord.error());

  Redraft draft(soup);
  const std::vector<bool> is_split = faces_of(*mesh, *chord);
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    if (!is_split[f]) draft.keep(FaceId(f));
  }
  const auto middle_of = [&](HalfedgeId h) { return draft.add_vertex({mesh->origin(h), mesh->tip(h)}); };
  const VertexId first = middle_of(chord->entries.front());
  VertexId near = first;
  for (const HalfedgeId entry : chord->entries) {
    const HalfedgeId exit = mesh->next(mesh->next(entry));
    const bool comes_round = chord->closed && entry == chord->entries.back();
    const VertexId far = comes_round ? first : middle_of(exit);
    draft.add({mesh->origin(entry), near, far, mesh->tip(exit)});
    draft.add({near, mesh->tip(entry), mesh->origin(exit), far});
    near = far;
  }
  return draft.finish();
}

Expected<Edit> remove_edge_loop(const PolygonSoup& soup, HalfedgeId crossed) {
  const Expected<Mesh> mesh = build_with_halfedge(soup, crossed);
  if (!mesh) return Unexpected(mesh.error());
  const Expected<Chord> chord = chord_across(*mesh, crossed);
  if (!chord) return Unexpected(chord.error());
  const Rungs rungs = rungs_of(*mesh, *chord);
  if (const auto twice = met_twice(rungs))
    return does_not_fit("the row of quads meets " + to_string(*twice) + " twice");

  Redraft draft(soup);
  std::vector<VertexId> image(soup.vertex_count);
  for (std::uint32_t v = 0; v < soup.vertex_count; ++v) image[v] = VertexId(v);
  for (std::size_t k = 0; k < rungs.near.size(); ++k) {
    image[rungs.far[k].value] = rungs.near[k];
    draft.move_halfway(rungs.near[k], rungs.far[k]);
  }
  const std::vector<bool> is_removed = faces_of(*mesh, *chord);
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    if (is_removed[f]) continue;
    const auto corners = corners_of(soup, f);
    std::vector<VertexId> renamed(corners.begin(), corners.end());
    for (VertexId& v : renamed) v = image[v.value];
    draft.keep(FaceId(f), renamed);
  }
  return as_clean_as_before(*mesh, draft.finish());
}

Expected<Edit> twist_ring(const PolygonSoup& soup, HalfedgeId crossed, std::uint32_t shift) {
  const Expected<Mesh> mesh = build_with_halfedge(soup, crossed);
  if (!mesh) return Unexpected(mesh.error());
  const Expected<Chord> chord = chord_across(*mesh, crossed);
  if (!chord) return Unexpected(chord.error());
  if (!chord->closed) return does_not_fit("the row of quads is no ring");
  const Rungs rungs = rungs_of(*mesh, *chord);
  if (const auto twice = met_twice(rungs)) return does_not_fit("the ring meets " + to_string(*twice) + " twice");
  const std::size_t count = rungs.near.size();
  if (count < 5) return does_not_fit("a ring of " + std::to_string(count) + " quads cannot be turned without folding");

  Redraft draft(soup);
  const std::vector<bool> is_removed = faces_of(*mesh, *chord);
  for (std::uint32_t f = 0; f < mesh->face_count(); ++f) {
    if (!is_removed[f]) draft.keep(FaceId(f));
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t after = (k + 1) % count;
    draft.add({rungs.near[k], rungs.far[(k + shift) % count], rungs.far[(after + shift) % count], rungs.near[after]});
  }
  return as_clean_as_before(*mesh, draft.finish());
}

}  // namespace quadmatch::shapes
