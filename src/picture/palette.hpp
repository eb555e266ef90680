#pragma once
/// What colour a face has. The colours are those of reports: web/src/picture/colours.ts.

#include <array>
#include <cstdint>

namespace quadmatch::picture {

struct Rgb {
  std::uint8_t red = 0, green = 0, blue = 0;
  bool operator==(const Rgb&) const = default;
};

constexpr Rgb kBackground = {255, 255, 255};
/// Lines along edges of faces are mixed of this and the face's colour.
constexpr Rgb kEdge = {26, 26, 26};
constexpr Rgb kUnmatched = {214, 39, 40};
/// Faces that the growth has not reached yet.
constexpr Rgb kWaiting = {216, 216, 210};
/// Faces that the growth has just reached: the fire front.
constexpr Rgb kFront = {255, 238, 70};

/// Told apart with every common colour blindness, and none near the red (after Okabe and Ito).
constexpr std::array<Rgb, 8> kRegions = {{{86, 180, 233},
                                          {230, 189, 60},
                                          {0, 158, 115},
                                          {204, 151, 187},
                                          {60, 110, 178},
                                          {178, 214, 150},
                                          {148, 136, 118},
                                          {120, 210, 205}}};

[[nodiscard]] constexpr Rgb region_colour(std::uint32_t region) { return kRegions[region % kRegions.size()]; }

}  // namespace quadmatch::picture
