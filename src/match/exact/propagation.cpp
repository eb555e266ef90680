#include "propagation.hpp"

namespace quadmatch::exact {
namespace {

/// Exclude what lies beyond the rim and does not fit. True if anything was.
bool exclude_misfits(Partial& partial, Rim& rim) {
  bool excluded = false;
  const auto open_face = [&](Side side, HalfedgeId h) {
    return h.valid() && partial.is_open(side, partial.mesh(side).face(h));
  };
  std::size_t kept = 0;
  for (const Pair& inside : rim) {
    const Pair pair = beyond(partial, inside);
    const bool source_open = open_face(kSource, pair.source), target_open = open_face(kTarget, pair.target);
    if (!source_open && !target_open) continue;
    if (source_open && target_open && partial.fits(pair)) {
      rim[kept++] = inside;
      continue;
    }
    if (source_open) partial.exclude(kSource, partial.mesh(kSource).face(pair.source));
    if (target_open) partial.exclude(kTarget, partial.mesh(kTarget).face(pair.target));
    excluded = true;
  }
  rim.resize(kept);
  return excluded;
}

}  // namespace

void propagate(Partial& partial, Rim& rim) {
  while (exclude_misfits(partial, rim)) continue;
}

}  // namespace quadmatch::exact
