// Instead of all other files here, where the libraries that draw are missing: every way to a picture ends in a
// sentence.

#include <quadmatch/picture/picture.hpp>

namespace quadmatch {
namespace {

Error refusal(const std::string& path) {
  return {ErrorCode::CannotWrite,
          "this program was built without the libraries that draw; install libembree-dev, libpng-dev and libwebp-dev, "
          "then build again",
          path};
}

}  // namespace

struct MatchDrawing::Parts {};

MatchDrawing::MatchDrawing(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MatchDrawing::MatchDrawing(MatchDrawing&&) noexcept = default;
MatchDrawing& MatchDrawing::operator=(MatchDrawing&&) noexcept = default;
MatchDrawing::~MatchDrawing() = default;

Expected<MatchDrawing> MatchDrawing::make(const MeshFile& /*source*/, const MeshFile& /*target*/,
                                          const Match& /*match*/, const PictureOptions& /*options*/) {
  return Unexpected(refusal({}));
}

Raster MatchDrawing::image() const { return {}; }
std::size_t MatchDrawing::frame_count() const { return 0; }
Raster MatchDrawing::frame(std::size_t /*k*/) const { return {}; }

Expected<void> can_write_image(const std::string& path) { return Unexpected(refusal(path)); }
Expected<void> can_write_animation(const std::string& path) { return Unexpected(refusal(path)); }
Expected<void> write_image(const std::string& path, const MatchDrawing& /*drawing*/) {
  return Unexpected(refusal(path));
}
Expected<void> write_animation(const std::string& path, const MatchDrawing& /*drawing*/) {
  return Unexpected(refusal(path));
}

}  // namespace quadmatch
