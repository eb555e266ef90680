#pragma once
/// One reader and one writer for each format; `read_mesh.cpp` and `write_mesh.cpp` choose among them.

#include <string>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/mesh/expected.hpp>

#include "line_chunks.hpp"
#include "text_buffer.hpp"

namespace quadmatch::io {

/// What to do about most of what can be wrong with a mesh file; closes a message.
inline constexpr const char* kMend = "correct it or export the mesh again";

/// Vertices that 32-bit ids can name.
inline constexpr std::uint64_t kMostVertices = 0xfffffffe;
/// Corners that half-edges can name.
inline constexpr std::uint64_t kMostCorners = 0x7fffffff;

/// Each reads text or bytes of its format; `name` stands in errors and is the path of the result.
[[nodiscard]] Expected<MeshFile> read_obj(LineChunks text, const std::string& name);
[[nodiscard]] Expected<MeshFile> read_ply(const FileBytes& bytes, const std::string& name);
[[nodiscard]] Expected<MeshFile> read_off(const FileBytes& bytes, const std::string& name);
[[nodiscard]] Expected<MeshFile> read_usda(const FileBytes& bytes, const std::string& name);

[[nodiscard]] std::string format_obj(const MeshFile& file);
[[nodiscard]] std::string format_ply(const MeshFile& file, PlyEncoding encoding);
[[nodiscard]] std::string format_off(const MeshFile& file);
[[nodiscard]] std::string format_usda(const MeshFile& file);

/// Empty: a file of no bytes.
[[nodiscard]] Unexpected<Error> empty_file(const std::string& name);

/// Build the mesh of a file whose faces have been checked, or say that it has none.
[[nodiscard]] Expected<Mesh> build_mesh(PolygonSoup soup, const std::string& name);

/// Faces of any size, gathered one by one: `face_starts` is made only when the first face comes that is no quad.
class FaceGatherer {
 public:
  void add_corner(std::uint32_t vertex) { soup_.corners.emplace_back(vertex); }
  /// Corners added since the last face.
  [[nodiscard]] std::size_t open_corners() const { return soup_.corners.size() - closed_; }
  void close_face() {
    const std::size_t end = soup_.corners.size();
    if (end - closed_ != 4 && soup_.face_starts.empty()) begin_starts();
    if (!soup_.face_starts.empty()) soup_.face_starts.push_back(static_cast<std::uint32_t>(end));
    closed_ = end;
    ++face_count_;
  }
  [[nodiscard]] std::uint32_t face_count() const { return face_count_; }
  [[nodiscard]] std::size_t corner_count() const { return soup_.corners.size(); }
  [[nodiscard]] PolygonSoup& soup() { return soup_; }

 private:
  void begin_starts() {
    for (std::size_t start = 0; start <= closed_; start += 4) {
      soup_.face_starts.push_back(static_cast<std::uint32_t>(start));
    }
  }

  PolygonSoup soup_;
  std::size_t closed_ = 0;
  std::uint32_t face_count_ = 0;
};

}  // namespace quadmatch::io
