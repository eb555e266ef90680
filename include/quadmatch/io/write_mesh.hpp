#pragma once
/// Writing meshes, all or nothing: a failure leaves an existing file as it was.

#include <string>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>

namespace quadmatch {

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

struct WriteOptions {
  PlyEncoding ply = PlyEncoding::LittleEndian;
};

/// Write a mesh with all it carries, in the format of the path's ending; `-` writes OBJ to standard output.
/// Numbers are written so that reading gives the same doubles back.
///
/// @par Errors  CannotWrite, UnknownFormat. The file is written aside and renamed when complete.
[[nodiscard]] Expected<void> write_mesh(const std::string& path, const MeshFile& file,
                                        const WriteOptions& options = {});

/// The bytes `write_mesh` would write.
[[nodiscard]] std::string format_mesh(const MeshFile& file, Format format, const WriteOptions& options = {});

}  // namespace quadmatch
