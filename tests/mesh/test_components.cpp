#include "named_meshes.hpp"

#include <quadmatch/mesh/components.hpp>

using namespace quadmatch;
using namespace quadmatch::test;

TEST_CASE("every well-formed mesh of the zoo is one component of the dual graph") {
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    const Components components = connected_components(mesh);
    REQUIRE(components.face_count.size() == 1);
    CHECK(components.face_count[0] == mesh.face_count());
  }
}

TEST_CASE("components are numbered by their lowest face") {
  const Mesh mesh = build(shapes::disjoint_union({shapes::grid(1, 1), shapes::cube(), shapes::grid(3, 1)}));
  const Components components = connected_components(mesh);
  CHECK(components.face_count == std::vector<std::uint32_t>{1, 6, 3});
  CHECK(components.of_face[FaceId(0)] == 0);
  CHECK(components.of_face[FaceId(1)] == 1);
  CHECK(components.of_face[FaceId(7)] == 2);
}

TEST_CASE("faces that meet only at a vertex or at a seam are not connected") {
  CHECK(connected_components(build(shapes::hourglass())).face_count == std::vector<std::uint32_t>{6, 6});
  CHECK(connected_components(build(shapes::wrongly_wound())).face_count == std::vector<std::uint32_t>{1, 1});
  CHECK(connected_components(build(shapes::book())).face_count == std::vector<std::uint32_t>{1, 1, 1});
}

TEST_CASE("a mesh without faces has no component") {
  const Mesh mesh = build(PolygonSoup{.vertex_count = 3});
  CHECK(connected_components(mesh).face_count.empty());
}
