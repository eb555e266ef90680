#pragma once
/// One mesh of a report: what is drawn of it, as blocks of bytes and the figures that go with them.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>

#include "packer.hpp"

namespace quadmatch::report {

/// How positions are stored.
enum class Precision {
  None,     ///< there are none
  Grid,     ///< on a grid of 65,536 steps along the longest side of the box
  Float32,  ///< as they are, where faces are too small for the grid
};

struct MeshHeader {
  std::string path;
  std::uint32_t vertices = 0;
  std::uint32_t faces = 0;
  std::uint32_t corners = 0;
  bool all_quads = true;
  Precision precision = Precision::None;
  /// Bits of each corner, 0 where corners are steps.
  std::uint32_t corner_bits = 0;
  /// Lowest corner of the box, and the length of a step of the grid.
  std::array<double, 3> low = {};
  double step = 0;
  /// Names of objects, groups and materials, numbered in order of appearance.
  std::vector<std::string> names = {};
};

/// Append the blocks of a mesh, each name beginning with `side`:
/// positions, sizes, corners, skeleton, extraordinary, crossings, seams, records.
[[nodiscard]] MeshHeader add_mesh(Blocks& blocks, const std::string& side, const MeshFile& file);

}  // namespace quadmatch::report
