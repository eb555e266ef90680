#include "witnesses.hpp"

namespace quadmatch::exact {

Witnesses::Witnesses(const Partial& partial)
    : partial_(partial), seams_(!partial.mesh(kSource).seams().empty() || !partial.mesh(kTarget).seams().empty()) {
  for (const Side side : {kSource, kTarget}) {
    const Mesh& mesh = partial.mesh(side);
    std::vector<std::uint32_t>& first = first_at_[side];
    first.assign(mesh.vertex_count() + 1, 0);
    for (const VertexId v : mesh.corners()) ++first[v.value + 1];
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) first[v + 1] += first[v];
    faces_at_[side].resize(mesh.halfedge_count());
    std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
    for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
      faces_at_[side][next[mesh.origin(HalfedgeId(h)).value]++] = mesh.face(HalfedgeId(h));
    }
  }
}

/// Is a face open at this corner, beside its own?
bool Witnesses::may_be_touched(Side side, HalfedgeId corner) const {
  const Mesh& mesh = partial_.mesh(side);
  const std::uint32_t v = mesh.origin(corner).value;
  for (std::uint32_t k = first_at_[side][v]; k < first_at_[side][v + 1]; ++k) {
    const FaceId face = faces_at_[side][k];
    if (face != mesh.face(corner) && partial_.is_open(side, face)) return true;
  }
  return false;
}

Witnesses::Answer Witnesses::against(const Pair& pair) const {
  if (!partial_.agrees(pair)) return Answer::Found;
  if (seams_) return Answer::Possible;
  auto [s, t] = pair;
  do {
    const bool mapped = partial_.partner(kSource, partial_.mesh(kSource).origin(s)).valid();
    if (!mapped && (may_be_touched(kSource, s) || may_be_touched(kTarget, t))) return Answer::Possible;
    s = partial_.mesh(kSource).next(s);
    t = partial_.mesh(kTarget).next(t);
  } while (s != pair.source);
  return Answer::Impossible;
}

Pair Witnesses::nearby(const Pair& pair, const Rim& rim) const {
  const Mesh& source = partial_.mesh(kSource);
  const Mesh& target = partial_.mesh(kTarget);
  const auto has_corner = [](const Mesh& mesh, FaceId face, VertexId v) {
    for (const HalfedgeId h : mesh.halfedges(face)) {
      if (mesh.origin(h) == v) return true;
    }
    return false;
  };
  auto [s, t] = pair;
  do {
    if (!partial_.partner(kSource, source.origin(s)).valid()) {
      for (const Pair& inside : rim) {
        const Pair next = beyond(partial_, inside);
        if (has_corner(source, source.face(next.source), source.origin(s)) ||
            has_corner(target, target.face(next.target), target.origin(t))) {
          return next;
        }
      }
    }
    s = source.next(s);
    t = target.next(t);
  } while (s != pair.source);
  return {};
}

}  // namespace quadmatch::exact
