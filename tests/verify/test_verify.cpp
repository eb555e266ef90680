// Sound matches pass, and every fault is found in the least match that has it.

#include "matches.hpp"

#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/verify/verify.hpp>

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

bool has(const Verdict& verdict, FaultKind kind) {
  return std::any_of(verdict.faults.begin(), verdict.faults.end(),
                     [kind](const Fault& fault) { return fault.kind == kind; });
}

std::string message(const Verdict& verdict, FaultKind kind) {
  for (const Fault& fault : verdict.faults) {
    if (fault.kind == kind) return fault.message;
  }
  return "none";
}

/// Only faults of this kind, and at least one.
bool has_only(const Verdict& verdict, FaultKind kind) {
  return !verdict.faults.empty() && std::all_of(verdict.faults.begin(), verdict.faults.end(),
                                                [kind](const Fault& fault) { return fault.kind == kind; });
}

/// The match of a mesh with itself, of the given faces only.
Match identity(const Mesh& mesh, std::initializer_list<std::uint32_t> faces) {
  Match match;
  match.regions.emplace_back();
  for (const std::uint32_t f : faces) match.regions[0].faces.push_back({FaceId(f), FaceId(f), 0});
  list_vertices(mesh, mesh, match);
  return match;
}

}  // namespace

TEST_CASE("the true match of a mesh and a renumbered copy is sound") {
  const std::vector<PolygonSoup> soups{shapes::grid(4, 3), shapes::torus(4, 5), shapes::cube(),        shapes::prism(5),
                                       shapes::star(5, 2), shapes::dog_toy(3),  shapes::cylinder(3, 2)};
  for (const PolygonSoup& soup : soups) {
    const Instance instance = renumbered_instance(soup, 7);
    const Verdict verdict = verify(instance.source, instance.target, instance.match);
    CHECK(verdict.sound());
    CHECK(verdict.faults.empty());
    CHECK(verdict.matched_faces == instance.source.face_count());
    CHECK(verdict.largest_region == instance.source.face_count());
    CHECK(verdict.matched_vertices == instance.source.vertex_count());
  }
}

TEST_CASE("a match that turns the orientation over is sound when it says so, and not when it does not") {
  for (const PolygonSoup& soup : {shapes::grid(4, 3), shapes::cube(), shapes::prism(5), shapes::star(5, 2)}) {
    Instance instance = mirrored_instance(soup, 3);
    CHECK(verify(instance.source, instance.target, instance.match).sound());
    instance.match.regions[0].orientation = Orientation::Preserving;
    CHECK_FALSE(verify(instance.source, instance.target, instance.match).sound());
  }
}

TEST_CASE("a match of nothing is sound") {
  const Mesh mesh = build(shapes::cube());
  const Verdict verdict = verify(mesh, mesh, {});
  CHECK(verdict.sound());
  CHECK(verdict.matched_faces == 0);
  CHECK(verdict.largest_region == 0);
}

TEST_CASE("a face that the meshes do not have is a fault") {
  const Mesh mesh = build(shapes::grid(2, 1));
  for (const FacePair& pair : {FacePair{FaceId(2), FaceId(0)}, FacePair{FaceId(0), FaceId(2)}, FacePair{}}) {
    Match match;
    match.regions.push_back({.faces = {pair}});
    const Verdict verdict = verify(mesh, mesh, match);
    CHECK(has(verdict, FaultKind::NoSuchElement));
    CHECK(has(verdict, FaultKind::EmptyRegion));
  }
}

TEST_CASE("a vertex that the meshes do not have is a fault") {
  const Mesh mesh = build(shapes::grid(1, 1));
  for (const VertexPair& pair : {VertexPair{VertexId(4), VertexId(0)}, VertexPair{VertexId(0), VertexId(4)}}) {
    Match match = identity(mesh, {0});
    match.vertices.push_back(pair);
    CHECK(has_only(verify(mesh, mesh, match), FaultKind::NoSuchElement));
  }
}

