#pragma once
/// The words by which users of every front end name the choices of a match.

#include <array>
#include <cstddef>
#include <utility>

#include <quadmatch/match/matcher.hpp>

namespace quadmatch {

/// Words and what they stand for, in the order in which they are told.
template <class Meaning, std::size_t kCount>
using Words = std::array<std::pair<const char*, Meaning>, kCount>;

inline constexpr Words<Algorithm, 4> kAlgorithmWords{{{"regions", Algorithm::Regions},
                                                      {"lazy-greedy", Algorithm::LazyGreedy},
                                                      {"greedy", Algorithm::Greedy},
                                                      {"exact", Algorithm::Exact}}};

inline constexpr Words<OrientationChoice, 3> kOrientationWords{{{"auto", OrientationChoice::Auto},
                                                                {"preserving", OrientationChoice::Preserving},
                                                                {"reversing", OrientationChoice::Reversing}}};

/// Stages of regions that can be left out, in the order of Stages.
inline constexpr Words<bool Stages::*, 12> kStageWords{{{"equal-parts", &Stages::equal_parts},
                                                        {"seams", &Stages::seams},
                                                        {"ties", &Stages::ties},
                                                        {"slides", &Stages::slides},
                                                        {"turns", &Stages::turns},
                                                        {"ventures", &Stages::ventures},
                                                        {"slivers", &Stages::slivers},
                                                        {"islands", &Stages::islands},
                                                        {"restarts", &Stages::restarts},
                                                        {"rows", &Stages::rows},
                                                        {"acceptance", &Stages::acceptance},
                                                        {"doubts", &Stages::doubts}}};

}  // namespace quadmatch
