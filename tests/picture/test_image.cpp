// Pictures as files, read back by libpng.

#include <doctest/doctest.h>

#include <png.h>

#include <quadmatch/io/file.hpp>

#include "pixels.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

Raster read_png(const std::string& path) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  REQUIRE(png_image_begin_read_from_file(&image, path.c_str()) != 0);
  CHECK(image.format == PNG_FORMAT_RGB);  // as stored: no colours but these three
  Raster raster{image.width, image.height, {}};
  raster.rgb.resize(PNG_IMAGE_SIZE(image));
  REQUIRE(png_image_finish_read(&image, nullptr, raster.rgb.data(), 0, nullptr) != 0);
  return raster;
}

MatchDrawing draw(const PictureOptions& options) {
  const MeshFile file = file_of(shapes::grid(4, 4));
  Expected<MatchDrawing> drawing = MatchDrawing::make(file, file, on_itself(file.mesh, {5}), options);
  REQUIRE(drawing.has_value());
  return *std::move(drawing);
}

}  // namespace

TEST_CASE("a picture read back has the size that was asked for and the pixels that were drawn") {
  for (const auto& [width, height] : {std::pair{1280U, 640U}, std::pair{16U, 16U}, std::pair{333U, 97U}}) {
    const MatchDrawing drawing = draw({.width = width, .height = height});
    const TemporaryName file(".png");
    REQUIRE(write_image(file.name(), drawing).has_value());
    const Raster raster = read_png(file.name());
    CHECK(raster.width == width);
    CHECK(raster.height == height);
    CHECK((raster.rgb == drawing.image().rgb));
  }
}

TEST_CASE("a picture that cannot be written says why, and what was there stays") {
  const MatchDrawing drawing = draw({.width = 64, .height = 32});
  const Expected<void> nowhere = write_image("/nonexistent/a.png", drawing);
  REQUIRE_FALSE(nowhere.has_value());
  CHECK(nowhere.error().code == ErrorCode::CannotWrite);
  CHECK(nowhere.error().path == "/nonexistent/a.png");
  for (const std::string name : {"a.jpg", "png", ".png", "a.png.webp"}) {
    const Expected<void> answer = write_image(name, drawing);
    REQUIRE_FALSE(answer.has_value());
    CHECK(answer.error().describe() == name + ": pictures are written as PNG; choose a name that ends in .png");
  }
  CHECK(can_write_image("A.PNG").has_value());
}
