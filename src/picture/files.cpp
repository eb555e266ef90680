// Names of files tell what they hold; bytes are written all or nothing.

#include <algorithm>
#include <cctype>
#include <optional>

#include <fmt/format.h>

#include <quadmatch/io/file.hpp>
#include <quadmatch/picture/picture.hpp>

#include "encode.hpp"

namespace quadmatch {
namespace {

bool ends_in(const std::string& path, std::string_view ending) {
  if (path.size() <= ending.size()) return false;
  return std::equal(ending.begin(), ending.end(), path.end() - static_cast<std::ptrdiff_t>(ending.size()),
                    [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); });
}

std::optional<picture::Film> film_of(const std::string& path) {
  if (ends_in(path, ".gif")) return picture::Film::Gif;
  if (ends_in(path, ".mp4")) return picture::Film::Mp4;
  return std::nullopt;
}

Expected<void> write(const std::string& path, Expected<std::string> bytes) {
  if (bytes) return replace_file(path, *bytes);
  bytes.error().path = path;
  return Unexpected(bytes.error());
}

}  // namespace

std::uint32_t picture::frame_milliseconds(const MatchDrawing& drawing) {
  // Multiples of what a GIF can say.
  constexpr std::size_t kWhole = 6000, kShortest = 40, kLongest = 400, kStep = 10;
  return static_cast<std::uint32_t>(std::clamp(kWhole / drawing.frame_count(), kShortest, kLongest) / kStep * kStep);
}

Expected<void> can_write_image(const std::string& path) {
  if (ends_in(path, ".png")) return {};
  return Unexpected(
      Error{ErrorCode::BadArgument, "pictures are written as PNG; choose a name that ends in .png", path});
}

Expected<void> can_write_animation(const std::string& path) {
  if (ends_in(path, ".webp")) return {};
  if (!film_of(path)) {
    return Unexpected(Error{ErrorCode::BadArgument,
                            "the name does not tell how the animation is to be stored; end it in .webp, .gif or .mp4",
                            path});
  }
  if (picture::has_ffmpeg()) return {};
  return Unexpected(
      Error{ErrorCode::CannotWrite,
            "this needs the program ffmpeg, which is not there; install it, or choose a name that ends in "
            ".webp",
            path});
}

Expected<void> write_image(const std::string& path, const MatchDrawing& drawing) {
  if (Expected<void> able = can_write_image(path); !able) return able;
  return write(path, picture::as_png(drawing.image()));
}

Expected<void> write_animation(const std::string& path, const MatchDrawing& drawing) {
  if (Expected<void> able = can_write_animation(path); !able) return able;
  const std::optional<picture::Film> film = film_of(path);
  return write(path, film ? picture::by_ffmpeg(drawing, *film) : picture::as_webp(drawing));
}

}  // namespace quadmatch
