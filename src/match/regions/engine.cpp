#include "engine.hpp"

#include <algorithm>

#include "equal_parts.hpp"
#include "fire.hpp"
#include "ignition.hpp"
#include "likelihood.hpp"
#include "mending.hpp"
#include "placement.hpp"

namespace quadmatch::regions {
namespace {

constexpr double kLeastConfidence = 0.6;

/// Grow from all anchors that colours give, in rounds: what is matched makes others unique.
void grow(const Sides& sides, const ColouredSpokes& colours, Fire& fire, const Patchwork& patchwork) {
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

/// Make the costs small: move what lies badly, match what was left over.
void mend(Workbench& bench, const EngineOptions& options) {
  const Stages& stages = options.stages;
  const auto move = [&] {
    if (stages.seams) move_seams(bench);
  };
  bench.misfit.calibrate(bench.patchwork);
  move();
  if (stages.ties) place(bench);
  if (bench.misfit.is_placed() && settle_ties(bench) > 0) {
    bench.misfit.calibrate(bench.patchwork);
    move();
  }
  for (int round = 0; round < 2 && stages.slides; ++round) {
    if (undo_slides(bench) == 0) break;
    move();
  }
  drop_misfits(bench);
  if (stages.slivers) match_slivers(bench);
  for (int round = 0; round < 2 && stages.islands; ++round) {
    if (match_islands(bench) == 0) break;
    if (stages.slivers) match_slivers(bench);
  }
  move();
  drop_misfits(bench);
  if (stages.slivers) match_slivers(bench);
}

constexpr int kMostRestarts = 3;

/// Is at most a little left free in one of the meshes?
bool leaves_little(const Workbench& bench) {
  const std::size_t faces = std::min(bench.sides.source.mesh.face_count(), bench.sides.target.mesh.face_count());
  return 1000 * bench.patchwork.matched_faces() >= 985 * faces;
}

/// Everything after the equal parts: fire, and what mends it.
void match_unequal(Workbench& bench, const ColouredSpokes& colours, EqualParts& equal, const EngineOptions& options) {
  {
    Fire fire(bench.sides, bench.patchwork);
    grow(bench.sides, colours, fire, bench.patchwork);
    fire.settle();
  }
  split(bench.sides, bench.patchwork);
  equal.lay_repeated();
  mend(bench, options);
  for (int round = 0; round < kMostRestarts && options.stages.restarts; ++round) {
    if (leaves_little(bench)) break;
    std::size_t matched = restart(bench);
    if (matched == 0 && bench.patchwork.matched_faces() == 0) {
      bench.misfit.assume();  // there is nothing to learn lengths from, and nothing to lose
      matched = restart(bench);
    }
    if (matched == 0) break;
    mend(bench, options);
  }
  if (options.stages.acceptance) drop_unlikely(bench);
}

}  // namespace

std::vector<Piece> match_regions(const Sides& sides, const EngineOptions& options) {
  Patchwork patchwork(sides.source.mesh, sides.target.mesh);
  Misfit misfit(sides, options.positions);
  Ghost ghost(sides, patchwork);
  Workbench bench{sides, patchwork, misfit, ghost};
  const ColouredSpokes colours = colour_both(sides);
  EqualParts equal(bench, colours);
  equal.lay_single();
  const std::uint32_t most = std::min(sides.source.mesh.face_count(), sides.target.mesh.face_count());
  if (patchwork.matched_faces() < most) {
    match_unequal(bench, colours, equal, options);
  } else if (misfit.may_use_positions() && !lies_well(bench)) {
    mend(bench, options);
  }
  return split(sides, patchwork);
}

}  // namespace quadmatch::regions
