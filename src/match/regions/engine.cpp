#include "engine.hpp"

#include <algorithm>

#include "fire.hpp"
#include "ignition.hpp"
#include "likelihood.hpp"
#include "mending.hpp"

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

bool has_positions(const Sides& sides) {
  return !sides.source.mesh.positions().empty() && !sides.target.mesh.positions().empty();
}

/// Make the costs small: move what lies badly, match what was left over.
void mend(Workbench& bench, const EngineOptions& options) {
  const Stages& stages = options.stages;
  const auto move = [&] {
    if (stages.seams) move_seams(bench);
  };
  bench.misfit.calibrate(bench.patchwork);
  move();
  if (options.positions && stages.ties && has_positions(bench.sides) && settle_ties(bench) > 0) {
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

}  // namespace

std::vector<Piece> match_regions(const Sides& sides, const EngineOptions& options) {
  Patchwork patchwork(sides.source.mesh, sides.target.mesh);
  {
    Fire fire(sides, patchwork);
    grow(sides, fire, patchwork);
    fire.settle();
  }
  split(sides, patchwork);
  Misfit misfit(sides, options.positions);
  Ghost ghost(sides, patchwork);
  Workbench bench{sides, patchwork, misfit, ghost};
  mend(bench, options);
  Likelihood likelihood(bench);
  for (int round = 0; round < kMostRestarts && options.stages.restarts; ++round) {
    if (leaves_little(bench) || restart(bench, likelihood) == 0) break;
    mend(bench, options);
  }
  if (options.stages.acceptance) drop_unlikely(bench, likelihood);
  return split(sides, patchwork);
}

}  // namespace quadmatch::regions
