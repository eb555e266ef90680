#pragma once
/// A trial: grow a ghost from one pair over faces that are still free, and weigh it before it counts.

#include <cstddef>

#include "mending.hpp"

namespace quadmatch::regions {

struct TrialRules {
  std::size_t most_faces = 4000;
  /// With lengths: faces that fit worse than this, in units of sigma, are left out.
  double worst_error = 4.0;
  /// Without: grow only from faces whose corners all agree, and cover at most the next beyond.
  bool cover_disagreeing = true;
  /// Take the seed itself, however badly it lies, and grow from it.
  bool any_seed = false;
};

/// Grow the bench's ghost from a pair, over free faces only. @return false if not even the first fits.
bool grow_trial(Workbench& bench, Candidate seed, const TrialRules& rules);

/// Make the ghost a region of its own. @pre its faces are free
void keep_trial(Workbench& bench);

}  // namespace quadmatch::regions
