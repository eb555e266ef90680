#pragma once
/// A shirt, the model of cloth: a surface with a boundary at waist, neck and both cuffs.

#include <cstdint>

#include <quadmatch/shapes/model.hpp>

namespace quadmatch::shapes {

enum class Sleeves { Short, Long };

/// 1,432 quads with short sleeves, 1,944 with long ones; genus 0, four boundary loops.
///
/// The faces of the shirt with short sleeves come first in the one with long sleeves too, with the same numbers and
/// first corners. A pocket on the wearer's left and a neckline lower in front make its map onto itself unique.
[[nodiscard]] Model shirt(Sleeves sleeves);

}  // namespace quadmatch::shapes
