// What is seen, pixel by pixel.

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include <fmt/format.h>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>

#include "pixels.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

const PictureOptions kFront{.width = 400, .height = 200, .view = PictureView::Front};

Raster image_of(const MeshFile& source, const MeshFile& target, const Match& match,
                const PictureOptions& options = kFront) {
  const Expected<MatchDrawing> drawing = MatchDrawing::make(source, target, match, options);
  REQUIRE(drawing.has_value());
  return drawing->image();
}

std::size_t count_red(const Raster& raster, std::uint32_t begin, std::uint32_t end) {
  std::size_t red = 0;
  for (std::uint32_t y = 0; y < raster.height; ++y) {
    for (std::uint32_t x = begin; x < end; ++x) red += is_red(pixel(raster, x, y)) ? 1 : 0;
  }
  return red;
}

/// The sentence of a mesh that cannot be drawn.
std::string refusal(const MeshFile& file) {
  const Expected<MatchDrawing> drawing = MatchDrawing::make(file, file, {}, kFront);
  REQUIRE_FALSE(drawing.has_value());
  CHECK(drawing.error().code == ErrorCode::BadArgument);
  return drawing.error().describe();
}

}  // namespace

TEST_CASE("red is exactly where faces have no partner, and white where there is no face") {
  const MeshFile file = file_of(shapes::grid(4, 4));
  for (const std::vector<std::uint32_t>& unmatched :
       {std::vector<std::uint32_t>{}, {0}, {3}, {5, 10}, {12, 13, 14, 15}}) {
    const Raster raster = image_of(file, file, on_itself(file.mesh, unmatched));
    const SeenGrid grid(4, 200);
    std::array<std::size_t, 3> seen = {};
    for (std::uint32_t y = 0; y < 200; ++y) {
      for (std::uint32_t x = 0; x < 400; ++x) {
        const int square = grid.square_at(x % 200, y);
        if (square == SeenGrid::kAtEdge) continue;
        const bool red = std::find(unmatched.begin(), unmatched.end(), square) != unmatched.end();
        CAPTURE(x);
        CAPTURE(y);
        REQUIRE(is_red(pixel(raster, x, y)) == red);
        REQUIRE(is_white(pixel(raster, x, y)) == (square == SeenGrid::kBeside));
        ++seen[square == SeenGrid::kBeside ? 0 : red ? 1 : 2];
      }
    }
    CHECK(seen[0] > 10000);
    CHECK(seen[1] >= 1000 * unmatched.size());
    CHECK(seen[2] > 1000 * (16 - unmatched.size()));
  }
}

TEST_CASE("of two bears the ears are red, and where they would grow on the one without") {
  const MeshFile bear = file_of(shapes::bear({}).soup);
  const MeshFile earless = file_of(shapes::bear({.ears = false}).soup);
  CHECK(count_red(image_of(bear, bear, on_itself(bear.mesh), {}), 0, 1280) == 0);
  std::vector<std::uint32_t> ears;
  for (std::uint32_t f = shapes::bear_common_faces(); f < bear.mesh.face_count(); ++f) ears.push_back(f);
  const Raster raster = image_of(bear, earless, on_itself(bear.mesh, ears), {});
  CHECK(count_red(raster, 0, 640) > 8000);
  CHECK(count_red(raster, 640, 1280) > 100);
  CHECK(count_red(raster, 640, 1280) < 3000);
  // The ears stand at the top of the head.
  for (std::uint32_t y = 260; y < 640; ++y) {
    for (std::uint32_t x = 0; x < 1280; ++x) REQUIRE_FALSE(is_red(pixel(raster, x, y)));
  }
}

