#pragma once
/// Where the writing of a component may begin: few places, the same in every mesh that has such a component.

#include <cstdint>
#include <span>
#include <vector>

#include "clusters.hpp"

namespace quadmatch::canonical {

/// Half-edges of the clusters of one component, those of each together and ascending; none of the others.
struct Starts {
  std::vector<HalfedgeId> halfedges;
  std::vector<std::uint32_t> first;  ///< #clusters + 1 offsets into `halfedges`

  [[nodiscard]] std::span<const HalfedgeId> of(std::uint32_t cluster) const {
    return std::span(halfedges).subspan(first[cluster], first[cluster + 1] - first[cluster]);
  }
};

/// The half-edges of the rarest colour in each cluster of one component. What looks alike has the same colour, so with
/// every half-edge come all those that a symmetry lays it on; should two that do not look alike get the same colour,
/// there are more to be tried, and that is all.
///
/// Spokes are coloured (see colour_spokes) until a cluster has one of its own, two checks tell equally many
/// apart, or to try what is left costs no more than to look on. A
/// cluster where no vertex is extraordinary is a torus or a tube: all half-edges of the former, those on the rim of the
/// latter.
///
/// @par Cost  O(#corners), and for each round O(S log S) of S spokes.
[[nodiscard]] Starts starts_of(const Mesh& mesh, const Clusters& clusters);

}  // namespace quadmatch::canonical
