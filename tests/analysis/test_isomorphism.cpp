#include <quadmatch/analysis/isomorphism.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/random_edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/verify/verify.hpp>

#include "bliss_oracle.hpp"
#include "mesh/named_meshes.hpp"
#include "random_soup.hpp"

namespace quadmatch {
namespace {

constexpr IsomorphismKind kKinds[] = {IsomorphismKind::Preserving, IsomorphismKind::Reversing, IsomorphismKind::Either};

/// Does the map pair all faces, and is it sound?
void check_isomorphism(const Mesh& source, const Mesh& target, const Isomorphism& isomorphism) {
  const Verdict verdict = verify(source, target, isomorphism.match);
  CHECK_MESSAGE(verdict.sound(), (verdict.faults.empty() ? std::string() : verdict.faults.front().message));
  CHECK(verdict.matched_faces == source.face_count());
  for (const Region& region : isomorphism.match.regions) CHECK(region.orientation == isomorphism.orientation);
  // Regions by themselves may disagree about a vertex they share; an isomorphism has one vertex map for all.
  PerVertex<VertexId> image(source.vertex_count());
  for (const VertexPair& pair : isomorphism.match.vertices) image[pair.source] = pair.target;
  for (const Region& region : isomorphism.match.regions) {
    for (const FacePair& pair : region.faces) {
      const std::uint32_t size = source.size(pair.source);
      for (std::uint32_t corner = 0; corner < size; ++corner) {
        const std::uint32_t other = image_corner(region.orientation, pair.rotation, corner, size);
        const HalfedgeId here(source.first(pair.source).value + corner), there(target.first(pair.target).value + other);
        CHECK(image[source.origin(here)] == target.origin(there));
      }
    }
  }
}

bool is_isomorphic(const Mesh& source, const Mesh& target, IsomorphismKind kind) {
  const IsomorphismResult result = find_isomorphism(source, target, kind);
  CHECK(result.isomorphism.has_value() == result.differences.empty());
  if (!result.isomorphism) return false;
  check_isomorphism(source, target, *result.isomorphism);
  if (kind == IsomorphismKind::Preserving) CHECK(result.isomorphism->orientation == Orientation::Preserving);
  if (kind == IsomorphismKind::Reversing) CHECK(result.isomorphism->orientation == Orientation::Reversing);
  return true;
}

std::uint64_t preserving(const Mesh& mesh) { return count_automorphisms(mesh).preserving.value().value(); }
std::uint64_t all(const Mesh& mesh) { return count_automorphisms(mesh).all.value().value(); }

/// As bliss counts them, both ways.
void check_count(const Mesh& mesh) {
  const Automorphisms automorphisms = count_automorphisms(mesh);
  const auto agrees = [](const GroupOrder& ours, long double theirs) {
    if (const auto value = ours.value()) return static_cast<long double>(*value) == theirs;
    return std::abs(ours.log10() - static_cast<double>(std::log10(theirs))) < 1e-9 * ours.log10();
  };
  CHECK(agrees(automorphisms.preserving, test::automorphisms_by_bliss(mesh, false)));
  CHECK(agrees(automorphisms.all, test::automorphisms_by_bliss(mesh, true)));
}

Mesh renumbered(const PolygonSoup& soup, std::uint64_t seed) {
  return test::build(shapes::renumbered(soup, seed).soup);
}

TEST_CASE("isomorphism: a renumbered mesh of the zoo is the same, and the map is sound") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup), copy = renumbered(soup, 7);
    CHECK(is_isomorphic(mesh, copy, IsomorphismKind::Preserving));
    CHECK(is_isomorphic(mesh, copy.mirrored(), IsomorphismKind::Reversing));
    CHECK(is_isomorphic(mesh, copy.mirrored(), IsomorphismKind::Either));
  }
}

TEST_CASE("isomorphism: two meshes of the zoo are the same exactly if bliss says so") {
  std::vector<Mesh> zoo;
  for (const auto& [name, soup] : test::whole_zoo()) zoo.push_back(test::build(soup));
  for (const Mesh& source : zoo) {
    for (const Mesh& target : zoo) {
      const bool reversing = test::same_by_bliss(source, target.mirrored(), false);
      CHECK(is_isomorphic(source, target, IsomorphismKind::Preserving) == test::same_by_bliss(source, target, false));
      CHECK(is_isomorphic(source, target, IsomorphismKind::Reversing) == reversing);
      CHECK(is_isomorphic(source, target, IsomorphismKind::Either) == test::same_by_bliss(source, target, true));
    }
  }
}

