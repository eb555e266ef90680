#pragma once
/// A mesh file in memory: the connectivity, and beside it everything else the file said, so that nothing is lost
/// when it is written again.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

enum class Format { Obj, Ply, Off, Usda };

/// What an attribute belongs to; Further is an element of a PLY file that is neither vertex nor face.
enum class Domain { Vertex, Corner, Face, Further };

/// How a number is stored in the file; in memory all are doubles, which hold each of these exactly.
enum class ScalarType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// A pool of tuples, and which of them each corner uses: OBJ's `vt` and `vn`. Corners that share an index share the
/// value, so seams stay seams.
struct IndexedAttribute {
  static constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t components = 0;
  /// #tuples by `components`, row by row.
  std::vector<double> values = {};
  /// One per corner of the mesh, or kNoIndex.
  std::vector<std::uint32_t> corner_index = {};
};

/// A named value for every element of a domain: a PLY property, an OBJ vertex colour (`red`, `green`, `blue`, `alpha`
/// and the weight `w`).
struct Property {
  std::string name;
  Domain domain = Domain::Vertex;
  ScalarType type = ScalarType::Float32;
  /// For a list property: the type of its counts, and where each element's values start (#elements + 1 numbers).
  std::optional<ScalarType> count_type = {};
  std::vector<std::uint32_t> list_starts = {};
  std::vector<double> values = {};
};

/// A record that holds from a face on: `o body`, `g arm`, `s 1`, `usemtl skin`.
struct FaceRecord {
  std::uint32_t first_face = 0;  ///< may equal the number of faces: a record after the last face
  std::string keyword;
  std::string value;
};

/// A line that is only carried along, and written again to files of the same format: OBJ's `l` and `p` with absolute
/// indices, PLY's `obj_info`.
struct CarriedRecord {
  std::uint32_t before_face = 0;    ///< may equal the number of faces
  std::uint32_t before_record = 0;  ///< how many FaceRecords stand above it
  std::string text;
};

/// An element of a PLY file that is neither vertex nor face, e.g. its edges: carried along, not understood.
struct FurtherElement {
  std::string name;
  std::uint32_t count = 0;
  std::vector<Property> properties = {};  ///< of domain Further
};

struct MeshFile {
  Mesh mesh;
  Format format = Format::Obj;
  /// As given, `-` for standard input.
  std::string path = {};
  /// How a PLY file stores, and stored, the positions.
  ScalarType position_type = ScalarType::Float64;

  std::optional<IndexedAttribute> texture_coordinates = {};
  std::optional<IndexedAttribute> normals = {};
  std::vector<Property> properties = {};
  std::vector<FaceRecord> face_records = {};
  std::vector<std::string> material_libraries = {};
  std::vector<CarriedRecord> carried = {};
  std::vector<FurtherElement> further_elements = {};
  /// Without the sign that begins a comment and one blank.
  std::vector<std::string> comments = {};
  /// What the reader met and did not keep or had to guess, one sentence each, for the user.
  std::vector<std::string> notes = {};
};

}  // namespace quadmatch
