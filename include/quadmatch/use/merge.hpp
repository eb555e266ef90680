#pragma once
/// Merge two edits of one mesh: three-way, by the matches of either side to the base.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/mesh/check.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>

namespace quadmatch {

/// One of the three meshes of a merge.
enum class Side : std::uint8_t { Base, Ours, Theirs };

/// An element by its number in each of the three meshes; not valid in those that have none like it.
template <class IdType>
struct InThree {
  std::array<IdType, 3> in = {};

  [[nodiscard]] IdType& operator[](Side side) { return in[static_cast<std::size_t>(side)]; }
  [[nodiscard]] IdType operator[](Side side) const { return in[static_cast<std::size_t>(side)]; }
  bool operator==(const InThree&) const = default;
};

struct MergeOptions {
  /// What the result holds where both sides changed the same: Ours or Theirs.
  Side prefer = Side::Ours;
};

/// What one side did to the base.
struct SideChanges {
  std::uint32_t matched_faces = 0;     ///< of the base, that this side has too
  std::uint32_t removed_faces = 0;     ///< of the base
  std::uint32_t added_faces = 0;       ///< of this side
  std::uint32_t changed_vertices = 0;  ///< of the base, whose faces are other ones or joined in another way
  std::uint32_t moved_vertices = 0;    ///< of the base, that are elsewhere

  [[nodiscard]] bool connectivity() const { return removed_faces + added_faces + changed_vertices > 0; }
};

/// Edits that meet: connected, and resolved as a whole. Elements ascending.
struct ConflictArea {
  std::vector<VertexId> base_vertices;    ///< where connectivity is changed
  std::vector<FaceId> base_faces;         ///< removed by one side and not by the other
  std::vector<FaceId> ours_faces;         ///< new, and not in the other side
  std::vector<FaceId> theirs_faces;       ///< new, and not in the other side
  std::vector<VertexId> merged_vertices;  ///< of the result, which holds the preferred side here
  Point centre = {};                      ///< of the base's vertices; of the others where the base has none here
};

/// Values that both sides changed, to different ones; the result has those of the preferred side.
struct ValueConflict {
  std::string name;  ///< "positions", "texture coordinates", "normals", the name of a property, or a record: "usemtl"
  Domain domain = Domain::Vertex;
  std::uint32_t count = 0;
  /// The first of them, by number in the result; at most ten.
  std::vector<std::uint32_t> first = {};
};

/// Values that were taken from a side that changed them.
struct MergedAttribute {
  std::string name;  ///< as in ValueConflict
  Domain domain = Domain::Vertex;
  std::uint32_t from_ours = 0, from_theirs = 0;  ///< elements whose value is other than the base's
  std::vector<std::string> remarks = {};
};

/// A part of a side that might lie elsewhere on the base, and in which the other side changed something: if so, that
/// change went to the wrong place.
struct DoubtfulPart {
  Side side = Side::Ours;
  std::size_t region = 0;  ///< its place in the match
  std::uint32_t faces = 0;
  FaceId first_base, first_side;  ///< of its first pair
  bool ambiguous = false;         ///< else: of low confidence
  std::uint32_t ways = 1;
  double confidence = 1;
};

struct MergeReport {
  SideChanges ours, theirs;
  std::uint32_t same_added_faces = 0;  ///< added by both sides in the same way, and once in the result
  std::vector<ConflictArea> areas;     ///< by their first element
  std::vector<ValueConflict> values;
  std::vector<MergedAttribute> attributes;
  std::vector<DoubtfulPart> doubtful;
  /// Seams and vertices of several fans of which the result has more than the sides have, and brought, together: none,
  /// since what a face or a vertex has around it is as in one of the three. Looked at all the same.
  std::vector<DepartureKind> new_departures;
  /// Vertices that stand where a side put them, carried along by how far the other side moved what is around them.
  std::uint32_t carried_along = 0;

  [[nodiscard]] bool clean() const { return areas.empty() && values.empty(); }
};

struct Merged {
  MeshFile file;
  /// Where each face of the result comes from: at least one of the three has it, corner by corner.
  std::vector<InThree<FaceId>> face_origins;
  /// The same of vertices that a face uses: for each mesh the vertex in whose place it is.
  std::vector<InThree<VertexId>> vertex_origins;
  MergeReport report;
};

/// The match of a side to the base, as `merge` wants it: preserving, and whole where both are the same up to numbering.
/// Meshes of the same faces in the same order are matched as they are numbered, without a search.
/// @param options  orientation and algorithm are not looked at.
/// @par Cost       as of `match`.
[[nodiscard]] Match match_side(const Mesh& base, const Mesh& side, const MatchOptions& options = {});

/// The mesh with both sides' changes to the base.
///
/// Faces that the match pairs are the same face. A face of the base that a side has lost was removed by it; one that
/// the base has not was added; one that both sides added in the same way is added once. Wherever faces of three meshes
/// meet in the same vertices, one mesh decides which faces there are and how they are joined: the side that changed it;
/// the preferred one, area by area, where both did and not in the same way. So every vertex of the result has its faces
/// from one of the three, and none is degenerate or joined to more faces that was not so before.
///
/// Positions and other data: the value of the side that changed it. A vertex that one side made, or joined anew, is
/// carried along by what the other moved around it. Data of a conflict area are those of the preferred side.
///
/// A side that changed nothing gives the other one back as it is. Else the result has the order, the format and the
/// comments of OURS; what is new of THEIRS follows, or stands at the end of the object it belongs to.
///
/// @param to_ours, to_theirs  from the base, of any origin; reversing regions are passed over.
/// @return      the merge, conflicts and all.
/// @par Errors  MatchDoesNotFit for a match that is not sound, with the first fault; BadArgument where both sides
///              changed the faces of the base and one has none of them left; what Mesh::build finds.
/// @par Cost    O(size of the files); where a side moves what the other changed, a sparse system over new vertices.
[[nodiscard]] Expected<Merged> merge(const MeshFile& base, const MeshFile& ours, const MeshFile& theirs,
                                     const Match& to_ours, const Match& to_theirs, const MergeOptions& options = {});

}  // namespace quadmatch
