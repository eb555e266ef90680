#pragma once
/// Which face lies on which, region by region: what the fire makes, and the stages after it mend.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/analysis/anchors.hpp>
#include <quadmatch/analysis/skeleton.hpp>
#include <quadmatch/mesh/large_pages.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::regions {

/// What the engine knows of one mesh.
struct Side {
  const Mesh& mesh;
  const PerFan<VertexCode>& codes;
  const ArcGraph& separatrices;

  /// A vertex of several fans has the code of its first, which bears its number.
  [[nodiscard]] VertexCode code(VertexId v) const { return codes[FanId(v.value)]; }
};

/// Both meshes, with the target as it is laid: orientation preserving.
struct Sides {
  Side source;
  Side target;
};

/// A possible pair of faces, named by half-edges that lie on each other.
using Candidate = Anchor;

/// The half-edge `steps` corners on from h about its face. @pre steps <= 2 * the face's size
[[nodiscard]] inline HalfedgeId turned(const Mesh& mesh, HalfedgeId h, std::uint32_t steps) {
  if (mesh.all_quads()) return HalfedgeId((h.value & ~3U) | ((h.value + steps) & 3U));
  const FaceId face = mesh.face(h);
  const std::uint32_t start = mesh.first(face).value, size = mesh.size(face);
  // Without a division, and without a branch that nobody can guess: below nothing unsigned numbers are the largest.
  const auto wrapped = [size](std::uint32_t corner) { return std::min(corner, corner - size); };
  return HalfedgeId(start + wrapped(wrapped(h.value - start + steps)));
}

/// What is beyond an edge: a face that lies on the one beyond the other edge; or one that is matched otherwise, in
/// either mesh; or none that is matched.
enum class Beyond : std::uint8_t { InPlace, Elsewhere, Free };

/// Pairs of faces, each of a region. No face is in two pairs; beyond that nothing is promised.
class Patchwork {
 public:
  static constexpr std::uint32_t kNoRegion = 0xffffffff;

  Patchwork(const Mesh& source, const Mesh& target)
      : source_(source), target_(target), laid_(source.face_count()), origin_(target.face_count()) {}

  [[nodiscard]] bool is_matched(FaceId source_face) const { return laid_[source_face].image_of_first.valid(); }
  [[nodiscard]] bool is_taken(FaceId target_face) const { return origin_[target_face].valid(); }
  [[nodiscard]] std::size_t matched_faces() const { return matched_; }
  /// The source faces that were laid, lifted or given to another region, each time that it happened.
  [[nodiscard]] const std::vector<FaceId>& changed() const { return changed_; }
  /// How many these are: nothing changes while this does not.
  [[nodiscard]] std::uint32_t changes() const { return static_cast<std::uint32_t>(changed_.size()); }
  /// What changes() was after a source face last changed; 0 if it never did.
  [[nodiscard]] std::uint32_t changed_at(FaceId source_face) const { return laid_[source_face].changed_at; }

