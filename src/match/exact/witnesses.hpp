#pragma once
/// Only regions that cannot be extended are of interest: what is left out of one must clash with something in it.

#include "faces_at.hpp"
#include "partial.hpp"

namespace quadmatch::exact {

/// If a pair beyond the rim is left out of a region and fits it, the region with it is larger and is searched too. So
/// some pair of the region clashes with it: the witness. It has a face at a corner of one of its two faces, and gives
/// the vertex there another partner; at a vertex that has its partner already there can be none.
class Witnesses {
 public:
  Witnesses(const Partial& partial, const FacesAt& faces_at);

  enum class Answer { Found, Possible, Impossible };
  /// Is there a witness against a pair that is left out, or may there still be one? Also of a pair that is open.
  [[nodiscard]] Answer against(const Pair& pair) const;

  /// A pair of the rim that touches an undecided corner of a pair; not valid where there is none.
  [[nodiscard]] Pair nearby(const Pair& pair, const Rim& rim) const;

 private:
  [[nodiscard]] bool may_be_touched(Side side, HalfedgeId corner) const;

  const Partial& partial_;
  const FacesAt& faces_at_;
  bool seams_;  // where edges are cut, faces may clash without a vertex that tells
};

}  // namespace quadmatch::exact
