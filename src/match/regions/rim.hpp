#pragma once
/// Where regions end. Most faces lie deep within one region, and most of what mends matches has nothing to do there.

#include <cstdint>
#include <vector>

#include "patchwork.hpp"

namespace quadmatch::regions {

/// The matched faces of the source that are not deep: beyond some edge of theirs is no face, or an unmatched one, or
/// one of another region, or one that lies elsewhere than beside their image.
///
/// Kept from stage to stage: only the faces about what has changed are looked at again.
class Rim {
 public:
  /// Takes memory when it is first asked.
  Rim(const Sides& sides, const Patchwork& patchwork);

  /// The half-edges through which these faces were first matched, in that order, of one region or of all.
  /// @pre      once asked, the history is not tidied any more
  /// @par Cost O(#result), and O(c log c) where c faces have changed since the last call; O(F) for the first.
  [[nodiscard]] std::vector<HalfedgeId> entries();
  [[nodiscard]] std::vector<HalfedgeId> entries(std::uint32_t region);

 private:
  /// Faces by their places in the history; those after the first `sorted` were added since.
  struct List {
    std::vector<std::uint32_t> places;
    std::size_t sorted = 0;
    bool has_stale = false;
  };
  static constexpr std::uint32_t kNone = 0xffffffff;

  void update();
  void note_places();
  [[nodiscard]] bool is_deep(FaceId face) const;
  void look_at(FaceId face);
  void look_about(FaceId face);
  template <class IsStale>
  [[nodiscard]] std::vector<HalfedgeId> tidied(List& list, IsStale is_stale) const;

  const Mesh& source_;
  const Mesh& target_;
  const Patchwork& patchwork_;
  PerFace<std::uint32_t> place_;   // the first in the history
  PerFace<std::uint32_t> region_;  // where a face is listed; kNoRegion if it is deep or unmatched
  List all_;
  std::vector<List> of_region_;
  std::size_t noted_ = 0;  // of the history
  std::size_t seen_ = 0;   // of the changes
};

}  // namespace quadmatch::regions