TEST_CASE("what lies behind other faces is not seen, from whichever side one looks") {
  const PolygonSoup cube = shapes::cube();
  PolygonSoup inner = cube;
  for (Point& point : inner.positions) {
    for (double& coordinate : point) coordinate = 0.25 + 0.5 * coordinate;
  }
  const MeshFile file = file_of(shapes::disjoint_union({cube, inner}));
  const std::vector<std::uint32_t> inside{6, 7, 8, 9, 10, 11};
  for (const PictureView view : {PictureView::Home, PictureView::Front, PictureView::Back, PictureView::Left,
                                 PictureView::Right, PictureView::Above, PictureView::Below}) {
    const PictureOptions options{.width = 200, .height = 100, .view = view};
    CHECK(count_red(image_of(file, file, on_itself(file.mesh, inside), options), 0, 200) == 0);
    // And all that is seen is red where the outer one is.
    const Raster raster = image_of(file, file, on_itself(file.mesh, {0, 1, 2, 3, 4, 5}), options);
    CHECK(count_red(raster, 0, 200) > 2000);
    for (std::uint32_t y = 0; y < 100; ++y) {
      for (std::uint32_t x = 0; x < 200; ++x) {
        const Pixel p = pixel(raster, x, y);
        REQUIRE(p[2] <= p[0]);  // no blue of a matched face
      }
    }
  }
}

TEST_CASE("each view shows the side of a cube that it is named for") {
  const MeshFile file = file_of(shapes::cube());
  const auto outward = [&](std::uint32_t f, std::size_t axis, double sign) {
    double sum = 0;
    for (const HalfedgeId h : file.mesh.halfedges(FaceId(f))) {
      sum += file.mesh.positions()[file.mesh.origin(h).value][axis];
    }
    double middle = 0;
    for (const Point& point : file.mesh.positions()) middle += point[axis] / file.mesh.vertex_count();
    return sign * (sum / 4 - middle) > 0.4;
  };
  struct Side {
    PictureView view;
    std::size_t axis;
    double sign;
  };
  for (const auto& [view, axis, sign] :
       {Side{PictureView::Front, 2, 1}, Side{PictureView::Back, 2, -1}, Side{PictureView::Left, 0, -1},
        Side{PictureView::Right, 0, 1}, Side{PictureView::Above, 1, 1}, Side{PictureView::Below, 1, -1}}) {
    for (std::uint32_t f = 0; f < 6; ++f) {
      const Raster raster = image_of(file, file, on_itself(file.mesh, {f}), {.width = 100, .height = 50, .view = view});
      CHECK(is_red(pixel(raster, 25, 25)) == outward(f, axis, sign));
    }
  }
}

TEST_CASE("regions have the colours of a report, ambiguous ones are hatched, and none is red") {
  std::ifstream file(QUADMATCH_SOURCE_DIR "/web/src/picture/colours.ts");
  std::ostringstream colours;
  colours << file.rdbuf();
  const MeshFile grid = file_of(shapes::grid(3, 3));
  Match match;
  for (std::uint32_t f = 0; f < 9; ++f) match.regions.push_back({.faces = {{FaceId(f), FaceId(f), 0}}});
  const Raster raster = image_of(grid, grid, match);
  const SeenGrid seen(3, 200);
  std::vector<Pixel> found(9);
  for (std::uint32_t y = 0; y < 200; ++y) {
    for (std::uint32_t x = 0; x < 200; ++x) {
      if (const int square = seen.square_at(x, y); square >= 0)
        found[static_cast<std::size_t>(square)] = pixel(raster, x, y);
    }
  }
  CHECK(found[8] == found[0]);  // eight colours, and again from the first
  // Seen from the front, a face is as bright as the lamp makes it: divide it out by the first.
  const std::string text = colours.str();
  const double light = (0.62 + 0.38 * 0.8 / std::sqrt(0.35 * 0.35 + 0.25 + 0.64));
  for (const Pixel& p : found) {
    bool known = false;
    for (int red = 0; red < 256 && !known; ++red) {
      if (std::abs(red * light - p[0]) > 1.6) continue;
      for (int green = 0; green < 256 && !known; ++green) {
        if (std::abs(green * light - p[1]) > 1.6) continue;
        for (int blue = 0; blue < 256 && !known; ++blue) {
          if (std::abs(blue * light - p[2]) > 1.6) continue;
          known = text.find(fmt::format("[{}, {}, {}]", red, green, blue)) != std::string::npos;
        }
      }
    }
    CHECK(known);
    CHECK_FALSE(is_red(p));
  }
  CHECK(text.find("UNMATCHED: Rgb = [214, 39, 40]") != std::string::npos);

  for (Region& region : match.regions) region.ambiguous = true;
  const Raster hatched = image_of(grid, grid, match);
  std::size_t dark = 0, bright = 0;
  for (std::uint32_t y = 0; y < 200; ++y) {
    for (std::uint32_t x = 0; x < 200; ++x) {
      if (seen.square_at(x, y) < 0) continue;
      ++(pixel(hatched, x, y) == pixel(raster, x, y) ? bright : dark);
      REQUIRE_FALSE(is_red(pixel(hatched, x, y)));
    }
  }
  CHECK(dark * 5 > bright * 3);
  CHECK(bright > dark);
}