TEST_CASE("automorphisms: every mesh of the zoo has as many as bliss counts, with reversing ones and without") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    check_count(test::build(soup));
  }
  for (std::uint32_t k = 1; k <= 4; ++k) check_count(test::build(shapes::cube_subdivided(k)));
  for (std::uint32_t n = 3; n <= 6; ++n) {
    check_count(test::build(shapes::prism(n)));
    check_count(test::build(shapes::star(n, 2)));
    check_count(test::build(shapes::klein_bottle(n, 4)));
    check_count(test::build(shapes::mobius_strip(n)));
    check_count(test::build(shapes::observation_2_2(n)));
    check_count(test::build(shapes::torus(n, 4)));
    check_count(test::build(shapes::many_components(n)));
  }
}

TEST_CASE("automorphisms: random soups, dirty as can be, have as many as bliss counts") {
  for (std::uint64_t seed = 0; seed < 4000; ++seed) {
    CAPTURE(seed);
    check_count(test::build(test::random_soup(seed, 8, 10)));
  }
}

TEST_CASE("isomorphism: a renumbered random soup is the same, and the map is sound") {
  for (std::uint64_t seed = 0; seed < 1500; ++seed) {
    CAPTURE(seed);
    const PolygonSoup soup = test::random_soup(seed, 9, 14);
    const Mesh mesh = test::build(soup), copy = renumbered(soup, seed);
    CHECK(is_isomorphic(mesh, copy, IsomorphismKind::Preserving));
    CHECK(is_isomorphic(mesh, copy.mirrored(), IsomorphismKind::Reversing));
  }
}

TEST_CASE("isomorphism: near-equal soups are the same exactly if bliss says so") {
  std::size_t same = 0, different = 0;
  for (std::uint64_t seed = 0; seed < 3000; ++seed) {
    CAPTURE(seed);
    const PolygonSoup soup = test::random_soup(seed, 6, 8);
    // One corner of one face moves to another vertex.
    PolygonSoup other = shapes::renumbered(soup, seed).soup;
    shapes::Random random(seed);
    other.corners[random.below(static_cast<std::uint32_t>(other.corners.size()))] =
        VertexId(random.below(other.vertex_count));
    const Mesh source = test::build(soup), target = test::build(std::move(other));
    for (const IsomorphismKind kind : kKinds) {
      const bool expected = kind == IsomorphismKind::Reversing
                                ? test::same_by_bliss(source, target.mirrored(), false)
                                : test::same_by_bliss(source, target, kind == IsomorphismKind::Either);
      CHECK(is_isomorphic(source, target, kind) == expected);
      ++(expected ? same : different);
    }
  }
  CHECK(same > 100);
  CHECK(different > 100);
}

TEST_CASE("automorphisms: a cube turns into itself in 24 ways, in 48 with the mirror; refinement changes nothing") {
  for (std::uint32_t k : {1U, 2U, 5U, 16U}) {
    const Mesh mesh = test::build(shapes::cube_subdivided(k));
    CHECK(preserving(mesh) == 24);
    CHECK(all(mesh) == 48);
  }
}

TEST_CASE("automorphisms: grids, tubes, tori and stars have those one can see") {
  CHECK(all(test::build(shapes::grid(7, 4))) == 4);
  CHECK(all(test::build(shapes::grid(5, 5))) == 8);
  CHECK(all(test::build(shapes::grid(1, 1))) == 8);
  CHECK(preserving(test::build(shapes::cylinder(9, 4))) == 18);
  CHECK(preserving(test::build(shapes::torus(120, 70))) == 2 * 120 * 70);
  CHECK(preserving(test::build(shapes::torus(60, 60))) == 4 * 60 * 60);
  CHECK(all(test::build(shapes::torus(60, 60))) == 8 * 60 * 60);
  CHECK(all(test::build(shapes::star(5, 40))) == 10);
}

