#include <quadmatch/use/symmetry.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/shapes/zoo.hpp>
#include <quadmatch/verify/verify.hpp>

#include "mesh/named_meshes.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

/// Sound, and its own inverse in faces, corners and vertices.
void check_is_mirror(const Mesh& mesh, const Symmetry& symmetry) {
  const Verdict verdict = verify(mesh, mesh, symmetry.match);
  for (const Fault& fault : verdict.faults) MESSAGE(fault.message);
  CHECK(verdict.sound());
  std::map<std::uint32_t, FacePair> pair_of;
  for (const Region& region : symmetry.match.regions) {
    CHECK(region.orientation == Orientation::Reversing);
    for (const FacePair& pair : region.faces) pair_of[pair.source.value] = pair;
  }
  std::size_t one_way = 0;
  for (const auto& [face, pair] : pair_of) {
    const auto back = pair_of.find(pair.target.value);
    one_way += back == pair_of.end() || back->second.target.value != face || back->second.rotation != pair.rotation;
  }
  CHECK(one_way == 0);
  std::map<VertexId, VertexId> partner;
  for (const VertexPair& pair : symmetry.match.vertices) partner[pair.source] = pair.target;
  CHECK(std::all_of(partner.begin(), partner.end(), [&](const auto& pair) {
    return partner.contains(pair.second) && partner[pair.second] == pair.first;
  }));
  CHECK(symmetry.match.vertices.size() == 2 * symmetry.vertex_pairs + symmetry.line.vertices.size());
  CHECK(symmetry.faces == 2 * symmetry.face_pairs + symmetry.line.faces.size() + symmetry.unpaired_faces.size());
}

Symmetry mirror_of(const Mesh& mesh, bool positions = true) {
  Symmetry symmetry = find_symmetry(mesh, {.positions = positions});
  check_is_mirror(mesh, symmetry);
  return symmetry;
}

/// Twisted about the y axis, so that no plane is left.
PolygonSoup twisted(PolygonSoup soup, double angle) {
  for (Point& p : soup.positions) {
    const double turn = angle * p[1];
    p = {std::cos(turn) * p[0] - std::sin(turn) * p[2], p[1], std::sin(turn) * p[0] + std::cos(turn) * p[2]};
  }
  return soup;
}

/// An even number of quads by n, without two in the middle of the first row: only left and right are alike.
PolygonSoup notched_grid(std::uint32_t m, std::uint32_t n) {
  PolygonSoup soup = shapes::grid(m, n);
  const auto first = soup.corners.begin() + std::ptrdiff_t{4} * (m / 2 - 1);
  soup.corners.erase(first, first + 8);
  return soup;
}

/// Of each vertex the one that is opposite in x = 0, if there is one.
std::vector<VertexId> opposite_vertices(const std::vector<Point>& positions) {
  std::vector<VertexId> opposite(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const Point& p = positions[v];
    for (std::uint32_t w = 0; w < positions.size(); ++w) {
      const Point& q = positions[w];
      if (std::abs(p[0] + q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) < 1e-6) opposite[v] = VertexId(w);
    }
  }
  return opposite;
}

}  // namespace

TEST_CASE("symmetry: a cube has nine mirrors, and the one across x is taken") {
  const PolygonSoup soup = shapes::cube_subdivided(8);
  const Symmetry symmetry = mirror_of(build(soup));
  CHECK(symmetry.whole());
  CHECK(symmetry.mirrors == 9);
  CHECK_FALSE(symmetry.maybe_more);
  CHECK(symmetry.line.vertices.size() == 32);
  CHECK(symmetry.line.edges.size() == 32);
  CHECK(symmetry.line.faces.empty());
  REQUIRE(symmetry.plane.has_value());
  CHECK(symmetry.plane->normal[0] == doctest::Approx(1));
  CHECK(symmetry.plane->error == doctest::Approx(0));
}

TEST_CASE("symmetry: a renumbered and twisted cube still has one consistent mirror of nine") {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const shapes::Renumbered copy = shapes::renumbered(twisted(shapes::cube_subdivided(8), 0.8), seed);
    const Symmetry symmetry = mirror_of(build(copy.soup));
    CHECK(symmetry.whole());
    CHECK(symmetry.mirrors == 9);
    CHECK_FALSE(symmetry.line.empty());
  }
}

TEST_CASE("symmetry: without positions a cube is mirrored, not turned inside out through its middle") {
  const Symmetry symmetry = mirror_of(build(shapes::cube_subdivided(5)), false);
  CHECK(symmetry.whole());
  CHECK(symmetry.mirrors == 9);
  CHECK_FALSE(symmetry.line.empty());  // the map through the middle fixes nothing
}

TEST_CASE("symmetry: of a cube of an odd number of quads the line runs through faces") {
  const Symmetry symmetry = mirror_of(build(shapes::cube_subdivided(3)));
  CHECK(symmetry.whole());
  CHECK(symmetry.line.faces.size() == 12);
  CHECK(symmetry.line.crossed_edges.size() == 12);
  CHECK(symmetry.line.vertices.empty());
}

