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

/// What an attribute belongs to.
enum class Domain { Vertex, Corner, Face };

/// How a number is stored in the file; in memory all are doubles, which hold each of these exactly.
enum class ScalarType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float32, Float64 };

/// A pool of tuples, and which of them each corner uses: OBJ's `vt` and `vn`. Corners that share an index share the
/// value, so seams stay seams.
struct IndexedAttribute {
  static constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t components = 0;
  /// #tuples by `components`, row by row.
  std::vector<double> values;
  /// One per corner of the mesh, or kNoIndex.
  std::vector<std::uint32_t> corner_index;
};

/// A named value for every element of a domain: a PLY property, an OBJ vertex colour.
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

/// Elements that are no faces and are only carried along: OBJ's `l` and `p`, PLY's further elements, as text.
struct CarriedRecord {
  std::uint32_t before_face = 0;
  std::string text;
};

struct MeshFile {
  Mesh mesh;
  Format format = Format::Obj;
  /// As given, `-` for standard input.
  std::string path = {};

  std::optional<IndexedAttribute> texture_coordinates = {};
  std::optional<IndexedAttribute> normals = {};
  std::vector<Property> properties = {};
  std::vector<FaceRecord> face_records = {};
  std::vector<std::string> material_libraries = {};
  std::vector<CarriedRecord> carried = {};
  std::vector<std::string> comments = {};
  /// What the reader met and did not keep or had to guess, one sentence each, for the user.
  std::vector<std::string> notes = {};
};

}  // namespace quadmatch
