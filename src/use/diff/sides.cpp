#include "sides.hpp"

namespace quadmatch::use {

Sides lay_sides(const Mesh& source, const Mesh& target, const Match& match, double least_confidence) {
  Sides sides{{&source, PerHalfedge<HalfedgeId>(source.halfedge_count())},
              {&target, PerHalfedge<HalfedgeId>(target.halfedge_count())}};
  for (const Region& region : match.regions) {
    if (region.evidence.confidence() < least_confidence) continue;
    // Turned over, the side that begins at a corner lies on the one that ends at its image.
    const std::uint32_t shift = region.orientation == Orientation::Preserving ? 0 : 1;
    for (const FacePair& pair : region.faces) {
      const std::uint32_t size = source.size(pair.source);
      for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t corner = i + shift == size ? 0 : i + shift;
        const HalfedgeId there(source.first(pair.source).value + i);
        const HalfedgeId here(target.first(pair.target).value +
                              image_corner(region.orientation, pair.rotation, corner, size));
        sides.source.image[there] = here;
        sides.target.image[here] = there;
      }
    }
  }
  return sides;
}

}  // namespace quadmatch::use
