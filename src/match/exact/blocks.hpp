#pragma once
/// Disjoint connected blocks of faces: a region that loses less than one face a block holds one of them whole.

#include <cstdint>
#include <random>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::exact {

/// Connected faces, each but the first beside an earlier one; the first is in the middle.
using Block = std::vector<FaceId>;

/// Part the faces that are free into blocks of about one size, around centres far from each other.
///
/// @param faces   of one component, each once.
/// @param free    for every face of the mesh: may it be in a block?
/// @param count   blocks wanted.
/// @param random  where to begin.
/// @return        `count` blocks, or fewer where there are not so many free faces; together they may leave out pieces
/// of
///                the free faces that hold no centre.
/// @par Cost      O(count * #faces).
[[nodiscard]] std::vector<Block> part_into_blocks(const Mesh& mesh, const std::vector<FaceId>& faces,
                                                  const PerFace<std::uint8_t>& free, std::uint32_t count,
                                                  std::mt19937& random);

}  // namespace quadmatch::exact
