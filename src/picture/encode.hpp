#pragma once
/// Pictures as bytes of a file.

#include <string>

#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/picture/picture.hpp>

namespace quadmatch::picture {

/// How long each frame stands, in milliseconds, so that all of the growth lasts some seconds.
[[nodiscard]] std::uint32_t frame_milliseconds(const MatchDrawing& drawing);
/// The last frame stands longer.
constexpr std::uint32_t kLastMilliseconds = 2400;

/// What a film is stored as.
enum class Film : std::uint8_t { Gif, Mp4 };

/// @par Errors  CannotWrite, where memory runs out; here and below without a path.
[[nodiscard]] Expected<std::string> as_png(const Raster& raster);
[[nodiscard]] Expected<std::string> as_webp(const MatchDrawing& drawing);

/// Is there a program of this name to call?
[[nodiscard]] bool has_ffmpeg();
/// @par Errors  CannotWrite, with what ffmpeg said.
[[nodiscard]] Expected<std::string> by_ffmpeg(const MatchDrawing& drawing, Film film);

}  // namespace quadmatch::picture
