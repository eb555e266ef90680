#pragma once
/// How a posed or sculpted model is stretched, place by place: learnt from what is matched, so that lengths can be
/// compared as if it were not.

#include "lengths.hpp"
#include "patchwork.hpp"

namespace quadmatch::regions {

/// Lengths as they would be after a stretch.
struct Stretched {
  Lengths lengths;
  PerFace<float> known;  ///< how well the stretch of each face is known: 1 amid matched faces, 0 far from all
  PerFace<float> error;  ///< how far lengths still differ about each face
};

/// The source's lengths as they would be in the target, were every face stretched as the matched faces about it are:
/// per face a symmetric tensor, the logarithm of how far lengths in each direction grow, fitted to the lengths of
/// matched faces some rings around. What fits badly there is heard less, so that a few rows that lie wrong do not
/// explain themselves. Far from all matched faces nothing is stretched.
/// @param scale  log of target size by source size, the stretch of the whole.
/// @par Cost     O(#faces), some tens of times.
[[nodiscard]] Stretched stretched(const Sides& sides, const Patchwork& patchwork, const Lengths& source,
                                  const Lengths& target, double scale);

}  // namespace quadmatch::regions
