#include <quadmatch/picture/picture.hpp>

#include <doctest/doctest.h>

#include <quadmatch/shapes/zoo.hpp>

#include "mesh/named_meshes.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

TEST_CASE("without the libraries that draw, every way to a picture ends in a sentence that says how to get them") {
  const std::string sentence =
      "this program was built without the libraries that draw; install libembree-dev, libpng-dev and libwebp-dev, then "
      "build again";
  const MeshFile file{.mesh = build(shapes::cube())};
  const Expected<MatchDrawing> drawing = MatchDrawing::make(file, file, {});
  REQUIRE_FALSE(drawing.has_value());
  CHECK(drawing.error().message == sentence);
  const Expected<void> image = can_write_image("a.png");
  REQUIRE_FALSE(image.has_value());
  CHECK(image.error().describe() == "a.png: " + sentence);
  const Expected<void> film = can_write_animation("a.webp");
  REQUIRE_FALSE(film.has_value());
  CHECK(film.error().code == ErrorCode::CannotWrite);
}
