#pragma once
/// What was changed between two meshes: the parts that a match leaves out, and the places where matched faces are
/// joined otherwise, each named as the modeller's step that makes it.

#include <cstdint>
#include <optional>
#include <vector>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// What was done, from the source to the target. All but the last two come in pairs, each the other seen from the
/// target.
enum class ChangeKind : std::uint8_t {
  NewComponent,      ///< faces that hang together with nothing of the source
  RemovedComponent,  ///< likewise, of the target
  Addition,          ///< faces joined to what was boundary
  Deletion,          ///< faces taken away, a boundary is left
  InsertedLoop,      ///< rows of quads beside others, as an edge loop makes when it splits a row in two
  RemovedLoop,       ///< rows of quads taken out, what was on both sides of them joined
  Extrusion,         ///< a wall of faces around a patch that was lifted
  UndoneExtrusion,   ///< a wall taken out
  Opening,           ///< other faces between faces that were adjacent: a vertex or an edge was opened
  Collapse,          ///< faces taken out, and what was around them joined
  Refinement,        ///< an area divided more finely
  Coarsening,        ///< more coarsely
  Bridge,            ///< areas that were apart are joined by new faces: a handle, a tube
  UndoneBridge,      ///< a tube taken out and what it joined closed
  Rip,               ///< faces that were adjacent are not any more
  Weld,              ///< faces were joined along boundaries
  Reattachment,      ///< parts that are the same, joined at another place: turned by a quad, or sewn on elsewhere
  Reconnection,      ///< another connectivity within the same rim, of about as many faces
};

/// "new component", "inserted loop", ...
[[nodiscard]] const char* to_string(ChangeKind kind);

/// What the change from the target to the source is called.
[[nodiscard]] ChangeKind inverse(ChangeKind kind);

/// One area that is different, and what lies around it.
struct Change {
  ChangeKind kind = ChangeKind::Reconnection;
  /// How many rows of an inserted or removed loop there are; 0 for other kinds.
  std::uint32_t rows = 0;
  /// Faces that have no partner, ascending.
  std::vector<FaceId> source_faces = {}, target_faces = {};
  /// Faces that have one, but not the neighbours they had, on edges of this area; of the source, ascending.
  std::vector<FaceId> rejoined = {};
  /// Edges of these along which matched faces were adjacent and are not, or are and were not; where both occur, of the
  /// kind that is more frequent.
  std::uint32_t edges = 0;
  /// Vertices that have no partner on those faces, or at corners of faces around them; ascending.
  std::vector<VertexId> source_vertices = {}, target_vertices = {};

  /// Faces that came or went, or else are joined otherwise.
  [[nodiscard]] std::size_t size() const {
    const std::size_t unmatched = source_faces.size() + target_faces.size();
    return unmatched > 0 ? unmatched : rejoined.size();
  }
};

/// How a whole was moved: turned about some axis, scaled, shifted.
struct WholeMotion {
  double degrees = 0;  ///< 0 ... 180
  double scale = 1;
  bool mirrored = false;
  double shift = 0;  ///< of the centre of what is matched
};

/// A region that could lie otherwise, or for which little speaks.
struct DoubtfulRegion {
  std::size_t region = 0;  ///< its place in the match
  std::uint32_t faces = 0;
  FaceId first_source, first_target;  ///< of its first pair
  std::uint32_t ways = 1;             ///< maps of it that are as good
  bool ambiguous = false;             ///< else the confidence is low
  double confidence = 1;
  bool left_out = false;  ///< below `least_confidence`: its faces count as unmatched
};

struct DiffOptions {
  /// Say nothing of where vertices are, nor ask it where connectivity leaves a choice of names: whether a row of quads
  /// at a boundary was put on or split off.
  bool ignore_positions = false;
  /// A vertex has moved when it is farther from where it was than this share of the diagonal of the source's bounding
  /// box. The default passes over what six decimals of a text file round away.
  double tolerance = 2e-6;
  /// Take regions of which a smaller share of the extraordinary vertices agrees for unmatched, 0 ... 1.
  double least_confidence = 0;
};

/// Counts of elements; vertices are those that a face uses.
struct DiffTotals {
  std::uint32_t source_faces = 0, target_faces = 0;
  std::uint32_t source_vertices = 0, target_vertices = 0;
  std::uint32_t matched_faces = 0, matched_vertices = 0;
  std::uint32_t rejoined_faces = 0;  ///< matched, with other neighbours; pairs
  std::uint32_t turned_faces = 0;    ///< matched in a reversing region: wound the other way

  [[nodiscard]] std::uint32_t added_faces() const { return target_faces - matched_faces; }
  [[nodiscard]] std::uint32_t removed_faces() const { return source_faces - matched_faces; }
  [[nodiscard]] std::uint32_t added_vertices() const { return target_vertices - matched_vertices; }
  [[nodiscard]] std::uint32_t removed_vertices() const { return source_vertices - matched_vertices; }
};

struct Difference {
  /// From the largest; among equals by their first face of the source, then of the target.
  std::vector<Change> changes;
  DiffTotals totals;
  /// Matched vertices that are elsewhere, ascending by source; empty where positions are ignored or one mesh has none.
  std::vector<VertexPair> moved;
  /// All matched vertices moved as one rigid, evenly scaled body, and this is how.
  std::optional<WholeMotion> whole_motion;
  std::vector<DoubtfulRegion> doubtful;

  /// No change, no face turned over, no vertex moved.
  [[nodiscard]] bool none() const { return changes.empty() && totals.turned_faces == 0 && moved.empty(); }
};

/// Name the differences of two meshes.
///
/// Everything follows from connectivity: areas of unmatched faces on either side belong together where they meet the
/// same edges of matched faces, and what such an area stands between in both meshes says what it is
/// (docs/design/016-diff.md). diff(target, source) of the inverse match has the inverse kinds.
///
/// @param source, target  any polygon meshes.
/// @param match           from source to target, of any origin. Regions are taken together.
/// @return      the same for the same input on every run.
/// @par Errors  MatchDoesNotFit for a match that is not sound, with the first fault.
/// @par Cost    O(#V + #corners), and sorting of what is different.
[[nodiscard]] Expected<Difference> diff(const Mesh& source, const Mesh& target, const Match& match,
                                        const DiffOptions& options = {});

}  // namespace quadmatch
