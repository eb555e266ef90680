#pragma once
/// The map of one whole component onto another, down to the last corner: an isomorphism of the two.

#include <cstdint>
#include <utility>
#include <vector>

#include "patchwork.hpp"

namespace quadmatch::regions {

/// Grows such a map from one pair of half-edges, and finds out whether there is one.
///
/// Far cheaper than a ghost: it stops at the first disagreement, so that little need be noted. Where no vertex has
/// several fans, the vertex map comes with the faces.
class WholeMap {
 public:
  /// Memory for both meshes; make one and use it again and again.
  explicit WholeMap(const Sides& sides);

  /// Carry the map that begins with a pair of half-edges over the whole component of the source.
  /// @param faces  of the source's component.
  /// @return       true if it reaches them all with all corners agreeing, each face once; else what it holds is of no
  /// use.
  /// @par Cost     O(faces mapped), and of those that were mapped before.
  bool grow(Candidate seed, std::uint32_t faces);

  /// Every face of the component, the seed's first, each by the half-edge through which it was reached.
  [[nodiscard]] const std::vector<Candidate>& pairs() const { return pairs_; }
  /// How many pairs had been reached at the end of each wave.
  [[nodiscard]] const std::vector<std::uint32_t>& waves() const { return waves_; }
  /// Both.
  struct Faces {
    std::vector<Candidate> pairs;
    std::vector<std::uint32_t> waves;
  };
  /// Hand over the map that was grown last. No later one comes to its faces any more.
  [[nodiscard]] Faces take() { return {std::exchange(pairs_, {}), std::exchange(waves_, {})}; }

 private:
  /// The partner of a vertex, as far as the map sees it that noted it last.
  struct Partner {
    std::uint32_t map = 0;
    VertexId vertex;
  };

  void forget();
  bool reach(Candidate pair);
  bool reach_neighbours(Candidate pair);
  [[nodiscard]] bool maps_vertices_one_to_one();

  const Mesh& source_;
  const Mesh& target_;
  PerFace<HalfedgeId> image_of_first_;  // of each source face that is mapped
  std::vector<bool> taken_;             // target faces
  std::vector<Candidate> pairs_;
  std::vector<std::uint32_t> waves_;
  std::uint32_t number_ = 0;                            // of the map
  PerVertex<Partner> source_partner_, target_partner_;  // empty where every vertex has at most one fan
};

}  // namespace quadmatch::regions