TEST_CASE("sentence 1: faces of unequal corner counts are a fault, and so is a rotation that does not exist") {
  const Mesh mesh = build(shapes::prism(5));
  std::uint32_t quad = 0;
  while (mesh.size(FaceId(quad)) != 4) ++quad;
  std::uint32_t pentagon = 0;
  while (mesh.size(FaceId(pentagon)) != 5) ++pentagon;
  Match match;
  match.regions.push_back({.faces = {{FaceId(quad), FaceId(pentagon), 0}}});
  CHECK(has(verify(mesh, mesh, match), FaultKind::CornersDoNotFit));

  match = identity(mesh, {quad});
  match.regions[0].faces[0].rotation = 4;
  CHECK(has(verify(mesh, mesh, match), FaultKind::CornersDoNotFit));
}

TEST_CASE("sentence 2: a wrong rotation gives a source vertex two images") {
  const Mesh mesh = build(shapes::grid(2, 1));
  Match match = identity(mesh, {0, 1});
  match.regions[0].faces[1].rotation = 1;
  const Verdict verdict = verify(mesh, mesh, match);
  CHECK(has(verdict, FaultKind::VertexNotAFunction));
  CHECK(message(verdict, FaultKind::VertexNotAFunction).find("region 0, pair 1 -> 1: source vertex 1 has two images") ==
        0);
}

TEST_CASE("sentence 2: a target vertex hit by two source vertices is a fault, and so is the reverse") {
  // Three quads in a row, wrapped around a ring of three: the two ends of the row fall on one edge.
  const Mesh strip = build(shapes::grid(3, 1));
  const Mesh ring = build(shapes::cylinder(3, 1));
  Match match;
  match.regions.emplace_back();
  HalfedgeId here = ring.first(FaceId(0));
  while (!ring.twin(here).valid()) here = ring.next(here);
  for (std::uint32_t f = 0; f < 3; ++f) {
    // Side 3 of a grid's quad is its left one; `here` is the side through which the ring is entered.
    match.regions[0].faces.push_back({FaceId(f), ring.face(here), (ring.corner(here) + 1) % 4});
    here = ring.twin(ring.next(ring.next(here)));
  }
  const Verdict verdict = verify(strip, ring, match, 100);
  CHECK(has(verdict, FaultKind::VertexNotOneToOne));
  CHECK(has(verdict, FaultKind::AdjacencyLost));  // the ends of the ring meet, those of the strip do not
  CHECK_FALSE(has(verdict, FaultKind::VertexNotAFunction));

  const Verdict back = [&] {
    Match inverse;
    inverse.regions.emplace_back();
    for (const FacePair& pair : match.regions[0].faces) {
      inverse.regions[0].faces.push_back({pair.target, pair.source, (4 - pair.rotation) % 4});
    }
    return verify(ring, strip, inverse, 100);
  }();
  CHECK(has(back, FaultKind::VertexNotAFunction));
  CHECK_FALSE(has(back, FaultKind::VertexNotOneToOne));
}

TEST_CASE("sentence 2: quads around a vertex that do not close up in the other mesh are a fault") {
  const Mesh grid = build(shapes::grid(2, 2));
  PolygonSoup slit = shapes::grid(2, 2);  // ripped open from the middle to the right
  slit.positions.clear();
  slit.corners[4 * 3 + 1] = VertexId(slit.vertex_count++);
  const Mesh ripped = build(slit);
  const Match match = identity(grid, {0, 1, 2, 3});
  CHECK(has(verify(grid, ripped, match, 100), FaultKind::VertexNotAFunction));
  CHECK(has(verify(ripped, grid, match, 100), FaultKind::VertexNotOneToOne));
}

