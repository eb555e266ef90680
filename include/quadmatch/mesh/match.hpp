#pragma once
/// A match between two meshes (§3): one or more regions, each a map of connected faces that keeps adjacency both ways.
/// Only the data; `quadmatch/match/matcher.hpp` makes one and `quadmatch/verify/verify.hpp` judges it.

#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/mesh/ids.hpp>

namespace quadmatch {

/// Whether a region keeps the rotation system or turns it over.
enum class Orientation : std::uint8_t { Preserving, Reversing };

/// Face `source` on face `target`, both of n corners: corner i lies on corner (rotation + i) mod n when preserving,
/// (rotation - i) mod n when reversing.
struct FacePair {
  FaceId source;
  FaceId target;
  std::uint32_t rotation = 0;  ///< 0 ... n - 1

  bool operator==(const FacePair&) const = default;
};

/// The corner of the target face on which corner `corner` of the source face lies.
[[nodiscard]] constexpr std::uint32_t image_corner(Orientation orientation, std::uint32_t rotation,
                                                   std::uint32_t corner, std::uint32_t size) {
  const std::uint32_t sum = orientation == Orientation::Preserving ? rotation + corner : rotation + size - corner;
  return sum >= size ? sum - size : sum;
}

struct VertexPair {
  VertexId source;
  VertexId target;

  bool operator==(const VertexPair&) const = default;
};

/// What speaks for a region: extraordinary vertices it touches, and those that meet one of the same code
/// (valence, boundary, non-quads).
struct Evidence {
  std::uint32_t agreeing = 0;
  std::uint32_t source_extraordinary = 0;
  std::uint32_t target_extraordinary = 0;

  /// The share of extraordinary vertices touched that agree, in the mesh where it is larger; 1 where none is touched.
  [[nodiscard]] double confidence() const {
    const std::uint32_t touched =
        source_extraordinary < target_extraordinary ? source_extraordinary : target_extraordinary;
    return touched == 0 ? 1.0 : static_cast<double>(agreeing) / touched;
  }
  bool operator==(const Evidence&) const = default;
};

struct Region {
  Orientation orientation = Orientation::Preserving;
  /// In the order in which they grew; the first is the seed.
  std::vector<FacePair> faces = {};
  /// How many faces had been matched at the end of each wave, ascending; the last is faces.size(). Empty: not kept.
  std::vector<std::uint32_t> waves = {};
  Evidence evidence = {};
  /// How many maps of these faces are as good, this one included; where counting them all would take long, at least so
  /// many. More than 1: a symmetry, or several equal parts.
  std::uint32_t ways = 1;
  /// There are several ways, and positions did not choose among them: another map may be the true one.
  bool ambiguous = false;
};

struct Match {
  /// From the largest. No face of either mesh is in two pairs.
  std::vector<Region> regions;
  /// The combined vertex map, one-to-one, ascending by source; where regions disagree the larger one wins.
  std::vector<VertexPair> vertices;
  /// False where the search was cancelled before it had finished.
  bool complete = true;

  /// Faces matched, over all regions.
  [[nodiscard]] std::size_t matched_faces() const {
    std::size_t sum = 0;
    for (const Region& region : regions) sum += region.faces.size();
    return sum;
  }
};

/// The answer to "is there a region of at least so many faces?" (Theorem 3.2).
enum class Decision : std::uint8_t { NotAsked, Yes, No, Unknown };

/// What an exact search has shown of the largest region there can be (match/exact.hpp).
struct Optimality {
  /// No region has more faces.
  std::uint32_t bound = 0;
  /// The region found has as many as the bound, so none is larger.
  bool proved = false;
  /// Nodes of the search tree.
  std::uint64_t nodes = 0;
  /// Faces that were asked for; 0: the largest region was.
  std::uint32_t at_least = 0;
  Decision decision = Decision::NotAsked;

  bool operator==(const Optimality&) const = default;
};

}  // namespace quadmatch
