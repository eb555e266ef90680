#pragma once
/// From pieces to the regions that users see, with their evidence, and to one vertex map.

#include <vector>

#include <quadmatch/mesh/match.hpp>

#include "split.hpp"

namespace quadmatch::regions {

/// The piece that each region of the patchwork became, kNoPiece for regions without faces.
using PieceOfRegion = std::vector<std::uint32_t>;
constexpr std::uint32_t kNoPiece = 0xffffffff;

/// Count for each piece the extraordinary vertices it touches, fan by fan, and those that agree.
/// @par Cost  O(#extraordinary vertices), by their valence.
void weigh_pieces(const Sides& sides, const Patchwork& patchwork, const PieceOfRegion& piece_of,
                  std::vector<Piece>& pieces);

/// @param pieces       sound, sharing no face.
/// @param orientation  Reversing: the target was laid in its mirror image; rotations are given for it as it was.
/// @return             regions in the order of the pieces; the vertex map is still empty.
[[nodiscard]] Match assemble(const Sides& sides, std::vector<Piece> pieces, Orientation orientation, bool with_waves);

/// The one-to-one vertex map of all regions, ascending by source; where they disagree the earlier one has its way.
/// @param regions  from the largest.
[[nodiscard]] std::vector<VertexPair> combined_vertices(const Mesh& source, const Mesh& target,
                                                        const std::vector<Region>& regions);

}  // namespace quadmatch::regions
