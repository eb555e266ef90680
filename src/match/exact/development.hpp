#pragma once
/// What must be lost: conflict sets found by developing a map beyond a partial region, and a packing of disjoint ones.

#include <array>
#include <cstdint>
#include <vector>

#include "partial.hpp"

namespace quadmatch::exact {

/// What a packing came to.
struct Packing {
  /// Open faces that every better region which holds the partial one loses at least.
  std::uint32_t losses = 0;
  /// Nothing is in conflict (level 0, and nothing packed before): the partial region and its whole development are a
  /// region.
  bool free_of_conflict = false;
  /// The pair of the rim at the root of the first conflict found, the shortest.
  Pair root;
};

/// Develops one side over what a partial region leaves open.
///
/// A face beyond an edge of a face that is in has but one possible image. So going from the rim face by face gives
/// every open face a label; if the region held all faces of a path, each would have its label. Where a face reached
/// along a path has no label that fits, or clashes with a face reached along another, the two paths cannot both be in:
/// at least one of their faces is lost.
class Development {
 public:
  explicit Development(const Partial& partial);

  /// Count the open faces of a side that can be reached from the rim, and note which they are.
  std::uint32_t count_reach(Side side, const Rim& rim);
  /// @pre count_reach was called last for this side.
  [[nodiscard]] bool is_reached(FaceId face) const { return reach_stamp_[face] == reach_; }

  /// Label as many faces of a side as agree with the partial region and with each other: those that clash are passed
  /// over. `labels` has them.
  void spread(Side side, const Rim& rim);

  /// Begin a packing of a side.
  void begin_packing(Side side);
  /// Pack conflict sets, and what the levels of the side demand, up to `enough` losses; the sets packed before stay.
  /// @param level  only within this level of the side, and only what is lost there; from call to call it falls.
  /// @pre propagated: every pair beyond the rim fits, and open faces that cannot be reached are out.
  Packing pack(std::uint32_t level, const Rim& rim, std::uint32_t enough);

  /// May the face be among the losses that the last packing counted? @pre the same side
  [[nodiscard]] bool may_be_lost(FaceId face) const {
    const std::uint32_t level = partial_.level(side_, face);
    return is_packed(face) || (level != Partial::kNoLevel && unpaid_beyond_sets(level) > 0);
  }

  /// The labels of the last spread, or of the last packing's first development, if it was free of conflict; from the
  /// rim outwards.
  [[nodiscard]] const std::vector<Pair>& labels() const { return queue_; }

 private:
  struct Label {
    std::uint32_t stamp = 0;
    HalfedgeId image;  // of the first half-edge
    FaceId parent;     // not valid: beyond the rim
  };
  struct Owned {
    std::uint32_t stamp = 0;
    std::uint32_t value = 0;
    FaceId owner;  // the face of this side that said so
  };

  bool develop(const Rim& rim);
  bool reach(const Pair& pair, FaceId parent);
  bool reach_around(Pair pair, bool pass_over = false);
  [[nodiscard]] FaceId opponent(const Pair& pair) const;
  [[nodiscard]] FaceId corner_opponent(HalfedgeId here, HalfedgeId there, std::uint32_t size) const;
  [[nodiscard]] FaceId edge_opponent(HalfedgeId here, HalfedgeId there, std::uint32_t size) const;
  void put_label(const Pair& pair, FaceId parent);
  void take_label(const Pair& pair);
  void claim_corners(const Pair& pair);
  void prune();
  [[nodiscard]] bool is_labelled(FaceId face) const { return labels_[face].stamp == stamp_; }
  [[nodiscard]] HalfedgeId label_of(HalfedgeId here) const;
  [[nodiscard]] bool is_packed(FaceId face) const { return packed_[face] == packing_; }
  [[nodiscard]] bool is_within(FaceId face) const;
  void pack_face(FaceId face);
  void pack_path(FaceId face);
  void pack_clash();
  [[nodiscard]] std::uint32_t unpaid_beyond_sets(std::uint32_t level) const;
  [[nodiscard]] std::uint32_t losses() const;
  [[nodiscard]] Pair root_of_clash(const Rim& rim) const;

  const Partial& partial_;
  Side side_ = kSource;      // the side developed
  std::uint32_t level_ = 0;  // within which
  std::uint32_t sets_ = 0;
  std::vector<std::uint32_t> touches_;  // sets with a face in the ring of each level
  std::vector<std::uint32_t> touched_;  // levels, by the set being packed
  std::uint32_t stamp_ = 0, packing_ = 0, reach_ = 0;
  PerFace<Label> labels_;            // of either side, so as many as the larger has faces
  PerFace<Owned> taken_;             // of the other side: which face lies there
  PerVertex<Owned> image_, origin_;  // of this side's vertices, of the other's
  PerFace<std::uint32_t> packed_, reach_stamp_;
  std::vector<Pair> queue_;      // labelled, parents before children
  std::size_t next_ = 0;         // in it: whose neighbours are to be reached
  std::vector<FaceId> cut_off_;  // have lost their labels, to be reached again
  std::vector<FaceId> to_visit_;
  FaceId clash_parent_, clash_face_, clash_opponent_;
};

}  // namespace quadmatch::exact
