#pragma once
/// What is seen of which face of a mesh, pixel by pixel.

#include <cstdint>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>

#include "camera.hpp"

namespace quadmatch::picture {

/// Rays for each pixel.
constexpr std::uint32_t kRays = 9;

/// What a pixel shows of one face.
struct Fragment {
  FaceId face;
  std::uint8_t rays = 0;   ///< how many of kRays met it
  std::uint8_t light = 0;  ///< how bright it is, of 255
  std::uint8_t edge = 0;   ///< how much of it is covered by lines along its edges, of 255
};

/// A pane of pixels, row by row from the top.
struct Sight {
  std::uint32_t width = 0, height = 0;
  std::vector<Fragment> fragments = {};
  /// Where the fragments of each pixel start, and where those of the last end.
  std::vector<std::uint32_t> starts = {};
};

/// Look at a mesh.
/// @par Errors  those of framed(); TooLarge where memory runs out.
/// @par Cost    O(F log F + #pixels log F).
[[nodiscard]] Expected<Sight> look(const MeshFile& file, PictureView view, std::uint32_t width, std::uint32_t height);

}  // namespace quadmatch::picture
