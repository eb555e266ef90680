#pragma once
/// Carry data over: the target mesh with the source's data on the part that is matched.

#include <cstdint>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>

namespace quadmatch {

/// What becomes of the elements of the target that are not matched.
enum class Fill {
  Keep,    ///< the target's own value, where it has that attribute; objects take a new name whole
  None,    ///< no value
  Smooth,  ///< harmonic interpolation from the rim of the matched part; the nearest matched one's for what has no mean
};

/// Which data are carried.
struct Carry {
  bool texture_coordinates = true;  ///< `vt`, PLY's `texcoord`, and `s`, `t`, `u`, `v` of vertices
  bool colours = true;              ///< `red`, `green`, `blue`, `alpha`
  bool properties = true;           ///< all others that have a name
  bool groups = true;               ///< `o` and `g`
  bool materials = true;            ///< `usemtl` and `mtllib`
  bool smoothing = true;            ///< `s`
  bool normals = false;             ///< `vn`, and `nx`, `ny`, `nz` of vertices; they belong to the pose
  bool positions = false;

  /// Nothing at all.
  [[nodiscard]] static constexpr Carry nothing() { return {false, false, false, false, false, false, false, false}; }
};

struct TransferOptions {
  Carry carry = {};
  Fill fill = Fill::Keep;
  /// Number the result as the source: matched vertices and faces in its order, each face from the corner that lies on
  /// the first of the source's face; what is not matched follows in the target's order. Faces keep the target's
  /// winding, so in a reversing region corners run the other way from there.
  bool order = false;
  /// Carry regions that connectivity and positions cannot place for certain, too. Certain is, of an ambiguous region,
  /// also the row of quads beside one that is gone as a whole, if taking it out instead would leave another mesh.
  bool allow_ambiguous = false;
  /// Let positions decide: faces of an ambiguous region that did not move are certain.
  bool positions = true;
  /// Leave out regions of which a smaller share of the extraordinary vertices agrees, 0 ... 1.
  double least_confidence = 0;
};

/// What became of one attribute. Elements are those of the target, in its domain.
struct TransferredAttribute {
  /// "texture coordinates", "normals", "positions", the name of a property, or a record: "usemtl".
  std::string name;
  Domain domain = Domain::Vertex;
  std::uint32_t carried = 0;  ///< have the source's value
  std::uint32_t kept = 0;     ///< have the target's own
  std::uint32_t filled = 0;   ///< interpolated, or taken from the nearest
  std::uint32_t without = 0;  ///< have none: no index, 0, or an empty list
  /// What had to be changed to bring both together, a sentence each.
  std::vector<std::string> remarks = {};
};

/// A region from which nothing was carried, or where it is ambiguous only what is certain all the same.
struct LeftOutRegion {
  enum class Reason { Ambiguous, LowConfidence };
  Reason reason = Reason::Ambiguous;
  std::size_t region = 0;  ///< its place in the match
  std::uint32_t faces = 0;
  FaceId first_source, first_target;  ///< of its first pair
  std::uint32_t ways = 1;             ///< maps of it that are as good
  double confidence = 1;
};

struct TransferReport {
  std::vector<TransferredAttribute> attributes;
  std::vector<LeftOutRegion> left_out;
  std::uint32_t faces = 0, vertices = 0;                  ///< of the target; vertices that a face uses
  std::uint32_t matched_faces = 0, matched_vertices = 0;  ///< of those, the ones that take the source's data
  /// Some of `matched_faces` lie on the source turned over.
  bool reversing = false;

  /// Did all of the target take the source's data?
  [[nodiscard]] bool complete() const { return matched_faces == faces && matched_vertices == vertices; }
};

struct Transferred {
  MeshFile file;
  TransferReport report;
};

/// The target with the source's data on the matched part.
///
/// Data of corners follow the rotation and the orientation of their faces; corners that share an entry of a pool go on
/// sharing it, so seams stay seams. Attributes that only the target has stay as they are. An attribute of both takes a
/// type that holds the values of both.
///
/// @param source, target  any polygon meshes.
/// @param match           from source to target, of any origin.
/// @return      the target's mesh, format, comments and what it carries along; vertices and faces in the target's order
///              unless `order` is set.
/// @par Errors  MatchDoesNotFit for a match that is not sound, with the first fault; BadArgument where the source has
///              nothing of what is to be carried and no order is asked for, or positions are and it has none.
/// @par Cost    O(size of both files); Fill::Smooth solves sparse systems over the unmatched part.
[[nodiscard]] Expected<Transferred> transfer(const MeshFile& source, const MeshFile& target, const Match& match,
                                             const TransferOptions& options = {});

}  // namespace quadmatch