  /// The half-edge on which h lies. @pre its face is matched.
  [[nodiscard]] HalfedgeId image(HalfedgeId h) const {
    return turned(target_, laid_[source_.face(h)].image_of_first, source_.corner(h));
  }
  [[nodiscard]] FaceId image(FaceId source_face) const { return target_.face(laid_[source_face].image_of_first); }
  /// The half-edge that lies on t. @pre its face is taken.
  [[nodiscard]] HalfedgeId preimage(HalfedgeId t) const {
    const FaceId face = origin_[target_.face(t)];
    const std::uint32_t size = source_.size(face);
    const std::uint32_t steps = target_.corner(t) + size - target_.corner(laid_[face].image_of_first);
    return turned(source_, source_.first(face), steps);
  }
  [[nodiscard]] FaceId origin(FaceId target_face) const { return origin_[target_face]; }
  [[nodiscard]] std::uint32_t region(FaceId source_face) const { return laid_[source_face].region; }
  void set_region(FaceId source_face, std::uint32_t region) {
    Laid& laid = laid_[source_face];
    if (laid.region == region) return;
    --faces_of_region_[laid.region];
    ++faces_of_region_[region];
    laid.region = region;
    note_change(source_face);
  }
  /// What is beyond an edge of a pair of faces that lie on each other, or may: (s, t) are half-edges of theirs.
  [[nodiscard]] Beyond beyond(HalfedgeId s, HalfedgeId t) const {
    const HalfedgeId beside = source_.twin(s), beside_target = target_.twin(t);
    if (beside.valid() && is_matched(source_.face(beside))) {
      return image(beside) == beside_target ? Beyond::InPlace : Beyond::Elsewhere;
    }
    const bool taken = beside_target.valid() && is_taken(target_.face(beside_target));
    return taken ? Beyond::Elsewhere : Beyond::Free;
  }
  /// A number that no region has had.
  [[nodiscard]] std::uint32_t fresh_region() {
    faces_of_region_.push_back(0);
    return region_count() - 1;
  }
  /// One more than the largest region number.
  [[nodiscard]] std::uint32_t region_count() const { return static_cast<std::uint32_t>(faces_of_region_.size()); }
  /// How many faces a region has.
  [[nodiscard]] std::uint32_t faces_of_region(std::uint32_t region) const { return faces_of_region_[region]; }
  /// The half-edges through which faces were matched, in order. Faces lifted since stand in it still, and twice if they
  /// were laid again.
  [[nodiscard]] const std::vector<HalfedgeId>& history() const { return history_; }
  /// Strike out of the history what is not matched now.
  /// @pre nothing was laid since the first lift() after the last tidying
  void tidy_history() {
    std::erase_if(history_, [&](HalfedgeId entry) { return !is_matched(source_.face(entry)); });
  }

  /// @pre both faces are free and of one size.
  void lay(Candidate pair, std::uint32_t region) {
    const FaceId face = source_.face(pair.source);
    Laid& laid = laid_[face];
    laid.image_of_first = turned(target_, pair.target, source_.size(face) - source_.corner(pair.source));
    laid.region = region;
    origin_[target_.face(pair.target)] = face;
    ++faces_of_region_[region];
    history_.push_back(pair.source);
    note_change(face);
    ++matched_;
  }
  /// Lay many, one after the other. @pre as of each
  void lay(std::span<const Candidate> pairs, std::uint32_t region) {
    constexpr std::size_t kAhead = 16;  // long enough for memory to answer
    reserve_more_on_large_pages(history_, pairs.size());
    reserve_more_on_large_pages(changed_, pairs.size());
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Candidate& ahead = pairs[std::min(k + kAhead, pairs.size() - 1)];
      __builtin_prefetch(&laid_[source_.face(ahead.source)], 1);
      __builtin_prefetch(&origin_[target_.face(ahead.target)], 1);
      lay(pairs[k], region);
    }
  }
  /// @pre the face is matched.
  void lift(FaceId source_face) {
    Laid& laid = laid_[source_face];
    origin_[target_.face(laid.image_of_first)] = FaceId();
    --faces_of_region_[laid.region];
    laid.image_of_first = HalfedgeId();
    laid.region = kNoRegion;
    note_change(source_face);
    --matched_;
  }

 private:
  /// What is known of a source face, side by side: one is asked for after the other.
  struct Laid {
    HalfedgeId image_of_first;  // of its first half-edge; not valid while it is not matched
    std::uint32_t region = kNoRegion;
    std::uint32_t changed_at = 0;
  };

  void note_change(FaceId source_face) {
    changed_.push_back(source_face);
    laid_[source_face].changed_at = changes();
  }

  const Mesh& source_;
  const Mesh& target_;
  PerFace<Laid> laid_;      // of each source face
  PerFace<FaceId> origin_;  // of each target face
  std::vector<HalfedgeId> history_;
  std::vector<std::uint32_t> faces_of_region_;
  std::size_t matched_ = 0;
  std::vector<FaceId> changed_;
};

}  // namespace quadmatch::regions
