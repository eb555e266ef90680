#pragma once
/// The mirror of a mesh: which vertex and which face lies opposite which, by connectivity, in any pose.

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/use/transfer.hpp>

namespace quadmatch {

struct SymmetryOptions {
  /// Let positions weigh in where connectivity leaves a choice: edge lengths, and the plane of a model at rest.
  bool positions = true;
  /// Called now and then with faces matched so far and the most there can be; returning false cancels.
  std::function<bool(std::size_t matched, std::size_t most)> progress = {};
};

/// Where a mesh meets its mirror image: what lies on itself.
struct CentreLine {
  std::vector<VertexId> vertices = {};  ///< ascending
  /// Edges along the line, both ends on it; the lower end first, ascending.
  std::vector<std::pair<VertexId, VertexId>> edges = {};
  /// Edges the line crosses: their ends are each other's partners.
  std::vector<std::pair<VertexId, VertexId>> crossed_edges = {};
  std::vector<FaceId> faces = {};  ///< faces the line runs through, ascending

  [[nodiscard]] bool empty() const { return vertices.empty() && crossed_edges.empty() && faces.empty(); }
};

/// The plane that lays vertices on their partners best.
struct MirrorPlane {
  Point normal = {1, 0, 0};  ///< of length 1; its largest component is positive
  double offset = 0;         ///< points p of the plane have dot(normal, p) = offset
  /// How far a vertex's mirror image is from its partner in the middle of all pairs, as a share of the model's size.
  double error = 0;

  [[nodiscard]] Point mirrored(const Point& p) const;
  /// Are the positions those of a model at rest: does the plane lay at least half of it about where it belongs?
  [[nodiscard]] bool fits() const { return error <= 0.02; }
};

struct Symmetry {
  /// The mesh on itself, orientation reversing; a pair (q, r) comes with (r, q), in `vertices` too. Sound (see verify).
  Match match;
  CentreLine line;
  std::vector<FaceId> unpaired_faces;       ///< ascending
  std::vector<VertexId> unpaired_vertices;  ///< of those that a face uses, ascending
  std::uint32_t faces = 0, vertices = 0;    ///< of the mesh; vertices that a face uses
  /// Pairs of faces and of vertices; elements of the line are not counted.
  std::uint32_t face_pairs = 0, vertex_pairs = 0;
  /// How many mirrors, each with a centre line, fit the largest component as well, this one included.
  std::uint32_t mirrors = 0;
  /// There may be more of them: the search ended before all places had been tried, or the mesh is not symmetric as a
  /// whole.
  bool maybe_more = false;
  /// Not where the mesh has no positions or nothing is paired.
  std::optional<MirrorPlane> plane;
  bool complete = true;  ///< false after a cancel

  [[nodiscard]] bool whole() const { return faces > 0 && unpaired_faces.empty() && unpaired_vertices.empty(); }
};

/// Find the mirror of a mesh.
///
/// A mirror is a map of the mesh onto itself that turns it over and is its own inverse. Where several are as good, the
/// one is taken that has a centre line, whose edges are as long as their partners, and whose plane is nearest to x = 0.
///
/// @param mesh  any polygon mesh; components may be mirrored onto themselves or onto each other.
/// @return      the mirror, the same for the same input on every run.
/// @par Source  DESIGN: the orientation-reversing match of a mesh with itself (§3, Table 5.2 "across symmetries").
/// @par Cost    that of one match, O(F) more; a bounded number of trial growths, O(F) each, for a component that is
///              symmetric in several ways or symmetric and edited.
[[nodiscard]] Symmetry find_symmetry(const Mesh& mesh, const SymmetryOptions& options = {});

/// One side of a model: where the coordinate is larger, or smaller, than that of the partner.
struct MirrorSide {
  std::uint32_t axis = 0;  ///< 0 x, 1 y, 2 z
  bool positive = true;
};

/// Which faces lie on a side: 1 on it, -1 opposite, 0 on the centre line or without partner. Connected areas between
/// the lines are judged as a whole, so a pose that brings a hand across the middle does not matter.
/// @pre  the mesh has positions.
[[nodiscard]] std::vector<std::int8_t> sides_of_faces(const Mesh& mesh, const Symmetry& symmetry, MirrorSide side);

struct SymmetrizeOptions {
  MirrorSide from = {};
  /// What is copied; positions are mirrored in the plane, all else is copied as it is.
  Carry carry = positions_only();

  [[nodiscard]] static constexpr Carry positions_only() {
    Carry carry = Carry::nothing();
    carry.positions = true;
    return carry;
  }
};

struct Symmetrized {
  MeshFile file;
  std::uint32_t moved = 0;  ///< vertices that moved by more than rounding
  /// How far the farthest of them moved, in units of the file.
  double farthest = 0;
  /// What became of everything but positions.
  TransferReport report;
};

/// Copy one side of a mesh to the other.
///
/// @param symmetry  find_symmetry(file.mesh).
/// @return          the mesh with the same connectivity and numbering; what has no partner stays as it is. Vertices on
///                  the centre line are moved into the plane.
/// @par Errors      BadArgument where the mesh has no positions; where positions are to be copied and no plane fits,
///                  since the model is posed; where no face is on that side; where it has nothing of what is asked for.
/// @par Cost        O(size of the file).
[[nodiscard]] Expected<Symmetrized> symmetrize(const MeshFile& file, const Symmetry& symmetry,
                                               const SymmetrizeOptions& options = {});

}  // namespace quadmatch
