#pragma once
/// What holds for any bytes: a reader says in one line what is wrong, or gives a mesh that is written and read again
/// as the same mesh. A broken promise aborts, which is how the fuzzer learns of it.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>

namespace quadmatch::fuzz {

inline void require(bool promise) {
  if (!promise) std::abort();
}

inline void require_one_line(const Error& error) {
  require(!error.message.empty());
  require(error.message.find_first_of("\r\n") == std::string::npos);
}

inline void require_same_mesh(const Mesh& one, const Mesh& other) {
  require(one.vertex_count() == other.vertex_count() && one.face_count() == other.face_count());
  require(std::equal(one.corners().begin(), one.corners().end(), other.corners().begin(), other.corners().end()));
  require(one.positions().empty() || std::equal(one.positions().begin(), one.positions().end(),
                                                other.positions().begin(), other.positions().end()));
}

inline void round_trip(const std::uint8_t* data, std::size_t size, Format format) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const Expected<MeshFile> file = parse_mesh(bytes, "fuzz", format);
  if (!file) return require_one_line(file.error());
  for (const PlyEncoding encoding : {PlyEncoding::Ascii, PlyEncoding::LittleEndian, PlyEncoding::BigEndian}) {
    const Expected<MeshFile> again = parse_mesh(format_mesh(*file, format, {.ply = encoding}), "again", format);
    require(again.has_value());
    require_same_mesh(file->mesh, again->mesh);
    if (format != Format::Ply) break;
  }
}

}  // namespace quadmatch::fuzz
