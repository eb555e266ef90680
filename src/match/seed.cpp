// The last step of §4.1: "then look for matching neighbors of the two matched vertices".
//
// Reading: the paper does not say how far to look. A colour can be unique in both meshes and yet belong to different
// places, above all after an edit, whose new extraordinary vertices shoot particles across the whole mesh and change
// what other vertices see. So a small fire is lit at each of the best anchors, and the seed is the one from which it
// spreads farthest before it meets corners that disagree. A thousand quads cost nothing beside matching them all.

#include <algorithm>

#include "growth.hpp"

namespace quadmatch {
namespace {

constexpr std::size_t kPatchFaces = 1024;
/// An extraordinary corner that agrees says as much as this many regular ones: a slide along a regular patch meets
/// none.
constexpr std::size_t kExtraordinary = 8;
/// Anchors nearly as good as the best are left in the order in which they came: rarest and in the largest component.
constexpr double kNearly = 0.75;

/// Grow across faces whose corners all agree, and say what that is worth.
std::size_t light_small_fire(Growth& growth, const Anchor& anchor) {
  const Mesh& source = growth.source();
  const Mesh& target = growth.target();
  growth.accept(anchor);
  for (std::size_t burning = 0; burning < growth.matched_faces() && burning < kPatchFaces; ++burning) {
    auto [s, t] = growth.order()[burning];
    for (std::uint32_t corner = source.size(source.face(s)); corner > 0; --corner) {
      const Candidate beyond{source.twin(s), target.twin(t)};
      if (beyond.source.valid() && beyond.target.valid() && growth.fits(beyond) &&
          growth.disagreeing_corners(beyond) == 0) {
        growth.accept(beyond);
      }
      s = source.next(s);
      t = target.next(t);
    }
  }
  const std::size_t worth = 4 * growth.matched_faces() + kExtraordinary * growth.extraordinary_corners();
  growth.clear();
  return worth;
}

}  // namespace

Anchor choose_seed(Growth& growth, const std::vector<Anchor>& anchors) {
  std::vector<Anchor> fitting;
  std::vector<std::size_t> worth;
  std::size_t best = 0;
  for (const Anchor& anchor : anchors) {
    if (!growth.fits(anchor)) continue;
    fitting.push_back(anchor);
    worth.push_back(light_small_fire(growth, anchor));
    best = std::max(best, worth.back());
  }
  for (std::size_t k = 0; k < fitting.size(); ++k) {
    if (static_cast<double>(worth[k]) >= kNearly * static_cast<double>(best)) return fitting[k];
  }
  return {};
}

}  // namespace quadmatch