TEST_CASE("sentence 3: adjacency that only the source has is a fault") {
  const Mesh grid = build(shapes::grid(2, 1));
  PolygonSoup cut = shapes::grid(2, 1);
  cut.positions.clear();
  cut.vertex_count += 2;
  cut.corners[4] = VertexId(6);  // the second quad stands alone
  cut.corners[7] = VertexId(7);
  const Mesh apart = build(cut);
  const Match match = identity(grid, {0, 1});
  const Verdict there = verify(grid, apart, match, 100);
  CHECK(message(there, FaultKind::AdjacencyLost).find("in the source only, at side 1") != std::string::npos);
  CHECK_FALSE(has(there, FaultKind::NotConnected));
  const Verdict back = verify(apart, grid, match, 100);
  CHECK(message(back, FaultKind::AdjacencyLost).find("in the target only, at side 1") != std::string::npos);
  CHECK(has(back, FaultKind::NotConnected));
}

TEST_CASE("sentence 3: faces whose neighbours are matched, but not to each other, are a fault") {
  const Mesh mesh = build(shapes::grid(3, 1));
  Match match = identity(mesh, {0, 1, 2});
  std::swap(match.regions[0].faces[0].target, match.regions[0].faces[2].target);
  const Verdict verdict = verify(mesh, mesh, match, 100);
  CHECK(std::any_of(verdict.faults.begin(), verdict.faults.end(), [](const Fault& fault) {
    return fault.message == "region 0, pair 1 -> 1: the faces beside it at side 1, 2 and 2, are no pair";
  }));
}

TEST_CASE("sentence 3: a seam is no adjacency: faces at a wrongly wound edge must be two regions") {
  const Mesh mesh = build(shapes::wrongly_wound());
  Match match = identity(mesh, {0, 1});
  CHECK(has_only(verify(mesh, mesh, match), FaultKind::NotConnected));
  match.regions = {{.faces = {{FaceId(0), FaceId(0), 0}}}, {.faces = {{FaceId(1), FaceId(1), 0}}}};
  CHECK(verify(mesh, mesh, match).sound());
}

TEST_CASE("sentence 4: a region in two parts is a fault, two regions are not") {
  const Mesh mesh = build(shapes::grid(3, 1));
  Match match = identity(mesh, {0, 2});
  const Verdict verdict = verify(mesh, mesh, match);
  CHECK(has_only(verdict, FaultKind::NotConnected));
  CHECK(verdict.fault_count == 1);
  CHECK(verdict.faults[0].message == "region 0: 1 of its 2 faces are not connected to the first, 0");
  match.regions = {{.faces = {{FaceId(0), FaceId(0), 0}}}, {.faces = {{FaceId(2), FaceId(2), 0}}}};
  const Verdict apart = verify(mesh, mesh, match);
  CHECK(apart.sound());
  CHECK(apart.matched_faces == 2);
  CHECK(apart.largest_region == 1);
}

TEST_CASE("sentence 4: faces of a region may stand in any order") {
  const Mesh mesh = build(shapes::grid(5, 1));
  CHECK(verify(mesh, mesh, identity(mesh, {0, 4, 2, 1, 3})).sound());
  CHECK(verify(mesh, mesh, identity(mesh, {4, 3, 2, 1, 0})).sound());
  const Verdict verdict = verify(mesh, mesh, identity(mesh, {3, 0, 4, 1}));
  CHECK(has_only(verdict, FaultKind::NotConnected));
  CHECK(verdict.faults[0].message == "region 0: 2 of its 4 faces are not connected to the first, 3");
}

TEST_CASE("sentence 4: faces that share a vertex only are not connected") {
  const Mesh mesh = build(shapes::grid(2, 2));
  CHECK(has_only(verify(mesh, mesh, identity(mesh, {0, 3})), FaultKind::NotConnected));
}

TEST_CASE("sentence 5: a face in two pairs is a fault, in one region or over two") {
  const Mesh mesh = build(shapes::grid(2, 1));
  Match twice = identity(mesh, {0, 1});
  twice.regions[0].faces.push_back(twice.regions[0].faces[0]);
  CHECK(has_only(verify(mesh, mesh, twice), FaultKind::FaceTwice));

  Match over_two = identity(mesh, {0, 1});
  over_two.regions.push_back({.faces = {{FaceId(1), FaceId(1), 0}}});
  CHECK(has_only(verify(mesh, mesh, over_two), FaultKind::FaceTwice));

  Match target_twice = identity(mesh, {0});
  target_twice.regions.push_back({.faces = {{FaceId(1), FaceId(0), 0}}});
  const Verdict verdict = verify(mesh, mesh, target_twice);
  CHECK(message(verdict, FaultKind::FaceTwice) == "region 1, pair 1 -> 0: the target face is matched twice");
}