TEST_CASE("triangles and larger faces are drawn whole") {
  // A triangle, a pentagon, a hexagon and a quad around one point, without a gap: no white within them.
  PolygonSoup soup = soup_of(11, {{0, 1, 2}, {0, 2, 3, 4, 5}, {0, 5, 6, 7, 8, 9}, {0, 9, 10, 1}});
  soup.positions.push_back({0, 0, 0});
  for (int k = 0; k < 10; ++k)
    soup.positions.push_back({std::cos(k * 0.2 * std::acos(-1.0)), std::sin(k * 0.2 * std::acos(-1.0)), 0});
  const MeshFile file = file_of(soup);
  const Raster raster = image_of(file, file, on_itself(file.mesh, {0, 1, 2, 3}));
  std::size_t inside = 0;
  for (std::uint32_t y = 0; y < 200; ++y) {
    for (std::uint32_t x = 0; x < 200; ++x) {
      if (std::hypot(x - 99.5, y - 99.5) > 85) continue;
      REQUIRE(is_red(pixel(raster, x, y)));
      ++inside;
    }
  }
  CHECK(inside > 20000);
}

TEST_CASE("a mesh is drawn as large wherever it is, however large, and whatever vertices no face uses") {
  const PolygonSoup grid = shapes::grid(4, 4);
  const MeshFile plain = file_of(grid);
  const Raster raster = image_of(plain, plain, on_itself(plain.mesh, {5}));
  for (const double scale : {1e-300, 1e-9, 1e12, 4e307}) {
    PolygonSoup scaled = grid;
    for (Point& point : scaled.positions) {
      for (double& coordinate : point) coordinate *= scale;
    }
    scaled.positions.push_back({1e200, std::numeric_limits<double>::quiet_NaN(), 0});
    ++scaled.vertex_count;
    const MeshFile file = file_of(scaled);
    const Raster other = image_of(file, file, on_itself(file.mesh, {5}));
    std::size_t different = 0;
    for (std::size_t k = 0; k < raster.rgb.size(); ++k) different += std::abs(raster.rgb[k] - other.rgb[k]) > 3 ? 1 : 0;
    CHECK(different < 100);
  }
}

TEST_CASE("a mesh without positions, or with a vertex that is nowhere, is refused with its name") {
  CHECK(refusal(file_of(soup_of(4, {{0, 1, 2, 3}}), "flat.obj")) ==
        "flat.obj: the mesh has no positions, so there is nothing to draw");
  for (const double lost : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    PolygonSoup soup = shapes::cube();
    soup.positions[3][1] = lost;
    CHECK(refusal(file_of(soup, "lost.obj")) ==
          "lost.obj: v3 is nowhere (its position is no number), so the mesh cannot be drawn");
  }
}

TEST_CASE("a mesh that is but a point or a line is drawn, as nothing or next to nothing") {
  for (const double y : {0.0, 1.0}) {
    PolygonSoup soup = soup_of(4, {{0, 1, 2, 3}});
    soup.positions = {{0, 0, 0}, {0, y, 0}, {0, y, 0}, {0, 0, 0}};
    const MeshFile file = file_of(soup);
    const Raster raster = image_of(file, file, {});
    CHECK(count_red(raster, 0, 400) < 600);
  }
}

TEST_CASE("the same drawing has the same pixels every time") {
  const MeshFile file = file_of(shapes::bear({}).soup);
  const Match match = on_itself(file.mesh, {100, 900});
  CHECK((image_of(file, file, match).rgb == image_of(file, file, match).rgb));
}
