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

/// One of a chain of nested sets of faces K_0, K_1, ..., each of which loses few faces. What is counted here is the
/// ring of K_j without K_j+1.
struct Level {
  std::uint32_t budget = 0;        ///< faces that K_j loses at most
  std::uint32_t demand = 0;        ///< faces that every better region within the chain loses of the ring at least
  std::uint32_t open = 0;          ///< faces of the ring, less those that are in or out
  std::uint32_t out = 0;           ///< faces of the ring that are out
  std::vector<FaceId> faces = {};  ///< K_j

  /// Faces that must still be lost of the ring.
  [[nodiscard]] std::uint32_t unpaid() const { return demand > out ? demand - out : 0; }
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
  [[nodiscard]] HalfedgeId turned(Side side, HalfedgeId h, std::uint32_t corner) const {
    const Mesh& mesh = *meshes_[side];
    if (mesh.all_quads()) return HalfedgeId((h.value & ~3U) | ((h.value + corner) & 3U));
    const FaceId face = mesh.face(h);
    const std::uint32_t first = mesh.first(face).value, size = mesh.size(face);
    const std::uint32_t place = h.value - first + corner;
    return HalfedgeId(first + (place >= size ? place - size : place));
  }

  /// Pairs in the region, in the order of commitment.
  [[nodiscard]] const std::vector<Pair>& pairs() const { return pairs_; }
  [[nodiscard]] std::uint32_t size() const { return static_cast<std::uint32_t>(pairs_.size()); }

  /// May this pair join: both faces are open, of one size, agree with the vertex map at every corner, and are adjacent
  /// to faces that are in across corresponding edges only?
  [[nodiscard]] bool fits(const Pair& pair) const;
  /// The same of its corners and neighbours, whether its faces are open or out. @pre they are not in
  [[nodiscard]] bool agrees(const Pair& pair) const;
  /// The vertex of the other side that v lies on, if it has one.
  [[nodiscard]] VertexId partner(Side side, VertexId v) const { return partner_[side][v]; }
  /// @pre fits(pair)
  void commit(const Pair& pair);
  /// @pre the face is open
  void exclude(Side side, FaceId face);

  /// A place on the trail to go back to.
  using Mark = std::size_t;
  [[nodiscard]] Mark mark() const { return trail_.size(); }
  void undo(Mark mark);

  // The chain of levels; nothing may be decided while it changes.
  /// Begin a chain of one level on a side.
  void begin_levels(Side side, std::vector<FaceId> faces, std::uint32_t budget);
  /// @pre `faces` are of the last level
  void push_level(std::vector<FaceId> faces, std::uint32_t budget);
  void pop_level();
  /// Demand losses in the ring of the last level, as soon as there is a next one.
  void set_demand(std::uint32_t demand) { levels_.back().demand = demand; }
  [[nodiscard]] Side level_side() const { return level_side_; }
  [[nodiscard]] const std::vector<Level>& levels() const { return levels_; }
  /// The last level a face is in; kNoLevel for faces of the other side, and of other components.
  [[nodiscard]] std::uint32_t level(Side side, FaceId face) const {
    return side == level_side_ ? level_of_[face] : kNoLevel;
  }
  static constexpr std::uint32_t kNoLevel = 0xffffffff;

 private:
  enum class Step : std::uint8_t { Committed, Vertex, OutOfSource, OutOfTarget };
  struct Entry {
    Step step;
    std::uint32_t id;
  };

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
  Side level_side_ = kSource;
  std::vector<Level> levels_;
  PerFace<std::uint32_t> level_of_;
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
