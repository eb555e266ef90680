// Which format is asked for, and the writer for it.

#include <quadmatch/io/write_mesh.hpp>

#include <quadmatch/io/file.hpp>
#include <quadmatch/io/read_mesh.hpp>

#include "formats.hpp"

namespace quadmatch {

std::string format_mesh(const MeshFile& file, Format format, const WriteOptions& options) {
  switch (format) {
    case Format::Obj:
      return io::format_obj(file);
    case Format::Ply:
      return io::format_ply(file, options.ply);
    case Format::Off:
      return io::format_off(file);
    case Format::Usda:
      break;
  }
  return io::format_usda(file);
}

Expected<void> write_mesh(const std::string& path, const MeshFile& file, const WriteOptions& options) {
  const std::optional<Format> format = path == "-" ? Format::Obj : format_of_path(path);
  if (!format || path.ends_with(".usdc")) {
    return Unexpected(Error{ErrorCode::UnknownFormat,
                            "the name does not tell the format; end it in .obj, .ply, .off or .usda", path});
  }
  return replace_file(path, format_mesh(file, *format, options));
}

}  // namespace quadmatch
