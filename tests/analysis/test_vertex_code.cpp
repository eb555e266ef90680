#include <quadmatch/analysis/vertex_code.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

TEST_CASE("§2.1: the code of a vertex is its valence, its place on the boundary, and what touches it") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const PerFan<VertexCode> codes = vertex_codes(mesh);
    REQUIRE(codes.size() == mesh.fan_count());
    for (std::uint32_t p = 0; p < mesh.fan_count(); ++p) {
      const FanId fan(p);
      CAPTURE(p);
      bool non_quad = false;
      for (const HalfedgeId h : mesh.outgoing(fan)) non_quad = non_quad || mesh.size(mesh.face(h)) != 4;
      CHECK(codes[fan].valence() == mesh.valence(fan));
      CHECK(codes[fan].on_boundary() == mesh.is_boundary(fan));
      CHECK(codes[fan].touches_non_quad() == non_quad);
    }
  }
}

TEST_CASE("§2.1: inside, valence 4 is regular; on the boundary, valence 3 is") {
  const Mesh grid = test::build(shapes::grid(4, 3));
  const PerFan<VertexCode> codes = vertex_codes(grid);
  std::vector<std::uint32_t> extraordinary;
  for (std::uint32_t p = 0; p < grid.fan_count(); ++p) {
    if (codes[FanId(p)].extraordinary()) extraordinary.push_back(p);
  }
  CHECK(extraordinary == std::vector<std::uint32_t>{0, 4, 15, 19});  // the corners
}

TEST_CASE("a vertex that no face uses is not extraordinary") {
  const Mesh mesh = test::build(shapes::unused_vertices());
  CHECK_FALSE(vertex_codes(mesh)[FanId(0)].extraordinary());
}

TEST_CASE("where a triangle or an n-gon touches, a vertex is extraordinary whatever its valence") {
  // A triangle in place of a quad's half: the inner vertex 4 keeps valence 4.
  const Mesh mesh = test::mesh_of(9, {{0, 1, 4, 3}, {1, 2, 5, 4}, {3, 4, 7, 6}, {4, 5, 8}, {4, 8, 7}});
  const VertexCode code = vertex_codes(mesh)[FanId(4)];
  CHECK(code.valence() == 5);
  CHECK(code.touches_non_quad());
  CHECK(code.extraordinary());
}

TEST_CASE("valences too large for a code share the largest one") {
  PolygonSoup fan;
  const std::uint32_t blades = 20000;
  fan.vertex_count = 1 + 2 * blades;
  for (std::uint32_t blade = 0; blade < blades; ++blade) {
    const std::uint32_t here = 1 + 2 * blade;
    const std::uint32_t next = 1 + 2 * ((blade + 1) % blades);
    for (const std::uint32_t v : {0U, here, here + 1, next}) fan.corners.push_back(VertexId(v));
  }
  const Mesh mesh = test::build(std::move(fan));
  const VertexCode code = vertex_codes(mesh)[FanId(0)];
  CHECK(mesh.valence(FanId(0)) == blades);
  CHECK(code.valence() == 16383);
  CHECK_FALSE(code.on_boundary());
}

}  // namespace
}  // namespace quadmatch
