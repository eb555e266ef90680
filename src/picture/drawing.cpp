// A drawing is what is seen of both meshes, and for each face its region and the wave in which it was matched.

#include <quadmatch/picture/picture.hpp>

#include <algorithm>
#include <array>

#include <quadmatch/mesh/per_element.hpp>

#include "canvas.hpp"
#include "sight.hpp"

namespace quadmatch {
namespace {

using picture::Paint;

constexpr std::uint32_t kNoRegion = 0xffffffff;

/// What the match says of a face.
struct Fate {
  std::uint32_t region = kNoRegion;
  std::uint32_t wave = 0;
};

using Fates = PerFace<Fate>;

/// Of regions whose waves were not kept all faces are in the first.
Fates fates_of(const Mesh& mesh, const Match& match, FaceId FacePair::*side) {
  Fates fates(mesh.face_count(), Fate{});
  for (std::uint32_t r = 0; r < match.regions.size(); ++r) {
    const Region& region = match.regions[r];
    std::uint32_t wave = 0;
    for (std::size_t k = 0; k < region.faces.size(); ++k) {
      while (wave + 1 < region.waves.size() && k >= region.waves[wave]) ++wave;
      fates[region.faces[k].*side] = {r, wave};
    }
  }
  return fates;
}

std::size_t wave_count(const Match& match) {
  std::size_t count = 1;
  for (const Region& region : match.regions) count = std::max(count, region.waves.size());
  return count;
}

}  // namespace

struct MatchDrawing::Parts {
  PictureOptions options;
  std::array<picture::Sight, 2> sights;
  std::array<Fates, 2> fates;
  std::vector<bool> ambiguous;
  std::size_t waves = 1;

  [[nodiscard]] std::size_t shown_waves() const { return std::min(waves, kMostWaves); }

  /// The first wave that a frame does not show.
  [[nodiscard]] std::size_t end_of(std::size_t frame) const { return (frame + 1) * waves / shown_waves(); }

  template <class PaintOf>
  [[nodiscard]] Raster draw(const PaintOf& paint_of) const {
    Raster raster = picture::blank(options.width, options.height);
    std::uint32_t left = 0;
    for (std::size_t side = 0; side < sights.size(); ++side) {
      picture::paint(raster, left, sights[side], [&](FaceId face) { return paint_of(fates[side][face]); });
      left += sights[side].width;
    }
    return raster;
  }
};

MatchDrawing::MatchDrawing(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
MatchDrawing::MatchDrawing(MatchDrawing&&) noexcept = default;
MatchDrawing& MatchDrawing::operator=(MatchDrawing&&) noexcept = default;
MatchDrawing::~MatchDrawing() = default;

Expected<MatchDrawing> MatchDrawing::make(const MeshFile& source, const MeshFile& target, const Match& match,
                                          const PictureOptions& options) {
  // One after the other, so that the larger of both decides how much memory there must be.
  const std::uint32_t half = options.width / 2;
  Expected<picture::Sight> left = picture::look(source, options.view, half, options.height);
  if (!left) return Unexpected(left.error());
  Expected<picture::Sight> right = picture::look(target, options.view, options.width - half, options.height);
  if (!right) return Unexpected(right.error());
  auto parts = std::make_unique<Parts>(
      Parts{.options = options,
            .sights = {*std::move(left), *std::move(right)},
            .fates = {fates_of(source.mesh, match, &FacePair::source), fates_of(target.mesh, match, &FacePair::target)},
            .ambiguous = {},
            .waves = wave_count(match)});
  for (const Region& region : match.regions) parts->ambiguous.push_back(region.ambiguous);
  return MatchDrawing(std::move(parts));
}

Raster MatchDrawing::image() const {
  return parts_->draw([&](const Fate& fate) -> Paint {
    if (fate.region == kNoRegion) return {picture::kUnmatched};
    return {picture::region_colour(fate.region), parts_->ambiguous[fate.region]};
  });
}

std::size_t MatchDrawing::frame_count() const { return parts_->shown_waves() + 1; }

Raster MatchDrawing::frame(std::size_t k) const {
  if (k + 1 >= frame_count()) return image();
  const std::size_t begin = k == 0 ? 0 : parts_->end_of(k - 1);
  const std::size_t end = parts_->end_of(k);
  return parts_->draw([&](const Fate& fate) -> Paint {
    if (fate.region == kNoRegion || fate.wave >= end) return {picture::kWaiting};
    if (fate.wave >= begin) return {picture::kFront};
    return {picture::region_colour(fate.region), parts_->ambiguous[fate.region]};
  });
}

}  // namespace quadmatch
