// Films of the growth, frame by frame, read back by libwebp.

#include <doctest/doctest.h>

#include <memory>

#include <webp/demux.h>
#include <quadmatch/io/file.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/figures.hpp>

#include "pixels.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

MatchDrawing draw(const MeshFile& source, const MeshFile& target, const Match& match) {
  Expected<MatchDrawing> drawing =
      MatchDrawing::make(source, target, match, {.width = 400, .height = 200, .view = PictureView::Front});
  REQUIRE(drawing.has_value());
  return *std::move(drawing);
}

struct Frame {
  Raster raster;
  int end = 0;  ///< in milliseconds
};

struct Release {
  void operator()(WebPAnimDecoder* decoder) const { WebPAnimDecoderDelete(decoder); }
};

std::vector<Frame> read_webp(const std::string& path) {
  const Expected<FileBytes> bytes = read_file(path);
  REQUIRE(bytes.has_value());
  const WebPData data{reinterpret_cast<const std::uint8_t*>(bytes->begin()), bytes->size()};
  const std::unique_ptr<WebPAnimDecoder, Release> decoder(WebPAnimDecoderNew(&data, nullptr));
  REQUIRE(decoder != nullptr);
  WebPAnimInfo info;
  REQUIRE(WebPAnimDecoderGetInfo(decoder.get(), &info) != 0);
  CHECK(info.loop_count == 0);
  std::vector<Frame> frames;
  while (WebPAnimDecoderHasMoreFrames(decoder.get()) != 0) {
    std::uint8_t* rgba = nullptr;
    Frame frame{{info.canvas_width, info.canvas_height, {}}, 0};
    REQUIRE(WebPAnimDecoderGetNext(decoder.get(), &rgba, &frame.end) != 0);
    for (std::size_t k = 0; k < std::size_t{4} * info.canvas_width * info.canvas_height; ++k) {
      if (k % 4 != 3) frame.raster.rgb.push_back(rgba[k]);
    }
    frames.push_back(std::move(frame));
  }
  return frames;
}

}  // namespace

TEST_CASE("each frame shows one wave more: what was reached before in its colour, the front bright, the rest grey") {
  const MeshFile file = file_of(shapes::grid(4, 4));
  const MatchDrawing drawing = draw(file, file, on_itself(file.mesh, {5}));
  REQUIRE(drawing.frame_count() == 16);  // fifteen waves of one face, and the picture
  const SeenGrid seen(4, 200);
  for (std::size_t k = 0; k + 1 < 16; ++k) {
    const int front = static_cast<int>(k < 5 ? k : k + 1);  // face 5 is never reached
    const Raster raster = drawing.frame(k);
    for (std::uint32_t y = 0; y < 200; ++y) {
      for (std::uint32_t x = 0; x < 400; ++x) {
        const int square = seen.square_at(x % 200, y);
        if (square < 0) continue;
        const Pixel p = pixel(raster, x, y);
        REQUIRE_FALSE(is_red(p));
        REQUIRE(is_front(p) == (square == front));
        REQUIRE(is_grey(p) == (square > front || square == 5));
      }
    }
  }
}

TEST_CASE("the last frame is the picture, and there are never more than a hundred and fifty waves") {
  for (const std::uint32_t n : {1U, 4U, 12U, 13U, 25U}) {
    const MeshFile file = file_of(shapes::grid(n, n));
    const MatchDrawing drawing = draw(file, file, on_itself(file.mesh));
    CHECK(drawing.frame_count() == std::min<std::size_t>(n * n, MatchDrawing::kMostWaves) + 1);
    CHECK((drawing.frame(drawing.frame_count() - 1).rgb == drawing.image().rgb));
    if (n == 1) continue;
    // The last wave is shown before it, whole.
    const Raster last = drawing.frame(drawing.frame_count() - 2);
    const SeenGrid seen(n, 200);
    for (std::uint32_t y = 0; y < 200; ++y) {
      for (std::uint32_t x = 0; x < 200; ++x) {
        if (seen.square_at(x, y) >= 0) REQUIRE_FALSE(is_grey(pixel(last, x, y)));
      }
    }
  }
}

TEST_CASE("a match without waves has one, and its film two frames") {
  const MeshFile file = file_of(shapes::grid(4, 4));
  Match match = on_itself(file.mesh);
  match.regions.front().waves.clear();
  CHECK(draw(file, file, match).frame_count() == 2);
  CHECK(draw(file, file, {}).frame_count() == 2);
}

TEST_CASE("a film read back has a frame for each wave of the match, to the last pixel, and the picture at the end") {
  const shapes::Figure41 first = shapes::fig_4_1();
  const shapes::Figure42 second = shapes::fig_4_2();
  const MeshFile source = file_of(first.soup), target = file_of(second.soup);
  for (const Algorithm algorithm : {Algorithm::Greedy, Algorithm::LazyGreedy}) {
    MatchOptions options;
    options.algorithm = algorithm;
    options.waves = true;
    const Expected<MatchResult> result = match(source.mesh, target.mesh, options);
    REQUIRE(result.has_value());
    const MatchDrawing drawing = draw(source, target, result->match);
    CHECK(drawing.frame_count() == result->match.regions.front().waves.size() + 1);
    const TemporaryName file(".webp");
    REQUIRE(write_animation(file.name(), drawing).has_value());
    const std::vector<Frame> frames = read_webp(file.name());
    REQUIRE(frames.size() == drawing.frame_count());
    for (std::size_t k = 0; k < frames.size(); ++k) CHECK((frames[k].raster.rgb == drawing.frame(k).rgb));
    CHECK((frames.back().raster.rgb == drawing.image().rgb));
    const int step = frames.front().end;
    for (std::size_t k = 0; k + 1 < frames.size(); ++k) CHECK(frames[k].end == step * static_cast<int>(k + 1));
    CHECK(frames.back().end == frames[frames.size() - 2].end + 2400);
  }
}

TEST_CASE("the name of a film must tell how it is stored") {
  for (const std::string name : {"a.png", "webp", "a.avi"}) {
    const Expected<void> answer = can_write_animation(name);
    REQUIRE_FALSE(answer.has_value());
    CHECK(answer.error().describe() ==
          name + ": the name does not tell how the animation is to be stored; end it in .webp, .gif or .mp4");
  }
  CHECK(can_write_animation("a.webp").has_value());
}