TEST_CASE("automorphisms: a grating of genus 256 has those of a square plate") {
  const PolygonSoup soup = shapes::grating(16, 16);
  const Mesh mesh = test::build(soup);
  CHECK(preserving(mesh) == 8);  // four turns, each also upside down
  CHECK(all(mesh) == 16);
  CHECK(is_isomorphic(mesh, renumbered(soup, 5), IsomorphismKind::Preserving));
}

TEST_CASE("automorphisms: ten thousand cubes turn by themselves and change places") {
  const PolygonSoup soup = shapes::many_components(10000);
  const Automorphisms automorphisms = count_automorphisms(test::build(soup));
  CHECK_FALSE(automorphisms.preserving.value().has_value());
  CHECK(automorphisms.preserving.describe() == "24^10000 * 10000!");
  CHECK(automorphisms.all.describe() == "24^10000 * 2 * 10000!");
  // log10 of 10000! is 35659.454...; of 24, 1.380211...
  CHECK(automorphisms.preserving.log10() == doctest::Approx(35659.4542745 + 13802.1124171).epsilon(1e-10));
  CHECK(is_isomorphic(test::build(soup), renumbered(soup, 2), IsomorphismKind::Preserving));
}

TEST_CASE("isomorphism: the only map of a bear on its renumbered self is the true one") {
  const PolygonSoup soup = shapes::bear().soup;
  const shapes::Renumbered copy = shapes::renumbered(soup, 3);
  const Mesh source = test::build(soup), target = test::build(copy.soup);
  const IsomorphismResult result = find_isomorphism(source, target, IsomorphismKind::Preserving);
  REQUIRE(result.isomorphism.has_value());
  CHECK(result.isomorphism->ways.value() == preserving(source));
  REQUIRE(result.isomorphism->match.regions.size() == 1);
  if (preserving(source) == 1) {
    std::vector<FacePair> faces = result.isomorphism->match.regions[0].faces;
    std::sort(faces.begin(), faces.end(), [](const FacePair& a, const FacePair& b) { return a.source < b.source; });
    CHECK(faces == copy.faces);
  }
}

TEST_CASE("isomorphism: a mesh with a left and a right part is its mirror image, two left parts are not") {
  // Four quads in the shape of an S; the mirror image is a Z.
  const PolygonSoup left = test::soup_of(12, {{0, 1, 5, 4}, {1, 2, 6, 5}, {5, 6, 10, 9}, {6, 7, 11, 10}});
  const Mesh chiral = test::build(left);
  REQUIRE_FALSE(is_isomorphic(chiral, chiral.mirrored(), IsomorphismKind::Preserving));
  PolygonSoup right = left;
  for (std::size_t f = 0; f + 1 < right.face_starts.size(); ++f) {
    std::reverse(right.corners.begin() + right.face_starts[f], right.corners.begin() + right.face_starts[f + 1]);
  }
  const Mesh pair = test::build(shapes::disjoint_union({left, right}));
  const Mesh two_left = test::build(shapes::disjoint_union({left, left}));
  CHECK(is_isomorphic(pair, pair, IsomorphismKind::Reversing));
  CHECK_FALSE(is_isomorphic(two_left, two_left, IsomorphismKind::Reversing));
  // A map that turns over one part of the two only is none.
  CHECK_FALSE(is_isomorphic(pair, two_left, IsomorphismKind::Either));
  check_count(pair);
  check_count(two_left);
}

TEST_CASE("isomorphism: an empty mesh is the same as itself, in one way") {
  const Mesh empty = test::mesh_of(0, {});
  for (const IsomorphismKind kind : kKinds) CHECK(is_isomorphic(empty, empty, kind));
  CHECK(preserving(empty) == 1);
  CHECK(all(empty) == 1);
}

TEST_CASE("isomorphism: vertices that no face uses are counted, and nothing more") {
  const Mesh one = test::mesh_of(1, {}), two = test::mesh_of(2, {});
  CHECK(is_isomorphic(one, one, IsomorphismKind::Either));
  CHECK_FALSE(is_isomorphic(one, two, IsomorphismKind::Either));
  CHECK(all(two) == 1);
  CHECK(find_isomorphism(one, two).differences.front() == "the source has 1 vertex, the target 2");
}

