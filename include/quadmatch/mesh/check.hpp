#pragma once
/// Is a mesh simple and well-formed (§2.1)? Its sizes, and every place where it departs, named by element.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// A condition of §2.1 that a mesh can break.
enum class DepartureKind {
  NotAQuad,             ///< a face of three, or of more than four corners
  DegenerateFace,       ///< a face that visits a vertex twice (a self loop where it does so at once)
  UnusedVertex,         ///< a vertex of no face
  DisconnectedVertex,   ///< condition 1: the faces around a vertex form several fans
  PinchedHole,          ///< condition 2: a boundary loop passes a vertex twice, so no disk closes the hole
  NonManifoldEdge,      ///< condition 3: an edge of more than two faces
  InconsistentWinding,  ///< two faces run along their common edge the same way
  NotOrientable,        ///< a component that no flipping of faces makes consistent (a Moebius strip)
  OverlappingFaces,     ///< condition 4: two quads share more than one edge or one vertex
  DuplicateFace,        ///< condition 4, at its worst: two faces with the same vertices
};

/// `kebab-case`, as in reports: "non-manifold-edge".
[[nodiscard]] const char* to_string(DepartureKind kind);

struct Departure {
  DepartureKind kind;
  /// One sentence that names the elements, 0-based: "f7 and f9 share two edges".
  std::string message;
};

/// A component: faces joined through shared vertices.
struct ComponentReport {
  std::uint32_t vertices = 0, edges = 0, faces = 0;
  std::uint32_t boundary_loops = 0;
  std::uint32_t extraordinary = 0;
  bool manifold = true;
  bool orientable = true;
  /// vertices - edges + faces, the Euler characteristic.
  std::int64_t euler = 0;
  /// Handles when orientable, crosscaps when not; none where the component is not manifold.
  std::optional<std::uint32_t> genus;
};

struct CheckReport {
  std::uint32_t vertices = 0;  ///< those that a face uses
  std::uint32_t edges = 0;     ///< distinct pairs of neighbouring vertices
  std::uint32_t faces = 0;
  std::uint32_t triangles = 0, quads = 0, larger = 0;
  std::uint32_t boundary_loops = 0;
  std::uint32_t extraordinary = 0;
  /// From the most faces to the fewest, ties by lowest face.
  std::vector<ComponentReport> components;
  /// How often each kind was found (index: DepartureKind).
  std::vector<std::size_t> departure_counts;
  /// At most `kept` of each kind, by kind, then by element.
  std::vector<Departure> departures;

  /// No departure at all: simple and well-formed in the sense of §2.1.
  [[nodiscard]] bool well_formed() const;
};

/// Check the simplicity and the four conditions of §2.1.
///
/// @param kept  how many departures of each kind to describe; all are counted.
/// @par Cost    O(#corners log #corners).
/// @par Reading §2.1's condition 2 asks that every hole be contractible. A boundary loop that is a simple cycle can
///              always be closed by a disk, so what can break it is a loop that passes a vertex twice.
[[nodiscard]] CheckReport check(const Mesh& mesh, std::size_t kept = 10);

}  // namespace quadmatch
