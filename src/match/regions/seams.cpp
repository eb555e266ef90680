#include <cstdint>
#include <vector>

#include "expansion.hpp"
#include "mending.hpp"

namespace quadmatch::regions {
namespace {

constexpr int kPasses = 2;

}  // namespace

std::size_t move_seams(Workbench& bench) {
  std::size_t changed = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    const std::vector<std::vector<HalfedgeId>> faces = faces_by_region(bench);
    std::size_t changed_now = 0;
    for (const std::uint32_t region : largest_first(faces)) {
      extend_region(bench, faces[region], region);
      changed_now += expand(bench, region);
    }
    changed += changed_now;
    if (changed_now == 0) break;
  }
  bench.ghost.restart();
  return changed;
}

}  // namespace quadmatch::regions
