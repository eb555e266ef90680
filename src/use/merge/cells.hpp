#pragma once
/// The faces of three meshes laid on each other: a cell is a face that one, two or three of them have.

#include <array>
#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/use/merge.hpp>

namespace quadmatch::use {

inline constexpr std::array<Side, 3> kSides{Side::Base, Side::Ours, Side::Theirs};

[[nodiscard]] constexpr Side other(Side side) { return side == Side::Ours ? Side::Theirs : Side::Ours; }

using ThreeMeshes = std::array<const Mesh*, 3>;

[[nodiscard]] inline const Mesh& mesh_of(const ThreeMeshes& meshes, Side side) {
  return *meshes[static_cast<std::size_t>(side)];
}

/// Cells in order: those of OURS as it has them, those of THEIRS that OURS has not, those that only the base has.
struct Cells {
  std::vector<InThree<FaceId>> faces;
  std::vector<std::uint32_t> first_corner;   ///< where the corners of each begin, with the total at the end
  std::vector<InThree<HalfedgeId>> corners;  ///< in the order of the face, from that of OURS, THEIRS or the base
  std::uint32_t same_added = 0;              ///< of both sides and not of the base
};

/// Lay the sides on the base by sound matches, and what is new on both sides on each other: from edges that all three
/// have, face by face, where new faces that hang together are the same as a whole. Nothing hangs on it that they are:
/// what is laid on each other and joined in another way is a conflict.
[[nodiscard]] Cells lay_cells(const ThreeMeshes& meshes, const Match& to_ours, const Match& to_theirs);

}  // namespace quadmatch::use
