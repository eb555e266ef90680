#include <quadmatch/analysis/connectivity_hash.hpp>

#include <set>

#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/random_edit.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "bliss_oracle.hpp"
#include "mesh/named_meshes.hpp"
#include "random_soup.hpp"

namespace quadmatch {
namespace {

TEST_CASE("hash: a mesh of the zoo keeps it when renumbered, and every other has another") {
  std::set<Digest> met;
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const ConnectivityHash hash = connectivity_hash(test::build(soup));
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      CHECK(connectivity_hash(test::build(shapes::renumbered(soup, seed).soup)) == hash);
    }
    CHECK(met.insert(hash.unoriented()).second);
  }
}

TEST_CASE("hash: the mirror image has the two hashes the other way round, and the same unoriented one") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const ConnectivityHash hash = connectivity_hash(mesh), mirrored = connectivity_hash(mesh.mirrored());
    CHECK(hash.oriented == mirrored.mirrored);
    CHECK(hash.mirrored == mirrored.oriented);
    CHECK(hash.unoriented() == mirrored.unoriented());
    CHECK((hash.oriented == hash.mirrored) == test::same_by_bliss(mesh, mesh.mirrored(), false));
  }
}

TEST_CASE("hash: random soups keep it when renumbered; two have the same exactly if bliss finds them the same") {
  std::vector<Mesh> meshes;
  std::vector<ConnectivityHash> hashes;
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    CAPTURE(seed);
    const PolygonSoup soup = test::random_soup(seed, 5, 3);
    meshes.push_back(test::build(soup));
    hashes.push_back(connectivity_hash(meshes.back()));
    CHECK(connectivity_hash(test::build(shapes::renumbered(soup, seed).soup)) == hashes.back());
  }
  std::size_t same = 0;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      CAPTURE(i);
      CAPTURE(j);
      const bool alike = test::same_by_bliss(meshes[i], meshes[j], false);
      CHECK((hashes[i].oriented == hashes[j].oriented) == alike);
      CHECK((hashes[i].unoriented() == hashes[j].unoriented()) == test::same_by_bliss(meshes[i], meshes[j], true));
      same += alike ? 1 : 0;
    }
  }
  CHECK(same > 10);
}

TEST_CASE("hash: an edited copy has another") {
  const PolygonSoup bear = shapes::bear().soup;
  const ConnectivityHash hash = connectivity_hash(test::build(bear));
  for (const shapes::RandomEditKind& kind : shapes::random_edit_kinds()) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      CAPTURE(kind.name);
      CAPTURE(seed);
      shapes::Random random(seed);
      const Expected<shapes::Edit> edit = edit_at_random(bear, {kind.name, kind.size}, random);
      REQUIRE(edit.has_value());
      const bool same = connectivity_hash(test::build(edit->soup)).unoriented() == hash.unoriented();
      CHECK(same == (std::string(kind.name) == "renumber"));
    }
  }
}

TEST_CASE("hash: positions do not enter") {
  PolygonSoup cube = shapes::cube();
  const ConnectivityHash hash = connectivity_hash(test::build(cube));
  for (Point& p : cube.positions) p = {p[1] * 3, p[0], -p[2]};
  CHECK(connectivity_hash(test::build(cube)) == hash);
  cube.positions.clear();
  CHECK(connectivity_hash(test::build(cube)) == hash);
}

}  // namespace
}  // namespace quadmatch
