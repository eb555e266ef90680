#pragma once
/// The guarantee of §5, as instances: two meshes that are the same but for planted mismatches, with the match between
/// them, the boundary complexity δ of the mismatches and the width ε of what lies between them.

#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/polygon_soup.hpp>

namespace quadmatch::shapes {

enum class Surface : std::uint8_t { Grid, Tube, Torus, Sphere };

struct PlantedOptions {
  Surface surface = Surface::Grid;
  /// Quads across and along (around and along, where it is round); a sphere has six sides of width by width.
  std::uint32_t width = 30, height = 30;
  /// How many places are changed; fewer where there is no room for them.
  std::uint32_t places = 2;
  /// How large each is at most: faces of a hole or an inset patch, quads of a squeezed row, edges of a slit less one.
  std::uint32_t size = 2;
  /// How many quads are to lie between one place and another, or the boundary. What is left in the end is measured.
  std::uint32_t gap = 10;
  std::uint64_t seed = 1;
};

struct Planted {
  /// All quads; the target renumbered.
  PolygonSoup source, target;
  /// The planted match: one sound, orientation-preserving region. Where faces that survive cannot all be in one,
  /// because a vertex of one mesh is two of the other, it holds those that fit, from the least conflicting and lowest
  /// on.
  std::vector<FacePair> region;
  /// Pairs of the region from which growth may start: one at random in the middle of the region, at least ε/2 away from
  /// every rim as faces of the medial axis are (or as far as there is), and one at random anywhere.
  FacePair anchor, anywhere;
  /// The paper's δ, measured. Reading: "each connected mismatched region has boundary complexity at most δ" counts the
  /// edges of the matched region's rim that belong to one mismatch, edges which share vertices belonging together. The
  /// region is the same in both meshes, and so is the number. Edges where both meshes end do not count.
  std::uint32_t delta = 0;
  /// The paper's ε, measured, or less. Reading: "the medial axis of the matched region has a spanning tree T such that
  /// each edge of T has a cross-sectional width of at least ε". Wherever two places, or a place and the boundary, see
  /// each other, the axis runs between them; ε is the least number of quads on a way from one rim to another, stepping
  /// across vertices too, or once around the surface, less half of δ. So the bound is asked of every edge of the axis,
  /// not only of those of a best tree.
  std::uint32_t epsilon = 0;
  /// One line: what was planted where.
  std::string description;

  /// The premise of the guarantee: ε > 2 δ.
  [[nodiscard]] bool promised() const { return epsilon > 2 * delta; }
};

/// Change a mesh in several places at random, of random kinds: holes, patches cut out and set in again behind a wall,
/// rows of quads squeezed into edges (Fig. 4.2), slits.
/// @par Errors  BadArgument where width, height, places or size is 0, the surface is too small to exist, or no place
///              could be changed.
/// @par Cost    O(F) for each place and each place tried, 60 at most for each.
[[nodiscard]] Expected<Planted> plant_mismatches(const PlantedOptions& options);

/// Options at random, of sizes and gaps for which ε/δ lies about equally often anywhere from a half to three.
[[nodiscard]] PlantedOptions random_planted_options(std::uint64_t seed);

}  // namespace quadmatch::shapes
