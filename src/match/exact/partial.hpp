#pragma once
/// A partial region under search: the pairs that are in, the faces that are out, and a trail to take both back.

#include <array>
#include <cstdint>
#include <vector>

#include <quadmatch/analysis/anchors.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::exact {

/// Two half-edges that lie on each other, and so a pair of faces and its rotation.
using Pair = Anchor;

/// Both meshes are looked at in the same way, so most is kept twice, by side.
using Side = std::uint32_t;
constexpr Side kSource = 0, kTarget = 1;
[[nodiscard]] constexpr Side other(Side side) { return 1 - side; }
[[nodiscard]] constexpr HalfedgeId half(const Pair& pair, Side side) {
  return side == kSource ? pair.source : pair.target;
}
/// The pair of a half-edge of one side and one of the other.
[[nodiscard]] constexpr Pair pair_of(Side side, HalfedgeId here, HalfedgeId there) {
  return side == kSource ? Pair{here, there} : Pair{there, here};
}

/// Is a face in the region, out of it for good, or still to be decided?
enum class Standing : std::uint8_t { Open, In, Out };

/// Faces of which every better region loses at least one.
struct LossSet {
  std::vector<FaceId> faces;
  std::uint32_t in = 0, out = 0;  ///< of them

  /// Nothing is lost of it so far.
  [[nodiscard]] bool unpaid() const { return out == 0; }
};

/// The region as far as it is decided. Conditions between pairs are all checked by `fits`, so whatever is committed is
/// sound; what is excluded is a claim of the search.
class Partial {
 public:
  Partial(const Mesh& source, const Mesh& target);

  [[nodiscard]] const Mesh& mesh(Side side) const { return *meshes_[side]; }
  [[nodiscard]] Standing standing(Side side, FaceId face) const { return standing_[side][face]; }
  [[nodiscard]] bool is_open(Side side, FaceId face) const { return standing_[side][face] == Standing::Open; }
  /// Faces of a side that are open.
  [[nodiscard]] std::uint32_t open_faces(Side side) const { return open_[side]; }
  /// The half-edge of the other side that h lies on. @pre its face is in
  [[nodiscard]] HalfedgeId image(Side side, HalfedgeId h) const;
  /// The half-edge `corner` steps on from h in the same face of a side.
  [[nodiscard]] HalfedgeId turned(Side side, HalfedgeId h, std::uint32_t corner) const;

  /// Pairs in the region, in the order of commitment.
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(pairs_.size()); }

  /// May this pair join: both faces are open, of one size, agree with the vertex map at every corner, and are adjacent
  /// to faces that are in across corresponding edges only?
  [[nodiscard]] bool fits(const Pair& pair) const;
  /// @pre fits(pair)
  void commit(const Pair& pair);
  /// @pre the face is open
  void exclude(Side side, FaceId face);

  /// A place on the trail to go back to.
  using Mark = std::size_t;
  [[nodiscard]] Mark mark() const { return trail_.size(); }
  void undo(Mark mark);

  /// From now on, watch a set of source or target faces. @pre nothing is decided; sets of a side share no face
  void add_loss_set(Side side, std::vector<FaceId> faces);
  [[nodiscard]] const std::vector<LossSet>& loss_sets(Side side) const { return loss_sets_[side]; }
  /// Is the face in a loss set?
  [[nodiscard]] bool is_watched(Side side, FaceId face) const { return set_of_[side][face] != kNoSet; }

 private:
  enum class Step : std::uint8_t { Committed, Vertex, OutOfSource, OutOfTarget };
  struct Entry {
    Step step;
    std::uint32_t id;
  };
  static constexpr std::uint32_t kNoSet = 0xffffffff;

  [[nodiscard]] bool corners_agree(const Pair& pair, std::uint32_t size) const;
  [[nodiscard]] bool neighbours_agree(const Pair& pair, std::uint32_t size) const;
  [[nodiscard]] bool repeat_alike(const Pair& pair, std::uint32_t size) const;
  void decide(Side side, FaceId face, Standing standing);
  void reopen(Side side, FaceId face);

  std::array<const Mesh*, 2> meshes_;
  std::array<PerFace<Standing>, 2> standing_;
  std::array<PerFace<HalfedgeId>, 2> image_of_first_;
  std::array<PerVertex<VertexId>, 2> partner_;
  std::array<PerFace<std::uint8_t>, 2> repeats_;  // has a face a vertex at several corners?
  std::array<std::uint32_t, 2> open_;
  std::array<std::vector<LossSet>, 2> loss_sets_;
  std::array<PerFace<std::uint32_t>, 2> set_of_;
  std::vector<Pair> pairs_;
  std::vector<Entry> trail_;
};

/// Where a region can grow: pairs of half-edges of faces that are in, beyond which something is open.
using Rim = std::vector<Pair>;

/// Add the sides of a pair to a rim.
void extend(Rim& rim, const Partial& partial, const Pair& pair);

/// The pair across an edge; half-edges that have no twin are not valid.
[[nodiscard]] inline Pair beyond(const Partial& partial, const Pair& pair) {
  return {partial.mesh(kSource).twin(pair.source), partial.mesh(kTarget).twin(pair.target)};
}

}  // namespace quadmatch::exact
