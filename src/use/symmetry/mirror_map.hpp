#pragma once
/// A mirror under way: each half-edge it has reached, and the one that lies opposite.
///
/// A map that turns the surface over lays half-edge h, from v to w, on the half-edge from the image of w to that of v,
/// and the face to its left on the face to that one's left. So images of `next` are `prev`, and images of twins twins.

#include <cstdint>
#include <vector>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {

/// A half-edge and the one opposite: enough to fix a whole mirror of a component.
struct Germ {
  HalfedgeId from, to;
};

/// What two faces must have in common to be laid on each other.
enum class Fit {
  Free,      ///< both are free, and have equally many corners
  Vertices,  ///< and their vertices have no other partners
  Looks,     ///< and look alike: valence, boundary, non-quads
};

/// Its own inverse at every moment: with a face comes its partner.
class MirrorMap {
 public:
  MirrorMap(const Mesh& mesh, const PerFan<VertexCode>& codes);

  /// Lay two faces on each other, if they fit.
  bool lay(Germ germ, Fit fit);
  /// Go on beyond the sides of all that is laid, breadth first. O(faces laid).
  /// @param most  faces laid at most
  void grow(Fit fit, std::uint32_t most = 0xffffffff);
  /// Lay the faces beside what is laid whose vertices fit though they do not look alike, and nothing beyond them.
  void cover_rim();
  /// Nothing is laid. O(faces that were).
  void clear();

  /// Not valid where nothing is laid.
  [[nodiscard]] HalfedgeId image(HalfedgeId h) const { return image_[h]; }
  [[nodiscard]] FaceId image(FaceId f) const {
    const HalfedgeId there = image_[mesh_.first(f)];
    return there.valid() ? mesh_.face(there) : FaceId();
  }
  /// By the first faces laid at the vertex.
  [[nodiscard]] VertexId image(VertexId v) const { return vertex_[v]; }
  /// One for each pair laid, in order.
  [[nodiscard]] const std::vector<Germ>& laid() const { return laid_; }
  [[nodiscard]] std::uint32_t faces() const { return faces_; }
  /// Sides beyond which faces did not fit.
  [[nodiscard]] std::uint32_t conflicts() const { return conflicts_; }

 private:
  bool join(VertexId v, VertexId w);
  bool join_corners(Germ germ, Fit fit);

  const Mesh& mesh_;
  const PerFan<VertexCode>& codes_;
  PerHalfedge<HalfedgeId> image_;
  PerVertex<VertexId> vertex_;
  std::vector<Germ> laid_;
  std::vector<VertexId> joined_;  // one of each pair of vertices, while a face is laid
  std::size_t looked_beyond_ = 0;
  std::uint32_t faces_ = 0;
  std::uint32_t conflicts_ = 0;
};

}  // namespace quadmatch::use
