#pragma once
/// Pixels of what is seen, once every face has its colour.

#include <functional>

#include <quadmatch/picture/picture.hpp>

#include "palette.hpp"
#include "sight.hpp"

namespace quadmatch::picture {

/// How a face is painted.
struct Paint {
  Rgb colour;
  bool hatched = false;
};

/// A white picture.
[[nodiscard]] Raster blank(std::uint32_t width, std::uint32_t height);

/// Paint a pane into a picture, from this column on.
/// @pre  there is room for it.
void paint(Raster& raster, std::uint32_t left, const Sight& sight, const std::function<Paint(FaceId)>& paint_of);

}  // namespace quadmatch::picture
