#pragma once
/// The stages after the fire, each a function of its own that mends one kind of flaw. They share the patchwork, the
/// costs, and one ghost to try things with.

#include <cstdint>
#include <optional>
#include <vector>

#include "ghost.hpp"
#include "misfit.hpp"
#include "patchwork.hpp"
#include "rim.hpp"
#include "vertex_grid.hpp"

namespace quadmatch::regions {

/// What all of them work on.
struct Workbench {
  const Sides& sides;
  Patchwork& patchwork;
  Misfit& misfit;
  Ghost& ghost;
  Rim& rim;
  std::optional<VertexGrid> target_grid = std::nullopt;  ///< once it was asked where the source lies
};

struct SizedRegion {
  std::uint32_t number, faces;
};
/// The regions, from the most faces to the fewest; those without faces are left out.
[[nodiscard]] std::vector<SizedRegion> largest_first(const Patchwork& patchwork);

/// By number, the entry half-edges of the faces of these regions, in the order in which they were matched; none of any
/// other.
[[nodiscard]] std::vector<std::vector<HalfedgeId>> faces_by_region(const Workbench& bench,
                                                                   const std::vector<SizedRegion>& regions);

/// For each region, what Patchwork::changes() was when its seams were last found to be where they belong.
using SeamsAtRest = std::vector<std::uint32_t>;

/// Seams: carry every region's map on over its neighbours, and let a minimum cut say which faces are better off with
/// it (an expansion move of Boykov, Veksler & Zabih 2001). Exact for zigzags, and for seams in flat stretches.
/// @param rest  from the last call; regions about which nothing has changed since are passed over.
/// @return      faces whose partner changed.
std::size_t move_seams(Workbench& bench, SeamsAtRest& rest);

/// Lift every pair that costs more than leaving its face unmatched, unless neighbours hold it. @return faces lifted.
std::size_t drop_misfits(Workbench& bench);

/// Slivers: unmatched faces beside matched ones that regions cannot take in, such as one side of a rip, become regions
/// of their own where their neighbours say together what they lie on.
/// @param generous  without lengths, one neighbour is enough even where a corner or two disagree.
/// @return          faces matched.
std::size_t match_slivers(Workbench& bench, bool generous = false);

/// Islands: parts cut off by new faces. Hop over one or two unmatched quads of one mesh, and try where one lands.
/// @return faces matched.
std::size_t match_islands(Workbench& bench);

/// Ventures: without lengths, carry every region's map on past corners that disagree, as far as what agrees beyond
/// them bears it out. @return faces matched.
std::size_t venture_on(Workbench& bench);

/// Slides: offer the map moved by one quad wherever lengths fit badly, or, without lengths, corners. @return faces
/// whose partner changed.
std::size_t undo_slides(Workbench& bench);
/// Where lengths fit badly, would many of them fit well one quad on? @pre misfit uses lengths
[[nodiscard]] bool slides_explain(Workbench& bench);

/// Turns: offer what hangs on the rest by a closed ring of quads turned about it, as a whole. @return faces whose
/// partner changed. @pre not placed
std::size_t undo_turns(Workbench& bench);

/// Rows: where a row of quads was removed or inserted, let what is left free be a whole row, from end to end. @return
/// faces whose partner changed.
std::size_t straighten_rows(Workbench& bench);

/// Find out where the source lies in the space of the target, for misfit's distances; nowhere, if the model is posed.
void place(Workbench& bench);

/// Exact ties, by positions: where the source, placed as a whole, lands on other faces than it is matched to, offer
/// those. @return faces whose partner changed. @pre placed
std::size_t settle_ties(Workbench& bench);

/// Restarts: where all else has left large parts free, try faces with rare corners against each other.
/// @return  faces matched.
std::size_t restart(Workbench& bench);

/// Lookalikes: where a free part has no rare corner either, try its inner faces where lengths fit best.
/// @return  faces matched; 0 where lengths were not learnt, or the source is placed as a whole.
std::size_t match_lookalikes(Workbench& bench);

/// Lift the regions that chance may have brought together. @return faces lifted.
std::size_t drop_unlikely(Workbench& bench);

/// Doubts: faces that lie as well on something else, as far as corners, lengths and neighbours tell, form regions of
/// their own. @return these regions
std::vector<std::uint32_t> set_doubts_apart(Workbench& bench);

}  // namespace quadmatch::regions
