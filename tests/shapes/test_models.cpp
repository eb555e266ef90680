#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/shirt.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::Edge;
using quadmatch::testing::Face;
using quadmatch::testing::faces_meet_properly;
using quadmatch::testing::faces_of;
using quadmatch::testing::Topology;
using quadmatch::testing::topology_of;
using shapes::Model;
using shapes::Sleeves;

namespace {

constexpr shapes::BearPose kSomePose = {.left_arm = 0.2, .right_leg = 0.1, .head_turn = 0.1, .body_bend = 0.05};

std::string part_of(const Model& model, std::uint32_t face) {
  const auto after = std::find_if(model.parts.begin(), model.parts.end(),
                                  [&](const shapes::ModelPart& part) { return part.first_face > face; });
  return std::prev(after)->name;
}

/// Lay the first `count` faces of two models on each other, corner by corner: is that one-to-one on vertices?
bool first_faces_are_the_same(const Model& one, const Model& other, std::uint32_t count) {
  std::map<VertexId, VertexId> image, origin;
  for (std::uint32_t c = 0; c < 4 * count; ++c) {
    const VertexId v = one.soup.corners[c], w = other.soup.corners[c];
    if (image.emplace(v, w).first->second != w || origin.emplace(w, v).first->second != v) return false;
  }
  return true;
}

/// Sides of the first `count` faces that no other one of them shares.
std::size_t rim_of_first_faces(const Model& model, std::uint32_t count) {
  std::map<Edge, int> uses;
  const std::vector<Face> faces = faces_of(model.soup);
  for (std::uint32_t f = 0; f < count; ++f) {
    for (std::size_t k = 0; k < 4; ++k) ++uses[std::minmax(faces[f][k], faces[f][(k + 1) % 4])];
  }
  return static_cast<std::size_t>(std::count_if(uses.begin(), uses.end(), [](const auto& e) { return e.second == 1; }));
}

void check_texture(const Model& model) {
  REQUIRE(model.coordinates.size() == model.soup.corners.size());
  std::set<std::array<long, 2>> centres;
  for (std::size_t c = 0; c < model.coordinates.size(); c += 4) {
    double u = 0, v = 0;
    for (std::size_t k = 0; k < 4; ++k) {
      const auto& [x, y] = model.coordinates[c + k];
      CHECK((x >= 0 && x <= 1 && y >= 0 && y <= 1));
      u += x;
      v += y;
    }
    centres.insert({std::lround(u * 1e4), std::lround(v * 1e4)});
  }
  CHECK(centres.size() == model.coordinates.size() / 4);  // all faces are squares of one size, none on another
}

}  // namespace

TEST_CASE("The bear is closed, of genus 0, simple and consistently wound, with ears and without, in any pose") {
  for (const bool ears : {true, false}) {
    for (const shapes::BearPose& pose : {shapes::BearPose{}, kSomePose}) {
      const Model bear = shapes::bear({ears, pose});
      const Topology topology = topology_of(bear.soup);
      CHECK(topology.faces == (ears ? 2944 : 2688));
      CHECK(topology.vertices == topology.faces + 2);
      CHECK(topology.vertices == bear.soup.vertex_count);
      CHECK(topology.genus() == 0);
      CHECK(topology.boundary_loops == 0);
      CHECK(topology.components == 1);
      CHECK(topology.clean());
      CHECK(faces_meet_properly(bear.soup));
    }
  }
}

TEST_CASE("Fig 5.2: the two bears are the same but for their ears, which are topologically different") {
  const Model with = shapes::bear(), without = shapes::bear({.ears = false, .pose = kSomePose});
  const std::uint32_t common = shapes::bear_common_faces();
  CHECK(common == 2656);
  CHECK(first_faces_are_the_same(with, without, common));
  // Two holes are left in both, each around one face of the cage: 4 sides of 4 edges.
  CHECK(rim_of_first_faces(with, common) == 32);
  CHECK(rim_of_first_faces(without, common) == 32);
  for (std::uint32_t f = common; f < 2944; ++f) CHECK(part_of(with, f) == "ears");
  for (std::uint32_t f = common; f < 2688; ++f) CHECK(part_of(without, f) == "crown");
}

