#pragma once
/// Connected blocks of faces, halved and halved again: a region that loses few faces of a block loses fewer of a half.

#include <array>
#include <cstdint>
#include <random>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::exact {

/// Connected faces, each but the first beside an earlier one; the first is in the middle.
using Block = std::vector<FaceId>;

/// Cut a connected set of faces in two, around centres far from each other.
///
/// @param weights  the sizes of the two blocks are as these are to each other, as nearly as can be.
/// @param random   where to begin.
/// @return         two connected blocks that share no face and leave none out.
/// @pre            at least two faces
/// @par Cost       O(#faces), and O(#F) of the mesh.
[[nodiscard]] std::array<Block, 2> cut_in_two(const Mesh& mesh, const std::vector<FaceId>& faces,
                                              std::array<std::uint32_t, 2> weights, std::mt19937& random);

}  // namespace quadmatch::exact
