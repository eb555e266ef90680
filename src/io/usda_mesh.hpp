#pragma once
/// What a Mesh prim of a USD text file says, and how several of them become one mesh.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>

#include "formats.hpp"

namespace quadmatch::io {

/// Values of a mesh that need not lie on its vertices, with indices into them or without.
struct UsdaPrimvar {
  std::string name;
  std::uint32_t components = 0;
  std::vector<double> values;
  std::optional<std::vector<std::int64_t>> indices;
  std::string interpolation;
};

struct UsdaMesh {
  std::string name;
  std::vector<double> points;  ///< x, y, z of each
  std::vector<std::int64_t> face_vertex_counts;
  std::vector<std::int64_t> face_vertex_indices;
  std::uint64_t points_line = 0, counts_line = 0, indices_line = 0;
  bool left_handed = false;
  std::vector<UsdaPrimvar> primvars;

  /// The primvar of this name, made if it is new.
  [[nodiscard]] UsdaPrimvar& primvar(std::string_view primvar_name);
};

/// Joins the meshes of a file, in its order.
class UsdaCollector {
 public:
  explicit UsdaCollector(const std::string& name) : name_(name) {}

  /// Add a mesh. False if its faces do not fit its points, with the reason in `error`.
  [[nodiscard]] bool add(const UsdaMesh& mesh);
  /// Build what was added. The result has all but comments and the notes of the parser.
  [[nodiscard]] Expected<MeshFile> finish();

  Error error;

 private:
  /// Of each corner of the latest mesh, in the order in which it is stored: where the file lists it, its vertex, face.
  struct Corner {
    std::size_t listed;
    std::size_t vertex;
    std::size_t face;
  };

  bool check_counts(const UsdaMesh& mesh);
  bool add_faces(const UsdaMesh& mesh);
  bool fail(const UsdaMesh& mesh, ErrorCode code, const std::string& message, std::uint64_t line);
  void add_primvar(const UsdaMesh& mesh, const UsdaPrimvar& primvar, IndexedAttribute& pool);

  const std::string& name_;
  FaceGatherer faces_;
  std::vector<Corner> corners_;
  IndexedAttribute texture_{.components = 2};
  IndexedAttribute normals_{.components = 3};
  std::vector<FaceRecord> records_;
  std::vector<std::string> notes_;
};

}  // namespace quadmatch::io
