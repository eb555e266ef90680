// §4.4, "A False Start: The Greedy Algorithm": match as many quads as possible with each wave of the fire.
//
// Kept because the paper has it, and to show why lazy-greedy is needed: where one mesh has quads squeezed into edges
// the wave marches through at once, is out of phase ever after, and the cascade never stops (Fig 4.3).
//
// Reading: a wave takes the quads beyond the edges of the last one; those beyond a vertex only follow a wave later.

#include "growth.hpp"

namespace quadmatch {
namespace {

constexpr std::size_t kFacesBetweenReports = 1 << 16;

}  // namespace

bool grow_greedily(Growth& growth, const GrowthProgress& progress) {
  const Mesh& source = growth.source();
  const Mesh& target = growth.target();
  std::size_t burning = 0;  // the first face of the last wave
  std::size_t report = kFacesBetweenReports;
  while (burning < growth.matched_faces()) {
    const std::size_t wave_end = growth.matched_faces();
    for (; burning < wave_end; ++burning) {
      auto [s, t] = growth.order()[burning];
      for (std::uint32_t corner = source.size(source.face(s)); corner > 0; --corner) {
        const Candidate beyond{source.twin(s), target.twin(t)};
        if (beyond.source.valid() && beyond.target.valid() && growth.fits(beyond)) growth.accept(beyond);
        s = source.next(s);
        t = target.next(t);
      }
    }
    if (growth.matched_faces() > wave_end) growth.end_wave();
    if (progress && growth.matched_faces() >= report) {
      if (!progress(growth.matched_faces())) return false;
      report = growth.matched_faces() + kFacesBetweenReports;
    }
  }
  return true;
}

}  // namespace quadmatch
