#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include <quadmatch/mesh/check.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/random_edit.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::Face;
using quadmatch::testing::faces_of;

namespace {

Expected<shapes::Edit> edited(const PolygonSoup& soup, const std::string& text, std::uint64_t seed) {
  const auto edit = shapes::parse_random_edit(text);
  REQUIRE(edit);
  shapes::Random random(seed);
  return shapes::edit_at_random(soup, *edit, random);
}

/// Corners of surviving faces that are not where they were.
std::size_t moved_corners(const PolygonSoup& source, const shapes::Edit& edit) {
  const std::vector<Face> before = faces_of(source), after = faces_of(edit.soup);
  std::size_t moved = 0;
  for (const FacePair& pair : edit.truth) {
    const Face &face = before[pair.source.value], &image = after[pair.target.value];
    REQUIRE(face.size() == image.size());
    const auto size = static_cast<std::uint32_t>(face.size());
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t w = image[image_corner(Orientation::Preserving, pair.rotation, i, size)];
      moved += source.positions[face[i]] != edit.soup.positions[w] ? 1 : 0;
    }
  }
  return moved;
}

/// Departures from §2.1, but for faces that are no quads.
std::size_t departures(const PolygonSoup& soup) {
  const Expected<Mesh> mesh = Mesh::build(soup);
  REQUIRE(mesh);
  const CheckReport report = check(*mesh, 0);
  std::size_t sum = 0;
  for (std::size_t kind = 0; kind < report.departure_counts.size(); ++kind) {
    if (DepartureKind(kind) != DepartureKind::NotAQuad) sum += report.departure_counts[kind];
  }
  return sum;
}

}  // namespace

TEST_CASE("every edit of a bear is well-formed, and its surviving faces are where they were") {
  const PolygonSoup bear = shapes::bear().soup;
  for (const shapes::RandomEditKind& kind : shapes::random_edit_kinds()) {
    const std::string name = kind.name;
    CAPTURE(name);
    for (const std::uint64_t seed : {1U, 2U, 3U, 4U, 5U}) {
      CAPTURE(seed);
      const auto edit = edited(bear, name, seed);
      REQUIRE(edit);
      CHECK(departures(edit->soup) == 0);
      CHECK(edit->soup.corners != bear.corners);
      if (name == "subdivide") continue;  // nothing survives
      CHECK(edit->truth.size() > faces_of(bear).size() / 2);
      // Three kinds move some vertices, close by.
      const bool moves = name == "extrude" || name == "collapse" || name == "unloop";
      CHECK((moved_corners(bear, *edit) > 0) == moves);
      CHECK(moved_corners(bear, *edit) < 4 * faces_of(bear).size() / 10);
    }
  }
}

TEST_CASE("sizes say how often, or how much") {
  const PolygonSoup sphere = shapes::sphere(8);
  const auto faces = [&](const std::string& text) {
    const auto edit = edited(sphere, text, 7);
    REQUIRE(edit);
    return faces_of(edit->soup).size();
  };
  CHECK(faces("delete:30") == 384 - 30);
  CHECK(faces("collapse:5") == 384 - 5);
  CHECK(faces("handle:3") == 384 + 3 * 2);
  CHECK(faces("subdivide:2") == 384 * 16);
  CHECK(faces("loop:2") >= 384 + 2 * 32);
  CHECK(faces("unloop:2") <= 384 - 2 * 24);
  const auto slit = edited(sphere, "rip:5", 7);
  REQUIRE(slit);
  CHECK(slit->soup.vertex_count == sphere.vertex_count + 4);
  CHECK(slit->truth.size() == 384);
}

TEST_CASE("the same seed makes the same edit, another seed another") {
  const PolygonSoup sphere = shapes::sphere(6);
  for (const char* name : {"delete", "loop", "twist", "rip", "renumber"}) {
    CAPTURE(name);
    CHECK(edited(sphere, name, 1)->soup.corners == edited(sphere, name, 1)->soup.corners);
    CHECK(edited(sphere, name, 1)->soup.corners != edited(sphere, name, 2)->soup.corners);
  }
}

TEST_CASE("a recipe is refused where it names no edit, no size, or an edit that fits nowhere") {
  CHECK(shapes::parse_random_edit("lop").error().message == "there is no edit named lop");
  for (const char* size : {"", "0", "-3", "2x", "99999999999"}) {
    CHECK(shapes::parse_random_edit(std::string("loop:") + size).error().message ==
          std::string("the size of loop is not a number from 1 on: ") + size);
  }
  CHECK(shapes::parse_random_edit("loop:12")->size == 12);
  CHECK(shapes::parse_random_edit("rip")->size == 6);
  CHECK(edited(shapes::grid(3, 3), "twist", 1).error().message == "the row of quads is no ring");
  CHECK(edited(PolygonSoup{}, "loop", 1).error().message == "there is no face to edit");
}
