#pragma once
/// What follows without a choice.

#include "partial.hpp"

namespace quadmatch::exact {

/// Exclude what cannot be in a region that holds the partial one, to a fixed point.
///
/// A face beyond the rim has one possible image. Where that pair does not fit, or there is none, both faces are out:
/// the image could only be hit from that face.
///
/// @param rim  entries beyond which nothing is open are taken out.
void propagate(Partial& partial, Rim& rim);

}  // namespace quadmatch::exact
