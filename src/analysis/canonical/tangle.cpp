#include "tangle.hpp"

#include <algorithm>

namespace quadmatch::canonical {
namespace {

/// Number the pieces by their first half-edge, and list what leaves each vertex. @pre prev, twin and origin are there.
void finish(Tangle& tangle) {
  const std::uint32_t count = tangle.halfedge_count();
  tangle.piece.assign(count, Tangle::kNone);
  std::vector<std::uint32_t> reached;
  for (std::uint32_t first = 0; first < count; ++first) {
    if (tangle.piece[first] != Tangle::kNone) continue;
    const auto reach = [&](std::uint32_t h) {
      if (h == Tangle::kNone || tangle.piece[h] != Tangle::kNone) return;
      tangle.piece[h] = tangle.pieces;
      reached.push_back(h);
    };
    reached.clear();
    reach(first);
    for (std::size_t here = 0; here < reached.size(); ++here) {
      reach(tangle.prev[reached[here]]);
      reach(tangle.twin[reached[here]]);
    }
    ++tangle.pieces;
  }

  tangle.leaving_first.assign(tangle.vertices.size() + 1, 0);
  for (const std::uint32_t v : tangle.origin) {
    if (v != Tangle::kNone) ++tangle.leaving_first[v - count + 1];
  }
  for (std::size_t v = 0; v < tangle.vertices.size(); ++v) tangle.leaving_first[v + 1] += tangle.leaving_first[v];
  tangle.leaving.resize(tangle.leaving_first.back());
  std::vector<std::uint32_t> filled(tangle.leaving_first.begin(), tangle.leaving_first.end() - 1);
  for (std::uint32_t h = 0; h < count; ++h) {
    if (tangle.origin[h] != Tangle::kNone) tangle.leaving[filled[tangle.origin[h] - count]++] = h;
  }
}

}  // namespace

Tangle tangle_of(const Mesh& mesh, std::span<const FaceId> faces) {
  Tangle tangle;
  for (const FaceId face : faces) {
    for (const HalfedgeId h : mesh.halfedges(face)) {
      tangle.halfedges.push_back(h);
      tangle.vertices.push_back(mesh.origin(h));
    }
  }
  std::sort(tangle.halfedges.begin(), tangle.halfedges.end());
  std::sort(tangle.vertices.begin(), tangle.vertices.end());
  tangle.vertices.erase(std::unique(tangle.vertices.begin(), tangle.vertices.end()), tangle.vertices.end());
  const auto place = [](const auto& sorted, auto id) {
    return static_cast<std::uint32_t>(std::lower_bound(sorted.begin(), sorted.end(), id) - sorted.begin());
  };
  for (const HalfedgeId h : tangle.halfedges) {
    const HalfedgeId other = mesh.twin(h);
    tangle.prev.push_back(place(tangle.halfedges, mesh.prev(h)));
    tangle.twin.push_back(other.valid() ? place(tangle.halfedges, other) : Tangle::kNone);
    tangle.origin.push_back(tangle.halfedge_count() + place(tangle.vertices, mesh.origin(h)));
  }
  finish(tangle);
  return tangle;
}

Tangle part_of(const Tangle& tangle, std::span<const std::uint32_t> halfedges, const std::vector<bool>& keeps_vertex,
               std::vector<std::uint32_t>& elements) {
  elements.assign(halfedges.begin(), halfedges.end());
  for (const std::uint32_t h : halfedges) {
    const std::uint32_t v = tangle.origin[h];
    if (v != Tangle::kNone && keeps_vertex[v]) elements.push_back(v);
  }
  // Vertices come after the half-edges, here as there.
  std::sort(elements.begin(), elements.end());
  elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
  const auto place = [&elements](std::uint32_t element) {
    const auto found = std::lower_bound(elements.begin(), elements.end(), element);
    return found != elements.end() && *found == element ? static_cast<std::uint32_t>(found - elements.begin())
                                                        : Tangle::kNone;
  };
  Tangle part;
  for (const std::uint32_t element : elements) {
    if (tangle.is_vertex(element)) {
      part.vertices.push_back(tangle.vertices[element - tangle.halfedge_count()]);
      continue;
    }
    part.halfedges.push_back(tangle.halfedges[element]);
    part.prev.push_back(place(tangle.prev[element]));
    part.twin.push_back(tangle.twin[element] == Tangle::kNone ? Tangle::kNone : place(tangle.twin[element]));
    part.origin.push_back(tangle.origin[element] == Tangle::kNone ? Tangle::kNone : place(tangle.origin[element]));
  }
  finish(part);
  return part;
}

}  // namespace quadmatch::canonical
