#include <quadmatch/analysis/anchors.hpp>

#include <algorithm>
#include <vector>

#include <quadmatch/shapes/renumber.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

AnchorSearch search(const Mesh& source, const Mesh& target, const AnchorOptions& options = {}) {
  const PerFan<VertexCode> source_codes = vertex_codes(source);
  const PerFan<VertexCode> target_codes = vertex_codes(target);
  return find_anchors(source, trace_skeleton(source, source_codes).skeleton, source_codes, target,
                      trace_skeleton(target, target_codes).skeleton, target_codes, options);
}

/// Three petals of different depths about one vertex of valence 3: nothing in it is like anything else.
PolygonSoup unlike() {
  PolygonSoup star = shapes::star(5, 2);
  // Two more quads on the rim break the symmetry.
  const std::uint32_t v = star.vertex_count;
  Mesh mesh = test::build(star);
  std::uint32_t rim = 0;
  while (mesh.twin(HalfedgeId(rim)).valid()) ++rim;
  const VertexId a = mesh.origin(HalfedgeId(rim));
  const VertexId b = mesh.tip(HalfedgeId(rim));
  star.vertex_count += 4;
  star.positions.clear();
  for (const VertexId c : {b, a, VertexId(v), VertexId(v + 1)}) star.corners.push_back(c);
  for (const VertexId c : {VertexId(v + 1), VertexId(v), VertexId(v + 2), VertexId(v + 3)}) star.corners.push_back(c);
  return star;
}

TEST_CASE("§4.1: where a colour is unique in both meshes, the anchor is the true pair") {
  const PolygonSoup soup = unlike();
  const Mesh source = test::build(soup);
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    CAPTURE(seed);
    const shapes::Renumbered copy = shapes::renumbered(soup, seed);
    const Mesh target = test::build(copy.soup);
    const AnchorSearch found = search(source, target);
    REQUIRE_FALSE(found.anchors.empty());
    CHECK_FALSE(found.arbitrary);
    CHECK(found.source_rarity == 1);
    CHECK(found.target_rarity == 1);
    const Anchor anchor = found.anchors.front();
    CHECK(copy.vertices[source.origin(anchor.source)] == target.origin(anchor.target));
    CHECK(copy.vertices[source.tip(anchor.source)] == target.tip(anchor.target));
  }
}

TEST_CASE("§4.1: the search stops at the first round with a unique pair") {
  const Mesh mesh = test::build(shapes::star(5, 2));  // the middle is the only vertex of valence 5
  CHECK(search(mesh, mesh).rounds == 1);
}

TEST_CASE("§4.1: the search makes k rounds where no colour is unique, and takes the rarest") {
  const Mesh cube = test::build(shapes::cube_subdivided(3));
  const AnchorSearch found = search(cube, cube, {.rounds = 4});
  CHECK(found.rounds == 4);
  CHECK(found.source_rarity == 8);
  CHECK(found.target_rarity == 8);
  CHECK_FALSE(found.anchors.empty());
}

/// A star with one more quad at the end of each particle's way: the middle alone is as before, and all it sees is not.
PolygonSoup star_with_flaps(std::uint32_t petals, std::uint32_t depth) {
  PolygonSoup star = shapes::star(petals, depth);
  const Mesh mesh = test::build(star);
  const Tracing tracing = trace_skeleton(mesh, vertex_codes(mesh));
  std::vector<VertexId> ends;  // nodes of the skeleton where the boundary stopped a particle
  for (const FanId node : tracing.skeleton.nodes) {
    if (!vertex_codes(mesh)[node].extraordinary()) ends.push_back(mesh.vertex(node));
  }
  REQUIRE(ends.size() == petals);
  std::vector<HalfedgeId> flapped;
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) {
    const HalfedgeId rim(h);
    if (mesh.twin(rim).valid()) continue;
    if (std::find(ends.begin(), ends.end(), mesh.origin(rim)) != ends.end()) flapped.push_back(rim);
  }
  star.positions.clear();
  for (const HalfedgeId rim : flapped) {
    const std::uint32_t v = star.vertex_count;
    star.vertex_count += 2;
    for (const VertexId c : {mesh.tip(rim), mesh.origin(rim), VertexId(v), VertexId(v + 1)}) star.corners.push_back(c);
  }
  return star;
}

TEST_CASE("§4.1: a vertex that is unique by its code alone is an anchor, even if an edit changed all it sees") {
  const Mesh before = test::build(shapes::star(7, 3));
  const Mesh after = test::build(star_with_flaps(7, 3));
  const AnchorSearch found = search(before, after);
  REQUIRE_FALSE(found.anchors.empty());
  CHECK(found.source_rarity == 1);
  CHECK(found.target_rarity == 1);
  CHECK(before.origin(found.anchors.front().source) == VertexId(0));
  CHECK(after.origin(found.anchors.front().target) == VertexId(0));
}

TEST_CASE("§4.1: without extraordinary vertices any pair will do") {
  const Mesh torus = test::build(shapes::torus(5, 4));
  const AnchorSearch found = search(torus, torus);
  CHECK(found.arbitrary);
  CHECK(found.anchors.size() == 1);
  const Mesh tube = test::build(shapes::cylinder(5, 4));
  const Anchor anchor = search(tube, tube).anchors.front();
  CHECK_FALSE(tube.twin(anchor.source).valid());  // a boundary on a boundary
  CHECK_FALSE(tube.twin(anchor.target).valid());
}

TEST_CASE("a rotationally symmetric neighbourhood gives all its alignments, as many as are asked for") {
  const Mesh star = test::build(shapes::star(6, 3));
  CHECK(search(star, star).anchors.size() == 6);
  CHECK(search(star, star, {.count = 4}).anchors.size() == 4);
}

TEST_CASE("a small component with a unique colour does not keep the search from telling the large one apart") {
  // Alone, the little star is unique at round 1; the anchor must still be in the large mesh.
  const PolygonSoup large = unlike();
  const Mesh mesh = test::build(shapes::disjoint_union({shapes::star(7, 1), large, large}));
  const Mesh alone = test::build(shapes::disjoint_union({shapes::star(7, 1), large}));
  const AnchorSearch found = search(alone, alone);
  REQUIRE_FALSE(found.anchors.empty());
  CHECK(alone.face(found.anchors.front().source).value >= 7);  // the little star's faces come first
  CHECK(search(mesh, mesh).anchors.front() == search(mesh, mesh).anchors.front());
}

TEST_CASE("meshes with no colour in common get an arbitrary anchor, and one that can be laid") {
  const Mesh cube = test::build(shapes::cube());
  const Mesh grid = test::build(shapes::grid(3, 3));
  const AnchorSearch found = search(cube, grid);
  CHECK(found.arbitrary);
  for (const Anchor& anchor : found.anchors) {
    CHECK(cube.size(cube.face(anchor.source)) == grid.size(grid.face(anchor.target)));
  }
}

}  // namespace
}  // namespace quadmatch