TEST_CASE("A pose of the bear moves vertices and leaves the connectivity untouched") {
  const Model rest = shapes::bear(), posed = shapes::bear({.pose = kSomePose});
  CHECK(rest.soup.corners == posed.soup.corners);
  CHECK(rest.coordinates == posed.coordinates);
  std::size_t moved = 0;
  for (std::uint32_t v = 0; v < rest.soup.vertex_count; ++v) moved += rest.soup.positions[v] != posed.soup.positions[v];
  CHECK(moved > rest.soup.vertex_count / 2);
}

TEST_CASE("The bear at rest is left and right alike, but for the patch on its belly") {
  const Model bear = shapes::bear();
  std::set<std::array<long, 3>> places;
  const auto place = [](const Point& p, double side) {
    return std::array<long, 3>{std::lround(side * p[0] * 1e6), std::lround(p[1] * 1e6), std::lround(p[2] * 1e6)};
  };
  for (const Point& p : bear.soup.positions) places.insert(place(p, 1));
  const auto alone = std::count_if(bear.soup.positions.begin(), bear.soup.positions.end(),
                                   [&](const Point& p) { return places.count(place(p, -1)) == 0; });
  CHECK(alone > 0);
  CHECK(alone < 300);
}

TEST_CASE("The shirt has four boundary loops, waist, neck and two cuffs, with sleeves of either length") {
  for (const Sleeves sleeves : {Sleeves::Short, Sleeves::Long}) {
    const Model shirt = shapes::shirt(sleeves);
    const Topology topology = topology_of(shirt.soup);
    CHECK(topology.faces == (sleeves == Sleeves::Long ? 1944 : 1432));
    CHECK(topology.vertices == shirt.soup.vertex_count);
    CHECK(topology.boundary_loops == 4);
    CHECK(topology.genus() == 0);
    CHECK(topology.components == 1);
    CHECK(topology.clean());
    CHECK(faces_meet_properly(shirt.soup));
  }
}

TEST_CASE("A shirt with long sleeves is one with short sleeves and some more rings of quads") {
  const Model long_sleeves = shapes::shirt(Sleeves::Long), short_sleeves = shapes::shirt(Sleeves::Short);
  CHECK(first_faces_are_the_same(short_sleeves, long_sleeves, 1432));
  for (std::uint32_t f = 1432; f < 1944; ++f) {
    const std::string part = part_of(long_sleeves, f);
    CHECK((part.find("lower_sleeve") != std::string::npos || part.find("cuff") != std::string::npos));
  }
  for (std::size_t c = 0; c < short_sleeves.coordinates.size(); ++c) {
    CHECK(short_sleeves.coordinates[c] == long_sleeves.coordinates[c]);
  }
}

TEST_CASE("Texture coordinates of the models lie in the unit square, no two faces on the same place") {
  check_texture(shapes::bear());
  check_texture(shapes::bear({.ears = false}));
  check_texture(shapes::shirt(Sleeves::Long));
  check_texture(shapes::shirt(Sleeves::Short));
}

TEST_CASE("The parts of a model follow one another without gaps, each under a name of its own") {
  for (const Model& model : {shapes::bear(), shapes::bear({.ears = false}), shapes::shirt(Sleeves::Long)}) {
    std::set<std::string> names;
    REQUIRE_FALSE(model.parts.empty());
    CHECK(model.parts.front().first_face == 0);
    for (std::size_t i = 0; i < model.parts.size(); ++i) {
      CHECK(names.insert(model.parts[i].name).second);
      if (i > 0) CHECK(model.parts[i].first_face > model.parts[i - 1].first_face);
    }
  }
}
