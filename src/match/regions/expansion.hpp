#pragma once
/// An expansion move (Boykov, Veksler & Zabih 2001): carry a map on as a ghost, over faces that others have, and let a
/// minimum cut say which of them are better off with it.

#include <cstddef>
#include <vector>

#include "mending.hpp"

namespace quadmatch::regions {

/// Faces that a ghost from a seed may cover; that all seeds of a stage may cover, by faces of the source; and what a
/// seed costs beside its faces. So that no stage is more than linear.
constexpr std::size_t kSeedFaces = 20000, kSeedsBudget = 6, kSeedCost = 16;

/// Carry a region's map on beyond its rim, in the bench's ghost.
/// @param faces  entry half-edges of the faces to begin from; those that are not in the region are passed over.
void extend_region(Workbench& bench, const std::vector<HalfedgeId>& faces, std::uint32_t region,
                   std::size_t most_faces);

/// Grow a map from one pair, whoever has the faces.
/// @param near_only  give up as well where faces land far from their images. @pre the misfit is placed
/// @return           false if the pair does not fit at all.
bool extend_seed(Workbench& bench, Candidate seed, std::size_t most_faces, bool near_only = false);

/// How many faces a region of so many may be carried on over.
[[nodiscard]] constexpr std::size_t most_faces_beyond(std::size_t faces) { return 3 * faces + 3000; }

/// Give those faces of the ghost to a region that are better off with it.
/// @param least_gain  nothing changes if the sum of all costs falls by less.
/// @return  faces whose partner changed.
/// @par Cost  that of a minimum cut over the ghost's faces.
std::size_t expand(Workbench& bench, std::uint32_t region, double least_gain = 0);

/// The pairs of the ghost that would change their faces' partners if that were rewarded, face by face; changes nothing.
[[nodiscard]] std::vector<Candidate> would_join(Workbench& bench, double reward);

}  // namespace quadmatch::regions
