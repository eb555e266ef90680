// WebP by libwebp's encoder of animations, which stores of each frame only what changed.

#include <memory>

#include <webp/encode.h>
#include <webp/mux.h>

#include "encode.hpp"

namespace quadmatch::picture {
namespace {

struct Release {
  void operator()(WebPAnimEncoder* encoder) const { WebPAnimEncoderDelete(encoder); }
};
using Encoder = std::unique_ptr<WebPAnimEncoder, Release>;

class FrameData {
 public:
  FrameData() { WebPDataInit(&data); }
  FrameData(const FrameData&) = delete;
  FrameData& operator=(const FrameData&) = delete;
  ~FrameData() { WebPDataClear(&data); }

  WebPData data = {};
};

Encoder encoder_of(const Raster& raster) {
  WebPAnimEncoderOptions options;
  if (WebPAnimEncoderOptionsInit(&options) == 0) return nullptr;
  options.anim_params.loop_count = 0;  // endlessly
  return Encoder(WebPAnimEncoderNew(static_cast<int>(raster.width), static_cast<int>(raster.height), &options));
}

bool add(WebPAnimEncoder* encoder, const Raster& raster, std::uint32_t milliseconds) {
  WebPConfig config;
  if (WebPConfigInit(&config) == 0) return false;
  config.lossless = 1;
  config.method = 2;  // more takes several times as long, for a few percent
  config.quality = 30;
  WebPPicture picture;
  if (WebPPictureInit(&picture) == 0) return false;
  picture.use_argb = 1;
  picture.width = static_cast<int>(raster.width);
  picture.height = static_cast<int>(raster.height);
  const bool added = WebPPictureImportRGB(&picture, raster.rgb.data(), static_cast<int>(3 * raster.width)) != 0 &&
                     WebPAnimEncoderAdd(encoder, &picture, static_cast<int>(milliseconds), &config) != 0;
  WebPPictureFree(&picture);
  return added;
}

Error failure(const char* reason) {
  return {ErrorCode::CannotWrite, std::string("the animation could not be encoded: ") + reason};
}

}  // namespace

Expected<std::string> as_webp(const MatchDrawing& drawing) {
  const std::size_t count = drawing.frame_count();
  const std::uint32_t step = frame_milliseconds(drawing);
  Encoder encoder;
  for (std::size_t k = 0; k < count; ++k) {
    const Raster raster = drawing.frame(k);
    if (!encoder) encoder = encoder_of(raster);
    if (!encoder) return Unexpected(failure("there is not enough memory"));
    if (!add(encoder.get(), raster, static_cast<std::uint32_t>(k) * step)) {
      return Unexpected(failure(WebPAnimEncoderGetError(encoder.get())));
    }
  }
  const auto end = static_cast<int>((count - 1) * step + kLastMilliseconds);
  FrameData film;
  if (WebPAnimEncoderAdd(encoder.get(), nullptr, end, nullptr) == 0 ||
      WebPAnimEncoderAssemble(encoder.get(), &film.data) == 0) {
    return Unexpected(failure(WebPAnimEncoderGetError(encoder.get())));
  }
  const std::uint8_t* const bytes = film.data.bytes;
  return std::string(bytes, bytes + film.data.size);
}

}  // namespace quadmatch::picture
