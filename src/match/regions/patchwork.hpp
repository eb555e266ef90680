#pragma once
/// Which face lies on which, region by region: what the fire makes, and the stages after it mend.

#include <cstdint>
#include <vector>

#include <quadmatch/analysis/anchors.hpp>
#include <quadmatch/analysis/skeleton.hpp>
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

/// The half-edge `steps` corners on from h about its face.
[[nodiscard]] inline HalfedgeId turned(const Mesh& mesh, HalfedgeId h, std::uint32_t steps) {
  if (mesh.all_quads()) return HalfedgeId((h.value & ~3U) | ((h.value + steps) & 3U));
  const FaceId face = mesh.face(h);
  const std::uint32_t start = mesh.first(face).value, size = mesh.size(face);
  std::uint32_t corner = h.value - start + steps;
  while (corner >= size) corner -= size;  // once or twice: a division takes far longer
  return HalfedgeId(start + corner);
}

/// What is beyond an edge: a face that lies on the one beyond the other edge; or one that is matched otherwise, in
/// either mesh; or none that is matched.
enum class Beyond : std::uint8_t { InPlace, Elsewhere, Free };

/// Pairs of faces, each of a region. No face is in two pairs; beyond that nothing is promised.
class Patchwork {
 public:
  static constexpr std::uint32_t kNoRegion = 0xffffffff;

  Patchwork(const Mesh& source, const Mesh& target)
      : source_(source),
        target_(target),
        image_of_first_(source.face_count()),
        origin_(target.face_count()),
        region_(source.face_count(), kNoRegion),
        changed_at_(source.face_count(), 0) {}

  [[nodiscard]] bool is_matched(FaceId source_face) const { return image_of_first_[source_face].valid(); }
  [[nodiscard]] bool is_taken(FaceId target_face) const { return origin_[target_face].valid(); }
  [[nodiscard]] std::size_t matched_faces() const { return matched_; }
  /// The source faces that were laid, lifted or given to another region, each time that it happened.
  [[nodiscard]] const std::vector<FaceId>& changed() const { return changed_; }
  /// How many these are: nothing changes while this does not.
  [[nodiscard]] std::uint32_t changes() const { return static_cast<std::uint32_t>(changed_.size()); }
  /// What changes() was after a source face last changed; 0 if it never did.
  [[nodiscard]] std::uint32_t changed_at(FaceId source_face) const { return changed_at_[source_face]; }

  /// The half-edge on which h lies. @pre its face is matched.
  [[nodiscard]] HalfedgeId image(HalfedgeId h) const {
    return turned(target_, image_of_first_[source_.face(h)], source_.corner(h));
  }
  [[nodiscard]] FaceId image(FaceId source_face) const { return target_.face(image_of_first_[source_face]); }
  /// The half-edge that lies on t. @pre its face is taken.
  [[nodiscard]] HalfedgeId preimage(HalfedgeId t) const {
    const FaceId face = origin_[target_.face(t)];
    const std::uint32_t size = source_.size(face);
    const std::uint32_t steps = target_.corner(t) + size - target_.corner(image_of_first_[face]);
    return turned(source_, source_.first(face), steps);
  }
  [[nodiscard]] FaceId origin(FaceId target_face) const { return origin_[target_face]; }
  [[nodiscard]] std::uint32_t region(FaceId source_face) const { return region_[source_face]; }
  void set_region(FaceId source_face, std::uint32_t region) {
    if (region_[source_face] == region) return;
    --faces_of_region_[region_[source_face]];
    ++faces_of_region_[region];
    region_[source_face] = region;
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
    image_of_first_[face] = turned(target_, pair.target, source_.size(face) - source_.corner(pair.source));
    origin_[target_.face(pair.target)] = face;
    region_[face] = region;
    ++faces_of_region_[region];
    history_.push_back(pair.source);
    note_change(face);
    ++matched_;
  }
  /// @pre the face is matched.
  void lift(FaceId source_face) {
    origin_[image(source_face)] = FaceId();
    image_of_first_[source_face] = HalfedgeId();
    --faces_of_region_[region_[source_face]];
    region_[source_face] = kNoRegion;
    note_change(source_face);
    --matched_;
  }

 private:
  void note_change(FaceId source_face) {
    changed_.push_back(source_face);
    changed_at_[source_face] = changes();
  }

  const Mesh& source_;
  const Mesh& target_;
  PerFace<HalfedgeId> image_of_first_;  // of each source face, the image of its first half-edge
  PerFace<FaceId> origin_;              // of each target face
  PerFace<std::uint32_t> region_;       // of each source face
  std::vector<HalfedgeId> history_;
  std::vector<std::uint32_t> faces_of_region_;
  std::size_t matched_ = 0;
  std::vector<FaceId> changed_;
  PerFace<std::uint32_t> changed_at_;  // of each source face
};

}  // namespace quadmatch::regions
