// PNG by libpng's simplified interface.

#include <png.h>

#include "encode.hpp"

namespace quadmatch::picture {

Expected<std::string> as_png(const Raster& raster) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = raster.width;
  image.height = raster.height;
  image.format = PNG_FORMAT_RGB;
  std::string bytes(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = bytes.size();
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, raster.rgb.data(), 0, nullptr) == 0) {
    return Unexpected(Error{ErrorCode::CannotWrite, std::string("the picture could not be encoded: ") + image.message});
  }
  bytes.resize(size);
  return bytes;
}

}  // namespace quadmatch::picture
