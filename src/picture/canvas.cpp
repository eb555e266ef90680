// Whole numbers only, so that pixels do not depend on how a processor rounds.

#include "canvas.hpp"

namespace quadmatch::picture {
namespace {

/// A line along an edge covers this much of the face's colour, of 255.
constexpr std::uint32_t kEdgeStrength = 115;
/// Stripes of the hatching, in pixels, and how dark they are, of 255.
constexpr std::uint32_t kHatchPeriod = 9;
constexpr std::uint32_t kHatchWidth = 4;
constexpr std::uint32_t kHatchLight = 115;

/// One part of a colour, of what all rays of a pixel met.
std::uint32_t lit(std::uint8_t colour, std::uint8_t edge_colour, const Fragment& fragment, std::uint32_t light) {
  const std::uint32_t edge = fragment.edge * kEdgeStrength;
  constexpr std::uint32_t kWhole = 255 * 255;
  const std::uint32_t face = colour * light / 255;
  return fragment.rays * ((face * (kWhole - edge) + edge_colour * edge + kWhole / 2) / kWhole);
}

struct Sum {
  std::uint32_t red = 0, green = 0, blue = 0, rays = 0;

  void add(const Fragment& fragment, Rgb colour, std::uint32_t light) {
    red += lit(colour.red, kEdge.red, fragment, light);
    green += lit(colour.green, kEdge.green, fragment, light);
    blue += lit(colour.blue, kEdge.blue, fragment, light);
    rays += fragment.rays;
  }
};

std::uint8_t mixed(std::uint32_t sum, std::uint32_t rays, std::uint8_t background) {
  return static_cast<std::uint8_t>((sum + (kRays - rays) * background + kRays / 2) / kRays);
}

}  // namespace

Raster blank(std::uint32_t width, std::uint32_t height) {
  static_assert(kBackground.red == kBackground.green && kBackground.green == kBackground.blue);
  return {width, height, std::vector<std::uint8_t>(std::size_t{3} * width * height, kBackground.red)};
}

void paint(Raster& raster, std::uint32_t left, const Sight& sight, const std::function<Paint(FaceId)>& paint_of) {
  for (std::uint32_t y = 0; y < sight.height; ++y) {
    for (std::uint32_t x = 0; x < sight.width; ++x) {
      const std::size_t pixel = std::size_t{y} * sight.width + x;
      Sum sum;
      for (std::uint32_t k = sight.starts[pixel]; k < sight.starts[pixel + 1]; ++k) {
        const Fragment& fragment = sight.fragments[k];
        const auto [colour, hatched] = paint_of(fragment.face);
        const bool stripe = hatched && (x + y) % kHatchPeriod < kHatchWidth;
        sum.add(fragment, colour, stripe ? fragment.light * kHatchLight / 255 : fragment.light);
      }
      if (sum.rays == 0) continue;
      std::uint8_t* const at = raster.rgb.data() + 3 * (std::size_t{y} * raster.width + left + x);
      at[0] = mixed(sum.red, sum.rays, kBackground.red);
      at[1] = mixed(sum.green, sum.rays, kBackground.green);
      at[2] = mixed(sum.blue, sum.rays, kBackground.blue);
    }
  }
}

}  // namespace quadmatch::picture