TEST_CASE("isomorphism: which pieces meet in a vertex counts, where no walk across edges would see it") {
  // Four quads, each its own component: touching in a ring, or three in a row and a fourth at the middle one.
  const Mesh ring = test::mesh_of(12, {{0, 4, 1, 5}, {1, 6, 2, 7}, {2, 8, 3, 9}, {3, 10, 0, 11}});
  const Mesh other = test::mesh_of(12, {{0, 4, 1, 5}, {1, 6, 2, 7}, {2, 8, 3, 9}, {3, 0, 10, 11}});
  CHECK_FALSE(is_isomorphic(ring, other, IsomorphismKind::Either));
  CHECK(is_isomorphic(ring, ring.mirrored(), IsomorphismKind::Reversing));
  check_count(ring);
  check_count(other);
}

/// A graph as quads: a vertex for each of its nodes, and for each edge a quad between the two that touches nothing
/// else.
PolygonSoup quads_of_graph(std::uint32_t nodes, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& edges) {
  PolygonSoup soup;
  soup.vertex_count = nodes;
  for (const auto& [from, to] : edges) {
    const std::uint32_t side = soup.vertex_count;
    soup.vertex_count += 2;
    for (const std::uint32_t v : {from, side, to, side + 1}) soup.corners.push_back(VertexId(v));
  }
  return soup;
}

TEST_CASE("automorphisms: tied pieces can be any graph: complete graphs, cycles, Petersen's, a cube's") {
  using Edges = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
  Edges complete, cycle, petersen, cube;
  for (std::uint32_t i = 0; i < 9; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) complete.emplace_back(i, j);
  }
  for (std::uint32_t i = 0; i < 300; ++i) cycle.emplace_back(i, (i + 1) % 300);
  for (std::uint32_t i = 0; i < 5; ++i) {
    petersen.emplace_back(i, (i + 1) % 5);
    petersen.emplace_back(i, i + 5);
    petersen.emplace_back(i + 5, (i + 2) % 5 + 5);
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    for (const std::uint32_t bit : {1U, 2U, 4U}) {
      if ((i & bit) == 0) cube.emplace_back(i, i | bit);
    }
  }
  // A quad between two nodes can be turned by half, and then runs from one to the other: it is an edge.
  CHECK(preserving(test::build(quads_of_graph(9, complete))) == 362880);
  CHECK(preserving(test::build(quads_of_graph(300, cycle))) == 600);
  CHECK(preserving(test::build(quads_of_graph(10, petersen))) == 120);
  CHECK(preserving(test::build(quads_of_graph(8, cube))) == 48);
  for (const auto& [nodes, edges] : {std::pair(9U, complete), std::pair(10U, petersen), std::pair(8U, cube)}) {
    const PolygonSoup soup = quads_of_graph(nodes, edges);
    check_count(test::build(soup));
    CHECK(is_isomorphic(test::build(soup), renumbered(soup, 4), IsomorphismKind::Preserving));
  }
}

TEST_CASE("isomorphism: regular graphs that look alike everywhere are told apart: two triangles and a hexagon") {
  const Mesh triangles = test::build(quads_of_graph(6, {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5}, {5, 3}}));
  const Mesh hexagon = test::build(quads_of_graph(6, {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}}));
  CHECK_FALSE(is_isomorphic(triangles, hexagon, IsomorphismKind::Either));
  // Rook's graph and Shrikhande's: strongly regular with the same parameters, refinement alone sees no difference.
  std::vector<std::pair<std::uint32_t, std::uint32_t>> rook, shrikhande;
  for (std::uint32_t i = 0; i < 16; ++i) {
    for (std::uint32_t j = 0; j < i; ++j) {
      const std::uint32_t dx = (i % 4 + 4 - j % 4) % 4, dy = (i / 4 + 4 - j / 4) % 4;
      if ((dx == 0) != (dy == 0)) rook.emplace_back(i, j);
      const bool beside = (dx == 0 && dy % 2 == 1) || (dy == 0 && dx % 2 == 1) || (dx == dy && dx % 2 == 1);
      if (beside) shrikhande.emplace_back(i, j);
    }
  }
  const Mesh one = test::build(quads_of_graph(16, rook)), other = test::build(quads_of_graph(16, shrikhande));
  CHECK(preserving(one) == 1152);
  CHECK(preserving(other) == 192);
  CHECK_FALSE(is_isomorphic(one, other, IsomorphismKind::Either));
}

