#pragma once
/// Colours on the half-edges that leave extraordinary vertices: as Algorithm 1 (§4.1), but each knows where it points.

#include <cstdint>
#include <vector>

#include <quadmatch/analysis/colouring.hpp>
#include <quadmatch/analysis/skeleton.hpp>

namespace quadmatch {

/// The colours of all spokes after every round; `rounds[r][spoke]` has seen what lies within r arcs.
struct SpokeColours {
  std::vector<std::vector<Colour>> rounds;

  [[nodiscard]] std::uint32_t last() const { return static_cast<std::uint32_t>(rounds.size()) - 1; }
};

/// Colour the spokes of a separatrix graph. A round mixes the colour of the spoke, of the opposite end of its arc, and
/// of its two neighbours about the vertex. Since a spoke has a direction, its neighbours need no least rotation, and a
/// colour that is unique in both meshes is an oriented anchor at once.
///
/// @param separatrices  trace_separatrices(mesh, codes).
/// @param rounds        how many to make; round 0, the code of the vertex, comes on top.
/// @param options       with arc lengths a colour is very safe; without, inserted edge loops do not disturb it.
/// @par Differs         §4.1 colours the vertices of the skeleton graph. A new extraordinary vertex puts crossings into
///                      far-away neighbourhoods of that graph, but none into the separatrix graph.
/// @par Cost            O(rounds * #spokes) time and memory.
[[nodiscard]] SpokeColours colour_spokes(const ArcGraph& separatrices, const PerFan<VertexCode>& codes,
                                         std::uint32_t rounds, const ColouringOptions& options = {});

/// Round 0: the colour of a spoke is the code of its vertex.
[[nodiscard]] std::vector<Colour> initial_spoke_colours(const ArcGraph& separatrices, const PerFan<VertexCode>& codes);

/// One more round. @param colours  one per spoke, of the round before.
[[nodiscard]] std::vector<Colour> refine_spoke_colours(const ArcGraph& separatrices, const PerFan<VertexCode>& codes,
                                                       const std::vector<Colour>& colours,
                                                       const ColouringOptions& options = {});

}  // namespace quadmatch