TEST_CASE("symmetry: grids, prisms and tubes have the mirrors one can see") {
  CHECK(mirror_of(build(shapes::grid(4, 3))).mirrors == 2);
  CHECK(mirror_of(build(shapes::grid(4, 4))).mirrors == 4);
  CHECK(mirror_of(build(shapes::prism(5))).mirrors == 6);
  CHECK(mirror_of(build(shapes::star(5, 3))).mirrors == 5);
  CHECK(mirror_of(build(shapes::cylinder(6, 4))).mirrors == 7);
}

TEST_CASE("symmetry: the bear's left is its right but for the patch on its belly, in any pose and order") {
  const PolygonSoup rest = shapes::bear().soup;
  const std::vector<VertexId> opposite = opposite_vertices(rest.positions);
  const Symmetry symmetry = mirror_of(build(rest));
  CHECK_FALSE(symmetry.whole());
  CHECK(symmetry.mirrors == 1);
  CHECK(symmetry.unpaired_faces.size() < 100);
  std::vector<VertexId> partner(rest.vertex_count);
  for (const VertexPair& pair : symmetry.match.vertices) partner[pair.source.value] = pair.target;
  std::size_t wrong = 0;
  for (std::uint32_t v = 0; v < rest.vertex_count; ++v) wrong += opposite[v].valid() && partner[v] != opposite[v];
  CHECK(wrong == 0);

  const shapes::Model posed = shapes::bear({.pose = {.left_arm = 0.2, .right_leg = 0.1, .head_turn = 0.1}});
  const shapes::Renumbered copy = shapes::renumbered(posed.soup, 7);
  const Symmetry again = mirror_of(build(copy.soup));
  std::vector<VertexId> posed_partner(rest.vertex_count);
  for (const VertexPair& pair : again.match.vertices) posed_partner[pair.source.value] = pair.target;
  wrong = 0;
  for (std::uint32_t v = 0; v < rest.vertex_count; ++v) {
    if (opposite[v].valid()) wrong += posed_partner[copy.vertices[VertexId(v)].value] != copy.vertices[opposite[v]];
  }
  CHECK(wrong == 0);
}

TEST_CASE("symmetry: a patch deleted from one side leaves the rest paired") {
  const PolygonSoup cube = shapes::cube_subdivided(8);
  const Expected<shapes::Edit> edit = shapes::delete_patch(cube, FaceId(81), 7);
  REQUIRE(edit.has_value());
  const Symmetry symmetry = mirror_of(build(edit->soup));
  CHECK_FALSE(symmetry.whole());
  CHECK(symmetry.unpaired_faces.size() <= 14);  // what was opposite, and a few about it
}

TEST_CASE("symmetry: a patch lifted on one side of a posed bear is paired with the place opposite") {
  const PolygonSoup rest = shapes::bear().soup;
  const std::vector<VertexId> opposite = opposite_vertices(rest.positions);
  const PolygonSoup posed = shapes::bear({.pose = {.left_arm = 0.2, .right_leg = 0.1, .head_turn = 0.1}}).soup;
  for (const FaceId centre : {FaceId(700), FaceId(1000), FaceId(1400)}) {
    const Expected<shapes::Edit> edit = shapes::extrude_patch(posed, centre, 12, 0.05);
    REQUIRE(edit.has_value());
    const Mesh mesh = build(edit->soup);
    const Symmetry symmetry = mirror_of(mesh);
    std::vector<VertexId> partner(mesh.vertex_count());
    for (const VertexPair& pair : symmetry.match.vertices) partner[pair.source.value] = pair.target;
    // Vertices keep their numbers; those on the rim of the patch are at its foot or at its top.
    std::size_t wrong = 0;
    for (std::uint32_t v = 0; v < rest.vertex_count; ++v) wrong += opposite[v].valid() && partner[v] != opposite[v];
    CHECK(wrong <= 2 * 14);
    CHECK(symmetry.unpaired_faces.size() <= 100 + 18);
  }
}

TEST_CASE("symmetry: a left and a right part without mirrors of their own are each other's mirror image") {
  PolygonSoup left = shapes::shirt(shapes::Sleeves::Short).soup;  // with a pocket
  PolygonSoup right = left;
  for (Point& p : left.positions) p[0] -= 5;
  const Mesh mirrored = build(right).mirrored();
  right.corners.assign(mirrored.corners().begin(), mirrored.corners().end());
  for (Point& p : right.positions) p[0] = 5 - p[0];
  const Symmetry symmetry = mirror_of(build(shapes::disjoint_union({left, right})));
  CHECK(symmetry.whole());
  CHECK(symmetry.line.empty());
  CHECK(symmetry.mirrors == 1);
}

TEST_CASE("symmetry: a mesh that is nothing like its mirror image has no mirror") {
  const Symmetry symmetry = mirror_of(mesh_of(7, {{0, 1, 4, 3}, {1, 2, 5, 4}, {4, 5, 6}}));
  CHECK_FALSE(symmetry.whole());
}

