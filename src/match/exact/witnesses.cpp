#include "witnesses.hpp"

#include <algorithm>

namespace quadmatch::exact {

Witnesses::Witnesses(const Partial& partial, const FacesAt& faces_at)
    : partial_(partial),
      faces_at_(faces_at),
      seams_(!partial.mesh(kSource).seams().empty() || !partial.mesh(kTarget).seams().empty()) {}

/// Is a face open at this corner, beside its own?
bool Witnesses::may_be_touched(Side side, HalfedgeId corner) const {
  const Mesh& mesh = partial_.mesh(side);
  const auto around = faces_at_.of(side, mesh.origin(corner));
  return std::any_of(around.begin(), around.end(),
                     [&](FaceId face) { return face != mesh.face(corner) && partial_.is_open(side, face); });
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