TEST_CASE("a region of no face is a fault") {
  const Mesh mesh = build(shapes::grid(1, 1));
  Match match = identity(mesh, {0});
  match.regions.emplace_back();
  const Verdict verdict = verify(mesh, mesh, match);
  CHECK(has_only(verdict, FaultKind::EmptyRegion));
  CHECK(verdict.faults[0].message == "region 1 has no face");
}

TEST_CASE("sentence 6: a list of vertices that is not one-to-one is a fault") {
  const Mesh mesh = build(shapes::grid(1, 1));
  Match match = identity(mesh, {0});
  match.vertices.push_back(match.vertices[0]);
  CHECK(verify(mesh, mesh, match).sound());  // said twice, but not otherwise
  CHECK(verify(mesh, mesh, match).matched_vertices == 4);
  match.vertices.back().target = match.vertices[1].target;
  CHECK(has_only(verify(mesh, mesh, match), FaultKind::BadVertexList));
}

TEST_CASE("sentence 6: a listed pair of no region is a fault") {
  const Mesh mesh = build(shapes::grid(2, 1));
  Match match = identity(mesh, {0});
  match.vertices.push_back({VertexId(2), VertexId(2)});
  const Verdict verdict = verify(mesh, mesh, match);
  CHECK(verdict.fault_count == 1);
  CHECK(verdict.faults[0].message == "vertices: 2 -> 2 is in no region");
}

TEST_CASE("sentence 6: a vertex of a matched face that is not listed is a fault") {
  const Mesh mesh = build(shapes::grid(1, 1));
  Match match = identity(mesh, {0});
  match.vertices.erase(match.vertices.begin() + 2);
  const Verdict verdict = verify(mesh, mesh, match);
  CHECK(verdict.fault_count == 1);
  CHECK(verdict.faults[0].message == "vertices: source vertex 2 of a matched face is missing");
}

TEST_CASE("sentence 6: a vertex on which regions disagree may be listed either way, or left out") {
  // Two quads side by side, each on itself, but the second one turned by half: they disagree on their common edge.
  const Mesh mesh = build(shapes::grid(2, 1));
  Match match;
  match.regions = {{.faces = {{FaceId(0), FaceId(0), 0}}}, {.faces = {{FaceId(1), FaceId(1), 2}}}};
  list_vertices(mesh, mesh, match);
  CHECK(match.vertices.size() == 4);
  CHECK(verify(mesh, mesh, match).sound());

  const auto pair = [](std::uint32_t a, std::uint32_t b) { return VertexPair{VertexId(a), VertexId(b)}; };
  match.vertices = {pair(0, 0), pair(3, 3)};
  CHECK(verify(mesh, mesh, match).sound());
  match.vertices = {pair(0, 0), pair(1, 5), pair(2, 4), pair(3, 3), pair(4, 2), pair(5, 1)};
  CHECK(verify(mesh, mesh, match).sound());
  match.vertices = {pair(0, 0), pair(1, 3), pair(3, 1)};
  CHECK(has(verify(mesh, mesh, match), FaultKind::BadVertexList));
  match.vertices = {pair(0, 0)};
  CHECK(verify(mesh, mesh, match).fault_count == 1);
}

TEST_CASE("all faults are counted, and as many are described as were asked for") {
  const Mesh mesh = build(shapes::grid(5, 5));
  Match match;
  match.regions.emplace_back();
  for (std::uint32_t f = 0; f < 25; ++f) match.regions[0].faces.push_back({FaceId(99), FaceId(99), 0});
  const Verdict verdict = verify(mesh, mesh, match, 3);
  CHECK(verdict.fault_count == 26);
  CHECK(verdict.faults.size() == 3);
  CHECK_FALSE(verify(mesh, mesh, match, 0).sound());
}
