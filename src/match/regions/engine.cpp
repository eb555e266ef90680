#include "engine.hpp"

#include <utility>

#include "fire.hpp"
#include "ignition.hpp"

namespace quadmatch::regions {
namespace {

constexpr double kLeastConfidence = 0.6;

/// Grow from all anchors that colours give, in rounds: what is matched makes others unique.
void grow(const Sides& sides, Fire& fire, const Patchwork& patchwork) {
  const ColouredSpokes colours = colour_both(sides);
  constexpr int kMostRounds = 4;
  const std::size_t little = sides.source.mesh.face_count() / 500;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t before = patchwork.matched_faces();
    fire.light(find_sparks(sides, colours, patchwork, round == 0 ? Caution::High : Caution::Low));
    fire.burn();
    if (patchwork.matched_faces() - before <= little) break;
  }
  fire.burn_disagreeing();
  if (fire.drop_unbelievable(kLeastConfidence) > 0) {
    fire.rekindle();
    fire.burn();
  }
  fire.light(find_sparks(sides, colours, patchwork, Caution::Low));
  fire.burn();
  fire.burn_disagreeing();
  fire.drop_unbelievable(kLeastConfidence);
}

}  // namespace

std::vector<Piece> match_regions(const Sides& sides) {
  Patchwork patchwork(sides.source.mesh, sides.target.mesh);
  Fire fire(sides, patchwork);
  grow(sides, fire, patchwork);
  fire.settle();
  return split(sides, patchwork, fire.order());
}

}  // namespace quadmatch::regions
