#include "regions/whole_map.hpp"

#include <algorithm>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch::regions {
namespace {

/// A pair of meshes as the engine sees them, and a map between them.
class Laid {
 public:
  Laid(const Mesh& source, const Mesh& target)
      : source_codes_(vertex_codes(source)),
        target_codes_(vertex_codes(target)),
        source_arcs_(trace_separatrices(source, source_codes_)),
        target_arcs_(trace_separatrices(target, target_codes_)),
        sides_{{source, source_codes_, source_arcs_}, {target, target_codes_, target_arcs_}},
        map(sides_) {}

 private:
  PerFan<VertexCode> source_codes_, target_codes_;
  ArcGraph source_arcs_, target_arcs_;
  Sides sides_;

 public:
  WholeMap map;
};

TEST_CASE("whole map: a bear lies on its renumbered copy by one pair of half-edges, and by no other") {
  const PolygonSoup bear = shapes::bear().soup;
  const shapes::Renumbered copy = shapes::renumbered(bear, 3);
  const Mesh source = test::build(bear), target = test::build(copy.soup);
  Laid laid(source, target);
  const FacePair& truth = copy.faces[1234];
  const HalfedgeId seed = source.first(truth.source);
  const HalfedgeId image = turned(target, target.first(truth.target), truth.rotation);
  REQUIRE(laid.map.grow({seed, image}, source.face_count()));
  std::vector<bool> met(source.face_count(), false);
  for (const auto& [s, t] : laid.map.pairs()) {
    const FacePair& pair = copy.faces[source.face(s).value];
    CHECK(t == turned(target, target.first(pair.target), pair.rotation + source.corner(s)));
    CHECK(!met[source.face(s).value]);
    met[source.face(s).value] = true;
  }
  CHECK(laid.map.pairs().size() == source.face_count());
  CHECK(laid.map.waves().back() == source.face_count());
  CHECK(std::is_sorted(laid.map.waves().begin(), laid.map.waves().end()));
  for (std::uint32_t steps = 1; steps < 4; ++steps) {
    CHECK(!laid.map.grow({seed, turned(target, image, steps)}, source.face_count()));
  }
  CHECK(!laid.map.grow({seed, image}, source.face_count() - 1));  // there are more
  CHECK(laid.map.grow({seed, image}, source.face_count()));       // what failed leaves nothing behind
}

TEST_CASE("whole map: a strip whose ends touch in a vertex is not one whose ends do not") {
  const Mesh apart = test::mesh_of(8, {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}});
  const Mesh touching = test::mesh_of(7, {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 0, 6}});
  Laid one(apart, touching), other(touching, apart), same(touching, touching);
  const Candidate seed{HalfedgeId(0), HalfedgeId(0)};
  CHECK(!one.map.grow(seed, 3));
  CHECK(!other.map.grow(seed, 3));
  CHECK(same.map.grow(seed, 3));
}

TEST_CASE("whole map: a double cover of a ring is not the ring") {
  const Mesh longer = test::build(shapes::torus(8, 4)), shorter = test::build(shapes::torus(4, 4));
  Laid laid(longer, shorter);
  CHECK(!laid.map.grow({HalfedgeId(0), HalfedgeId(0)}, longer.face_count()));
}

}  // namespace
}  // namespace quadmatch::regions
