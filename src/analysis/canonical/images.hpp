#pragma once
/// What a symmetry lays on what, for the elements one asks about.

#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/mesh/disjoint_sets.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::canonical {

/// Joins elements that symmetries lay on each other, so that in the end every set is an orbit of the group they make.
class Images {
 public:
  explicit Images(const Mesh& mesh) : mesh_(mesh) {}

  /// Join every member with its image. The symmetry reads the face of `faces[i]` from there on as it does that of
  /// `images[i]` from there on.
  ///
  /// @param members  which the symmetry lays on each other; none of them, or all of their faces, are among `faces`.
  /// @param joined   one for each of the members.
  /// @par Cost       O(corners of the faces), once O(#corners) for memory.
  void join(std::span<const HalfedgeId> faces, std::span<const HalfedgeId> images, std::span<const HalfedgeId> members,
            DisjointSets& joined);
  void join(std::span<const HalfedgeId> faces, std::span<const HalfedgeId> images, std::span<const VertexId> members,
            DisjointSets& joined);

 private:
  template <class IdType, class Element>
  void join_elements(std::span<const HalfedgeId> faces, std::span<const HalfedgeId> images,
                     std::span<const IdType> members, DisjointSets& joined, Element element);

  const Mesh& mesh_;
  std::vector<std::uint32_t> member_;  // where each stands among the members, between calls kNone for all
};

}  // namespace quadmatch::canonical