TEST_CASE("symmetrize: one side's positions come to the other, mirrored, and the line into the plane") {
  const PolygonSoup rest = notched_grid(12, 8);
  PolygonSoup sculpted = rest;
  for (Point& p : sculpted.positions) {
    if (p[0] < 2.5 && p[1] > 3.5) p[2] = 0.05;  // fifteen vertices
  }
  sculpted.positions[6 + 13 * 4][0] += 0.01;  // one of the line
  const MeshFile file{.mesh = build(sculpted)};
  const Symmetry symmetry = mirror_of(file.mesh);
  REQUIRE(symmetry.whole());
  const auto farthest = [](const PolygonSoup& soup, const Mesh& mesh) {
    double most = 0;
    for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
      const Point& p = soup.positions[v];
      const Point& q = mesh.positions()[v];
      most = std::max(most, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
    return most;
  };
  const Expected<Symmetrized> flat = symmetrize(file, symmetry, {.from = {0, true}});
  REQUIRE(flat.has_value());
  CHECK(farthest(rest, flat->file.mesh) < 1e-4);
  CHECK(flat->farthest == doctest::Approx(0.05).epsilon(0.01));

  // From the other side the bump comes over instead.
  PolygonSoup bumps = rest;
  for (Point& p : bumps.positions) {
    if (std::abs(p[0] - 6) > 3.5 && p[1] > 3.5) p[2] = 0.05;
  }
  const Expected<Symmetrized> bumpy = symmetrize(file, symmetry, {.from = {0, false}});
  REQUIRE(bumpy.has_value());
  CHECK(farthest(bumps, bumpy->file.mesh) < 1e-4);
}

TEST_CASE("symmetrize: data of vertices, faces and corners are copied as they are, in any pose") {
  MeshFile file{.mesh = build(twisted(notched_grid(6, 4), 0.2))};
  Property weight{"weight", Domain::Vertex, ScalarType::Float32, {}, {}, {}};
  for (std::uint32_t v = 0; v < file.mesh.vertex_count(); ++v) weight.values.push_back(v);
  file.properties.push_back(weight);
  const Symmetry symmetry = mirror_of(file.mesh);
  REQUIRE(symmetry.whole());
  SymmetrizeOptions options{.from = {0, true}, .carry = Carry::nothing()};
  options.carry.properties = true;
  const Expected<Symmetrized> result = symmetrize(file, symmetry, options);
  REQUIRE(result.has_value());
  CHECK(result->moved == 0);
  for (std::uint32_t j = 0; j <= 4; ++j) {
    for (std::uint32_t i = 0; i <= 6; ++i) {
      const std::uint32_t v = 7 * j + i, opposite = 7 * j + 6 - i;
      CHECK(result->file.properties.front().values[v] == (i < 3 ? opposite : v));
    }
  }
}

TEST_CASE("symmetrize: sides are told by the larger part of them, even where a hand crosses the middle") {
  PolygonSoup soup = notched_grid(8, 2);
  for (Point& p : soup.positions) {
    if (p[0] > 6.5) p[0] -= 6;  // the right end reaches over to the left
  }
  const Mesh mesh = build(soup);
  const Symmetry symmetry = find_symmetry(mesh, {.positions = false});
  const std::vector<std::int8_t> sides = sides_of_faces(mesh, symmetry, {0, true});
  REQUIRE(sides.size() == 14);
  for (std::uint32_t f = 0; f < 14; ++f) {
    const std::uint32_t column = f < 3 ? f : (f + 2) % 8;
    CHECK(int{sides[f]} == (column < 4 ? -1 : 1));
  }
}

TEST_CASE("symmetrize: what cannot be done is refused and says why") {
  const auto refusal = [](const MeshFile& file, const SymmetrizeOptions& options) {
    const Expected<Symmetrized> result = symmetrize(file, find_symmetry(file.mesh), options);
    return result ? std::string() : result.error().message;
  };
  const auto has = [](const std::string& text, const char* part) { return text.find(part) != std::string::npos; };
  const shapes::Model posed =
      shapes::bear({.pose = {.left_arm = 0.2, .left_leg = 0.2, .head_turn = 0.2, .body_bend = 0.25}});
  CHECK(has(refusal({.mesh = build(posed.soup)}, {}), "posed"));
  PolygonSoup bare = shapes::grid(4, 3);
  bare.positions.clear();
  CHECK(has(refusal({.mesh = build(bare)}, {}), "no positions"));
  CHECK(has(refusal({.mesh = build(shapes::grid(4, 3))}, {.from = {2, true}}), "axis"));
  SymmetrizeOptions materials{.from = {0, true}, .carry = Carry::nothing()};
  materials.carry.materials = true;
  CHECK(has(refusal({.mesh = build(shapes::grid(4, 3))}, materials), "none of the data"));
}
