#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <vector>

#include <quadmatch/analysis/signature.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/random_edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/shapes/zoo.hpp>

using namespace quadmatch;

namespace {

Mesh built(PolygonSoup soup) {
  Expected<Mesh> mesh = Mesh::build(std::move(soup));
  REQUIRE(mesh);
  return *std::move(mesh);
}

/// How many values two signatures have in common.
std::size_t common(const Signature& one, const Signature& other) {
  const std::set<std::uint32_t> values(one.values.begin(), one.values.end());
  return static_cast<std::size_t>(std::count_if(other.values.begin(), other.values.end(),
                                                [&](std::uint32_t value) { return values.count(value) == 1; }));
}

std::vector<PolygonSoup> zoo() {
  return {shapes::bear().soup,   shapes::shirt(shapes::Sleeves::Short).soup,
          shapes::dog_toy(3, 5), shapes::star(5, 4),
          shapes::prism(7),      shapes::torus(6, 5)};
}

}  // namespace

TEST_CASE("a renumbered mesh has the same signature") {
  for (const PolygonSoup& soup : zoo()) {
    const Signature signature = signature_of(built(soup), 200);
    CHECK(signature_of(built(shapes::renumbered(soup, 7).soup), 200) == signature);
    CHECK(signature.values.size() == std::min<std::size_t>(200, signature.elements));
    CHECK(signature.elements > 0);
  }
}

TEST_CASE("a mirror image has the same signature") {
  for (const PolygonSoup& soup : zoo()) {
    const Mesh mesh = built(soup);
    CHECK(signature_of(mesh.mirrored(), 200) == signature_of(mesh, 200));
  }
}

TEST_CASE("a shorter signature is the beginning of a longer one") {
  const Mesh bear = built(shapes::bear().soup);
  const Signature longer = signature_of(bear, 500);
  const Signature shorter = signature_of(bear, 50);
  CHECK(shorter.elements == longer.elements);
  REQUIRE(shorter.values.size() == 50);
  CHECK(std::equal(shorter.values.begin(), shorter.values.end(), longer.values.begin()));
}

TEST_CASE("a light edit leaves most of a signature, another model has next to nothing of it") {
  const PolygonSoup bear = shapes::bear().soup;
  const Signature signature = signature_of(built(bear), 128);
  for (const char* const name : {"delete", "extrude", "collapse", "rip", "loop"}) {
    CAPTURE(name);
    shapes::Random random(3);
    const Expected<shapes::RandomEdit> edit = shapes::parse_random_edit(name);
    REQUIRE(edit);
    const Expected<shapes::Edit> edited = shapes::edit_at_random(bear, *edit, random);
    REQUIRE(edited);
    CHECK(common(signature_of(built(edited->soup), 128), signature) >= 40);
  }
  CHECK(common(signature_of(built(shapes::shirt(shapes::Sleeves::Long).soup), 128), signature) <= 12);
}

TEST_CASE("meshes without extraordinary vertices are told apart by their sizes") {
  const Signature torus = signature_of(built(shapes::torus(20, 20)), 128);
  CHECK(torus.elements == 3);
  CHECK(common(signature_of(built(shapes::torus(20, 20)), 128), torus) == 3);
  CHECK(common(signature_of(built(shapes::torus(20, 21)), 128), torus) >= 1);
  CHECK(common(signature_of(built(shapes::torus(20, 60)), 128), torus) == 0);
}
