// Where faces share an edge and yet are not adjacent across it, and that the order of the faces has no say in it.

#include "named_meshes.hpp"

#include <algorithm>
#include <tuple>

#include <quadmatch/shapes/renumber.hpp>

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

using SeamKey = std::tuple<VertexId, VertexId, SeamKind, std::uint32_t>;

std::vector<SeamKey> keys_of(const Mesh& mesh) {
  std::vector<SeamKey> keys;
  for (const Seam& seam : mesh.seams()) keys.emplace_back(seam.from, seam.to, seam.kind, seam.uses);
  return keys;
}

/// The seams of a mesh under other vertex numbers.
std::vector<SeamKey> renamed(const Mesh& mesh, const PerVertex<VertexId>& numbers) {
  std::vector<SeamKey> keys;
  for (const Seam& seam : mesh.seams()) {
    const auto [low, high] = std::minmax(numbers[seam.from], numbers[seam.to]);
    keys.emplace_back(low, high, seam.kind, seam.uses);
  }
  std::sort(keys.begin(), keys.end());
  return keys;
}

}  // namespace

TEST_CASE("an edge of three faces is a seam of three uses, and none of them is adjacent across it") {
  const Mesh mesh = build(shapes::book());
  REQUIRE(mesh.seams().size() == 1);
  CHECK(mesh.seams()[0].kind == SeamKind::NonManifold);
  CHECK(mesh.seams()[0].uses == 3);
  for (std::uint32_t h = 0; h < mesh.halfedge_count(); ++h) CHECK_FALSE(mesh.twin(HalfedgeId(h)).valid());
  CHECK(mesh.edge_count() == 12);
}

TEST_CASE("an edge along which two faces run the same way is a seam") {
  const Mesh mesh = build(shapes::wrongly_wound());
  REQUIRE(mesh.seams().size() == 1);
  CHECK(mesh.seams()[0].kind == SeamKind::Winding);
  CHECK(mesh.seams()[0].uses == 2);
}

TEST_CASE("an edge that one face uses twice is a seam") {
  const Mesh mesh = mesh_of(3, {{0, 1, 0, 2}});
  REQUIRE(mesh.seams().size() == 2);
  CHECK(mesh.seams()[0].kind == SeamKind::SelfGlued);
  CHECK(mesh.seams()[1].kind == SeamKind::SelfGlued);
  CHECK(build(shapes::self_glued_face()).seams().size() == 1);
}

TEST_CASE("an edge that joins a vertex to itself is a seam") {
  const Mesh mesh = mesh_of(3, {{0, 0, 1, 2}});
  REQUIRE(mesh.seams().size() == 1);
  CHECK(mesh.seams()[0].kind == SeamKind::Degenerate);
  CHECK(mesh.seams()[0].from == VertexId(0));
  CHECK(mesh.seams()[0].to == VertexId(0));
}

TEST_CASE("a well-formed mesh has neither seams nor split vertices") {
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    CHECK(mesh.seams().empty());
    CHECK(mesh.split_vertices().empty());
    CHECK(mesh.fan_count() == mesh.vertex_count());
  }
}

TEST_CASE("seams stand in the order of their ends") {
  for (const NamedSoup& named : dirty_zoo()) {
    CAPTURE(named.name);
    const std::vector<SeamKey> keys = keys_of(build(named.soup));
    CHECK(std::is_sorted(keys.begin(), keys.end()));
  }
}

TEST_CASE("a renumbered copy of a dirty mesh has the same seams, twins and fans") {
  for (const NamedSoup& named : whole_zoo()) {
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      CAPTURE(named.name);
      CAPTURE(seed);
      const shapes::Renumbered copy = shapes::renumbered(named.soup, seed);
      const Mesh mesh = build(named.soup);
      const Mesh other = build(copy.soup);
      CHECK(renamed(mesh, copy.vertices) == keys_of(other));
      CHECK(mesh.fan_count() == other.fan_count());
      CHECK(mesh.edge_count() == other.edge_count());
      const auto image = [&](HalfedgeId h) {
        const FacePair& pair = copy.faces[mesh.face(h).value];
        const std::uint32_t corner =
            image_corner(Orientation::Preserving, pair.rotation, mesh.corner(h), mesh.size(mesh.face(h)));
        return HalfedgeId(other.first(pair.target).value + corner);
      };
      for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
        const HalfedgeId twin = mesh.twin(HalfedgeId(number));
        CHECK(other.twin(image(HalfedgeId(number))) == (twin.valid() ? image(twin) : twin));
      }
    }
  }
}
