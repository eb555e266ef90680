#include "exact/slits.hpp"

#include <algorithm>
#include <cstdlib>

#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

using namespace exact;

constexpr std::uint32_t kSide = 15;

/// A grid of 15 by 15 quads laid on itself, of which the middle is in, with the labels around it.
struct Laid {
  explicit Laid(const PolygonSoup& soup = shapes::grid(kSide, kSide))
      : mesh(test::build(soup)),
        partial(mesh, mesh),
        faces_at(partial),
        slits(partial, faces_at),
        development(partial) {
    std::vector<FaceId> all, block;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      all.push_back(FaceId(f));
      if (from_middle(f) <= 3) block.push_back(FaceId(f));
    }
    partial.begin_levels(kSource, all, 100);
    partial.push_level(block, 2);
  }

  /// Faces from the middle, by columns and by rows, whichever are more.
  static std::uint32_t from_middle(std::uint32_t face) {
    const auto away = [](std::uint32_t at) { return static_cast<std::uint32_t>(std::abs(static_cast<int>(at) - 7)); };
    return std::max(away(face % kSide), away(face / kSide));
  }

  void take_middle() {
    const HalfedgeId h = mesh.first(FaceId(kSide * kSide / 2));
    partial.commit({h, h});
    extend(rim, partial, {h, h});
  }

  bool take_in(std::uint32_t spare) {
    development.spread(kSource, rim);
    return slits.take_in(development.labels(), rim, spare);
  }

  Mesh mesh;
  Partial partial;
  FacesAt faces_at;
  Slits slits;
  Development development;
  Rim rim;
};

TEST_CASE("what is deep within agreeing labels costs a slit from rim to rim to leave out, and is taken in") {
  Laid laid;
  REQUIRE(laid.slits.allowed());
  laid.take_middle();
  // Of the block of 7 by 7 at most 2 are lost, and a slit through a face in its second row has 3.
  CHECK(laid.take_in(100));
  CHECK(laid.partial.size() == 25);
  CHECK_FALSE(laid.take_in(100));
  // If 4 are lost of all, those in the third row of the whole and deeper are in.
  CHECK(laid.take_in(4));
  CHECK(laid.partial.size() == 121);
  for (const Pair& pair : laid.partial.pairs()) CHECK(pair.source == pair.target);
  // Nothing can be lost: all is in.
  CHECK(laid.take_in(0));
  CHECK(laid.partial.size() == 225);
}

TEST_CASE("a slit may end at what is out, in either mesh") {
  for (const Side side : {kSource, kTarget}) {
    Laid laid;
    laid.partial.exclude(side, FaceId(kSide * 7 + 9));
    laid.take_middle();
    CHECK(laid.take_in(2));
    // The faces around it are the first of a slit to it, so they stay open; all others but the outermost are in.
    CHECK(laid.partial.size() == 13 * 13 - 9);
    CHECK(laid.partial.is_open(kSource, FaceId(kSide * 7 + 8)));
  }
}

TEST_CASE("where a closed curve need not part a mesh, slits prove nothing") {
  const auto allowed = [](const PolygonSoup& soup) {
    const Mesh mesh = test::build(soup), plane = test::build(shapes::grid(2, 2));
    Partial one(mesh, plane), two(plane, mesh);
    const bool either = Slits(one, FacesAt(one)).allowed();
    CHECK(Slits(two, FacesAt(two)).allowed() == either);
    return either;
  };
  CHECK(allowed(shapes::grid(3, 3)));
  CHECK(allowed(shapes::sphere(3)));
  CHECK(allowed(shapes::cylinder(5, 3)));
  CHECK_FALSE(allowed(shapes::torus(6, 5)));
  CHECK_FALSE(allowed(shapes::mobius_strip(5)));
  CHECK_FALSE(allowed(shapes::book()));
  CHECK_FALSE(allowed(shapes::hourglass()));
}

}  // namespace
}  // namespace quadmatch
