#pragma once
/// The definition of a match (§3, made stronger so that vertex data can be carried), checked without any matcher.

#include <cstddef>
#include <string>
#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// Which sentence of the definition a match breaks.
enum class FaultKind {
  NoSuchElement,       ///< a face or vertex that the meshes do not have
  CornersDoNotFit,     ///< paired faces of unequal corner counts, or a rotation that does not exist
  FaceTwice,           ///< a face of either mesh in two pairs
  VertexNotAFunction,  ///< a source vertex with two images in one region
  VertexNotOneToOne,   ///< a target vertex hit by two source vertices of one region
  AdjacencyLost,       ///< faces adjacent to matched faces on one side only, or to faces that do not correspond
  NotConnected,        ///< a region whose source faces do not hang together across edges
  EmptyRegion,         ///< a region of no face
  BadVertexList,       ///< `vertices` is not one-to-one, names pairs of no region, or leaves out what it must list
};

struct Fault {
  FaultKind kind;
  std::string message;  ///< names the region and the elements
};

struct Verdict {
  /// Faults counted, at least faults.size().
  std::size_t fault_count = 0;
  /// The first `kept` ones, in order of region and pair.
  std::vector<Fault> faults;
  std::size_t matched_faces = 0;
  std::size_t largest_region = 0;
  /// Source vertices in `vertices`, each counted once.
  std::size_t matched_vertices = 0;

  [[nodiscard]] bool sound() const { return fault_count == 0; }
};

/// Check every sentence of the definition of a match, knowing nothing of how it was made.
///
/// A match is sound when in every region (1) paired faces have the same number of corners, (2) the corner pairs make a
/// vertex map that is a function and one-to-one, (3) two source faces are adjacent exactly when their target faces are,
/// across corresponding edges, (4) the source faces are connected across edges; and over all regions (5) no face is
/// used twice and (6) `vertices` is one-to-one, agrees with some region at every pair, and lists every vertex of a
/// matched face save those on which regions disagree.
///
/// @param kept  how many faults to describe; all are counted.
/// @par Cost    O(#V + #corners) time and memory over the matched part, and O(#V) of both meshes.
[[nodiscard]] Verdict verify(const Mesh& source, const Mesh& target, const Match& match, std::size_t kept = 10);

}  // namespace quadmatch
