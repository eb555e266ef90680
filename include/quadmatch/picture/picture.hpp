#pragma once
/// A match as a picture and as a film of its growth, drawn without a display (docs/design/022-pictures.md).

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>
#include <quadmatch/mesh/match.hpp>

namespace quadmatch {

/// From where both meshes are looked at. Home is where a report begins: from the front, slightly above and aside. The
/// others look along an axis; the front is where +z points, above where +y does.
enum class PictureView : std::uint8_t { Home, Front, Back, Left, Right, Above, Below };

struct PictureOptions {
  /// Of the whole picture in pixels, both meshes side by side; each 16 ... 8192.
  std::uint32_t width = 1280;
  std::uint32_t height = 640;
  PictureView view = PictureView::Home;
};

/// Pixels row by row from the top, each three bytes: red, green, blue (sRGB).
struct Raster {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<std::uint8_t> rgb = {};
};

/// Both meshes side by side, the source on the left: red where a face has no partner, else the colour of its region as
/// in a report, ambiguous regions hatched, edges of faces drawn where faces are large enough. What is seen of which
/// face is found once, by casting rays; pictures of it cost little more.
class MatchDrawing {
 public:
  /// @param source, target  any polygon meshes. Both are scaled to the same size.
  /// @param match           its waves make the frames; without them there is one wave.
  /// @pre        the match is sound for these meshes (see verify), and the options are in their ranges.
  /// @par Errors  BadArgument for a mesh without positions, or with one that is not finite; TooLarge where memory runs
  ///              out; CannotWrite where the program was built without the libraries that draw.
  /// @par Cost    O(F log F + width * height * log F) time; some 200 bytes a face of the larger mesh while it runs.
  [[nodiscard]] static Expected<MatchDrawing> make(const MeshFile& source, const MeshFile& target, const Match& match,
                                                   const PictureOptions& options = {});
  MatchDrawing(MatchDrawing&&) noexcept;
  MatchDrawing& operator=(MatchDrawing&&) noexcept;
  ~MatchDrawing();

  /// The match as it is at the end.
  [[nodiscard]] Raster image() const;
  /// One for each wave, at most kMostWaves, evenly chosen, and then the image.
  [[nodiscard]] std::size_t frame_count() const;
  /// A frame of the growth: what was just matched is bright, what comes later grey, and nothing is red before the last
  /// frame, which is the image. @pre k < frame_count()
  [[nodiscard]] Raster frame(std::size_t k) const;

  static constexpr std::size_t kMostWaves = 150;

 private:
  struct Parts;
  explicit MatchDrawing(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

/// Can a picture be written here under this name? It must end in .png.
/// @par Errors  BadArgument for another ending; CannotWrite where the program was built without what draws.
[[nodiscard]] Expected<void> can_write_image(const std::string& path);
/// The same of a film: .webp, or .gif and .mp4 where there is a program ffmpeg.
[[nodiscard]] Expected<void> can_write_animation(const std::string& path);

/// Write the image as PNG, all or nothing; the same drawing gives the same bytes.
/// @par Errors  those of can_write_image; CannotWrite, with the system's reason.
[[nodiscard]] Expected<void> write_image(const std::string& path, const MatchDrawing& drawing);

/// Write the growth, all or nothing, endlessly repeated where the format can say so. Lossless as WebP, where frames
/// that look alike become one; of at most 256 colours as GIF.
/// @par Errors  those of can_write_animation; CannotWrite, with the system's reason or that of ffmpeg.
[[nodiscard]] Expected<void> write_animation(const std::string& path, const MatchDrawing& drawing);

}  // namespace quadmatch
