#pragma once
/// Condition 4 of §2.1: any two quads meet in one edge, in one vertex, or not at all.

#include <compare>
#include <cstdint>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// Two quads that meet in more than they may, one < other.
struct Overlap {
  FaceId one, other;
  std::uint32_t shared_vertices = 0;
  std::uint32_t shared_edges = 0;  ///< edges of both faces with the same ends

  auto operator<=>(const Overlap&) const = default;
};

/// The pairs of quads that share two or three vertices otherwise than as the ends of one common edge; those that share
/// all four are duplicates. Quads that visit a vertex twice are left out.
///
/// @return      ascending. Where more than 32 quads share two vertices they would make a square number of pairs; there
///              each is held against one of them only, so that every quad is still named, in linear time.
/// @par Cost    O(#corners log d) where at most d quads meet at a vertex.
[[nodiscard]] std::vector<Overlap> overlapping_quads(const Mesh& mesh);

/// A face with the same vertices, in whatever order, as an earlier one.
struct Duplicate {
  FaceId face;
  FaceId original;  ///< the first face with these vertices

  auto operator<=>(const Duplicate&) const = default;
};

/// All faces that repeat an earlier one, ascending.
/// @par Cost    O(#corners log d) where at most d faces meet at a vertex.
[[nodiscard]] std::vector<Duplicate> duplicate_faces(const Mesh& mesh);

}  // namespace quadmatch
