#pragma once
/// The elements of a merged mesh: which there are, in which order, and where each comes from.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/per_element.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>

#include "junctions.hpp"

namespace quadmatch::use {

struct MergedVertex {
  Side side = Side::Ours;  ///< whose vertex it is
  /// That vertex, and those of the others in whose place it is: at the first corner that all three have, else at the
  /// first that the other has.
  InThree<VertexId> in = {};
  std::uint32_t junction = kNoJunction;  ///< none for a vertex of no face

  static constexpr std::uint32_t kNoJunction = 0xffffffffU;
};

struct Layout {
  /// The cells that are faces of the result, those of OURS in its order, then those of THEIRS.
  std::vector<std::uint32_t> cells;
  /// The vertices of OURS in its order, and of THEIRS in the places of those it replaces or behind them.
  std::vector<MergedVertex> vertices;
  PerVertex<VertexId> of_ours, of_theirs;  ///< where a side's own vertices are, if they are in the result
};

/// Vertices of no face are merged by their positions: one that a side has put somewhere or taken away.
[[nodiscard]] Layout lay_out(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions);

/// Connectivity of the result, with the cells in the order of the layout.
[[nodiscard]] PolygonSoup soup_of(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions,
                                  const Layout& layout);

}  // namespace quadmatch::use