TEST_CASE("automorphisms: many pieces at one vertex, in a chain, and at one edge") {
  // A thousand cubes at one vertex; a chain of cubes corner to corner; a book of a thousand pages.
  PolygonSoup bouquet, chain, book;
  const std::uint32_t many = 1000;
  const PolygonSoup cube = shapes::cube();
  const auto add_cube = [&cube](PolygonSoup& soup, std::uint32_t first, auto number) {
    for (const VertexId v : cube.corners) soup.corners.push_back(VertexId(number(first, v.value)));
  };
  for (std::uint32_t k = 0; k < many; ++k) {
    add_cube(bouquet, 7 * k, [](std::uint32_t first, std::uint32_t v) { return v == 0 ? 0 : first + v; });
    for (const std::uint32_t v : {0U, 1U, 2 * k + 2, 2 * k + 3}) book.corners.push_back(VertexId(v));
  }
  bouquet.vertex_count = 7 * many + 1;
  book.vertex_count = 2 * many + 2;
  const Mesh mesh = test::build(cube);
  // The corner opposite to vertex 0 shares no face with it.
  std::uint32_t opposite = 0;
  for (std::uint32_t v = 1; v < 8; ++v) {
    bool shares = false;
    for (std::uint32_t f = 0; f < 6; ++f) {
      bool has_both[2] = {false, false};
      for (const HalfedgeId h : mesh.halfedges(FaceId(f))) {
        has_both[0] = has_both[0] || mesh.origin(h).value == 0;
        has_both[1] = has_both[1] || mesh.origin(h).value == v;
      }
      shares = shares || (has_both[0] && has_both[1]);
    }
    if (!shares) opposite = v;
  }
  for (std::uint32_t k = 0; k < many; ++k) {
    add_cube(chain, 7 * k, [opposite](std::uint32_t first, std::uint32_t v) {
      if (v == opposite) return first + 7;
      return first + v - (v > opposite ? 1 : 0);
    });
  }
  chain.vertex_count = 7 * many + 1;
  CHECK(count_automorphisms(test::build(bouquet)).preserving.describe() == "3^1000 * 1000!");
  CHECK(count_automorphisms(test::build(chain)).preserving.describe() == "3^1000 * 2");
  CHECK(count_automorphisms(test::build(book)).preserving.describe() == "1000!");
  for (const PolygonSoup* soup : {&bouquet, &chain, &book}) {
    CHECK(is_isomorphic(test::build(*soup), renumbered(*soup, 6), IsomorphismKind::Preserving));
  }
}

TEST_CASE("isomorphism: an edited copy is different, and it is said in what") {
  const PolygonSoup bear = shapes::bear().soup;
  for (const shapes::RandomEditKind& kind : shapes::random_edit_kinds()) {
    CAPTURE(kind.name);
    shapes::Random random(11);
    const Expected<shapes::Edit> edit = edit_at_random(bear, {kind.name, kind.size}, random);
    REQUIRE(edit.has_value());
    const bool same = is_isomorphic(test::build(bear), test::build(edit->soup), IsomorphismKind::Either);
    CHECK(same == (std::string(kind.name) == "renumber"));
  }
}

TEST_CASE("isomorphism: counts that are different are told in words") {
  const auto differences = [](const PolygonSoup& source, const PolygonSoup& target) {
    return find_isomorphism(test::build(source), test::build(target)).differences;
  };
  const std::vector<std::string> cubes = differences(shapes::many_components(12), shapes::many_components(11));
  CHECK(std::count(cubes.begin(), cubes.end(), "the source has 12 components of 6 faces, the target 11") == 1);
  const std::vector<std::string> corners = differences(shapes::prism(3), shapes::cube());
  CHECK(std::count(corners.begin(), corners.end(), "the source has 2 faces of 3 corners, the target none") == 1);
  CHECK(differences(shapes::torus(4, 9), shapes::torus(6, 6)) ==
        std::vector<std::string>{"all counts agree, but no map keeps which faces share their vertices"});
  CHECK(differences(shapes::disjoint_union({shapes::torus(4, 9), shapes::cube()}),
                    shapes::disjoint_union({shapes::cube(), shapes::torus(6, 6)})) ==
        std::vector<std::string>{"all counts agree, but 1 of 2 parts of the source have no equal in the target: the "
                                 "largest is the one of f0, 36 faces; there it is the one of f6, 36 faces"});
}

}  // namespace
}  // namespace quadmatch
