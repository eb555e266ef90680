#pragma once
/// Junctions: wherever cells meet in the same vertices, one of the three meshes decides how.

#include <cstdint>
#include <limits>
#include <vector>

#include "cells.hpp"

namespace quadmatch::use {

/// A junction is a smallest set of vertices of the three meshes in which the same corners lie. Where nothing is changed
/// it is one vertex of each mesh. Only the cells that a mesh has there, and which of their corners it joins, are looked
/// at; so to follow one mesh at each junction makes a mesh, as long as both ends of a changed cell follow the same.
struct Junction {
  bool by_ours = false, by_theirs = false;  ///< is it another than in the base?
  bool differs = false;                     ///< between the sides
  Side decides = Side::Ours;
  std::uint32_t area = kNoArea;  ///< the conflict it belongs to

  static constexpr std::uint32_t kNoArea = std::numeric_limits<std::uint32_t>::max();

  [[nodiscard]] bool by(Side side) const { return side == Side::Ours ? by_ours : by_theirs; }
  [[nodiscard]] bool in_conflict() const { return area != kNoArea; }
};

struct Junctions {
  std::vector<Junction> list;            ///< by their first corner
  std::vector<std::uint32_t> of_corner;  ///< by corners of the cells
  std::uint32_t areas = 0;               ///< conflicts, by their first junction

  [[nodiscard]] const Junction& at(std::uint32_t corner) const { return list[of_corner[corner]]; }
};

/// An edit is a connected set of junctions that a side changed, each sharing a face with the next. Where edits of both
/// sides share a face, and did not do the same, there is a conflict, and both are part of it as wholes. So all corners
/// of a face follow one mesh, or are joined in the same way in both; a face that only one side has is there or not as a
/// whole; and two faces share vertices only as they do in one of the three.
[[nodiscard]] Junctions find_junctions(const ThreeMeshes& meshes, const Cells& cells, Side preferred);

/// Does the result have the cell?
[[nodiscard]] bool is_present(const Cells& cells, const Junctions& junctions, std::uint32_t cell);

}  // namespace quadmatch::use
