#pragma once
/// A region that does not count yet: the map of one region, carried on over faces that others have, or a trial from a
/// single pair. Sound by itself; the patchwork is not touched.

#include <cstdint>
#include <vector>

#include "patchwork.hpp"

namespace quadmatch::regions {

class Ghost {
 public:
  /// Takes memory for both meshes with the first restart(); make one and use it again and again.
  Ghost(const Sides& sides, const Patchwork& patchwork);

  /// Forget all pairs, at the cost of making them, and carry on the map of a region, or of none. Call it first.
  void restart(std::uint32_t base = Patchwork::kNoRegion);

  /// May this pair join? Both faces are free of ghost and base, of one size, agree with their vertex map at every
  /// corner, and are adjacent to their faces across corresponding edges only.
  [[nodiscard]] bool fits(Candidate pair) const;
  /// @pre fits(pair)
  void accept(Candidate pair);

  /// The pairs beyond the base, in the order of acceptance.
  [[nodiscard]] const std::vector<Candidate>& pairs() const { return pairs_; }
  /// The number of a pair by its source face, kNone if it has none.
  [[nodiscard]] std::uint32_t pair_of(FaceId source_face) const { return pair_of_[source_face]; }
  [[nodiscard]] std::uint32_t pair_on(FaceId target_face) const { return pair_on_[target_face]; }
  /// Is the face in the base or the ghost?
  [[nodiscard]] bool covers(FaceId source_face) const { return pair_of_[source_face] != kNone || in_base(source_face); }
  /// Has the vertex that s leaves a partner?
  [[nodiscard]] bool knows(HalfedgeId s) const { return partner_of_source(s).valid(); }
  /// @pre covers its face
  [[nodiscard]] HalfedgeId image(HalfedgeId h) const;

  static constexpr std::uint32_t kNone = 0xffffffff;

 private:
  void make_room();
  [[nodiscard]] bool in_base(FaceId source_face) const {
    return base_ != Patchwork::kNoRegion && patchwork_.region(source_face) == base_;
  }
  [[nodiscard]] bool covers_target(FaceId target_face) const {
    if (pair_on_[target_face] != kNone) return true;
    return base_ != Patchwork::kNoRegion && patchwork_.is_taken(target_face) && in_base(patchwork_.origin(target_face));
  }
  [[nodiscard]] VertexId partner_of_source(HalfedgeId s) const;
  [[nodiscard]] VertexId partner_of_target(HalfedgeId t) const;

  const Mesh& source_;
  const Mesh& target_;
  const Patchwork& patchwork_;
  std::uint32_t base_ = Patchwork::kNoRegion;
  std::vector<Candidate> pairs_;
  PerFace<std::uint32_t> pair_of_, pair_on_;
  PerVertex<VertexId> source_partner_, target_partner_;  // as the pairs say; the base is asked by walking
};

}  // namespace quadmatch::regions
