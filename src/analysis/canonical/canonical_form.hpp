#pragma once
/// A mesh in an order that does not depend on its numbering: two meshes have the same form exactly if they are the same
/// up to numbering.

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

#include <quadmatch/analysis/group_order.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::canonical {

struct CanonicalForm {
  /// Components that are tied by vertices they share, most often a single one.
  struct Cluster {
    std::uint32_t first_face = 0;  ///< in `faces`
    std::uint32_t face_count = 0;
    std::size_t first_number = 0;  ///< in `numbers`
    std::size_t number_count = 0;
    GroupOrder symmetries;
  };

  /// From the fewest faces, then by their numbers: equal ones stand together.
  std::vector<Cluster> clusters;
  /// All faces, each by the half-edge it is read from.
  std::vector<HalfedgeId> faces;
  /// For each of `faces` the number of its corners, then those of their vertices, counted from 0 in each cluster in the
  /// order in which they come.
  std::vector<std::uint32_t> numbers;
  /// Vertices that no face uses.
  std::uint32_t unused_vertices = 0;

  [[nodiscard]] std::span<const std::uint32_t> numbers_of(const Cluster& cluster) const {
    return std::span(numbers).subspan(cluster.first_number, cluster.number_count);
  }
  [[nodiscard]] std::span<const HalfedgeId> faces_of(const Cluster& cluster) const {
    return std::span(faces).subspan(cluster.first_face, cluster.face_count);
  }
};

/// @par Cost  near O(#corners) where every cluster is one component (see Writer); else see TiedSearch.
[[nodiscard]] CanonicalForm canonical_form(const Mesh& mesh);

/// Is a cluster of one form that of another? Less, equal or greater as they stand in a form.
[[nodiscard]] std::strong_ordering compare(const CanonicalForm& one, const CanonicalForm::Cluster& cluster,
                                           const CanonicalForm& other, const CanonicalForm::Cluster& other_cluster);

/// Are both meshes the same?
[[nodiscard]] bool is_same(const CanonicalForm& one, const CanonicalForm& other);

/// How many maps lay the mesh on itself, keeping the orientation: each cluster by itself, and equal ones change places.
[[nodiscard]] GroupOrder symmetries_of(const CanonicalForm& form);

}  // namespace quadmatch::canonical
