// What §2.1 asks of the representation: lists around faces and vertices in order, both ends of an edge in no time.

#include "named_meshes.hpp"

#include <algorithm>
#include <numeric>

#include <quadmatch/shapes/renumber.hpp>

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

std::vector<HalfedgeId> outgoing(const Mesh& mesh, FanId fan) {
  std::vector<HalfedgeId> list;
  for (const HalfedgeId h : mesh.outgoing(fan)) list.push_back(h);
  return list;
}

/// Start both at their least member: a cyclic list has no first.
std::vector<HalfedgeId> from_least(std::vector<HalfedgeId> cycle) {
  std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
  return cycle;
}

}  // namespace

TEST_CASE("§2.1: a face is listed in order: next and prev are inverse, and n steps walk round n corners") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      std::uint32_t corner = 0;
      HalfedgeId expected = mesh.first(FaceId(f));
      for (const HalfedgeId h : mesh.halfedges(FaceId(f))) {
        REQUIRE(h == expected);
        CHECK(mesh.face(h) == FaceId(f));
        CHECK(mesh.corner(h) == corner++);
        CHECK(mesh.prev(mesh.next(h)) == h);
        CHECK(mesh.next(mesh.prev(h)) == h);
        CHECK(mesh.tip(h) == mesh.origin(mesh.next(h)));
        expected = mesh.next(h);
      }
      CHECK(corner == mesh.size(FaceId(f)));
      CHECK(expected == mesh.first(FaceId(f)));
    }
  }
}

TEST_CASE("twins are mutual, lie in different faces and run opposite ways along one edge") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    std::uint32_t paired = 0;
    for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
      const HalfedgeId h(number);
      const HalfedgeId other = mesh.twin(h);
      CHECK(mesh.edge(h).value <= number);
      if (!other.valid()) continue;
      ++paired;
      CHECK(mesh.twin(other) == h);
      CHECK(mesh.edge(other) == mesh.edge(h));
      CHECK(mesh.face(other) != mesh.face(h));
      CHECK(mesh.origin(other) == mesh.tip(h));
      CHECK(mesh.tip(other) == mesh.origin(h));
    }
    CHECK(mesh.edge_count() == mesh.halfedge_count() - paired / 2);
  }
}

TEST_CASE("every corner belongs to exactly one fan, and every fan to one vertex") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    std::vector<std::uint32_t> visits(mesh.halfedge_count(), 0);
    for (std::uint32_t p = 0; p < mesh.fan_count(); ++p) {
      for (const HalfedgeId h : mesh.outgoing(FanId(p))) {
        ++visits[h.value];
        CHECK(mesh.fan(h) == FanId(p));
        CHECK(mesh.origin(h) == mesh.vertex(FanId(p)));
      }
    }
    CHECK(std::all_of(visits.begin(), visits.end(), [](std::uint32_t count) { return count == 1; }));
  }
}

TEST_CASE("§2.1: edges around a vertex are listed counter-clockwise, from the first to the last on the boundary") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    for (std::uint32_t p = 0; p < mesh.fan_count(); ++p) {
      const std::vector<HalfedgeId> list = outgoing(mesh, FanId(p));
      if (list.empty()) continue;
      CHECK(mesh.is_boundary(FanId(p)) == !mesh.rotate_cw(list.front()).valid());
      CHECK(mesh.is_boundary(FanId(p)) == !mesh.rotate_ccw(list.back()).valid());
      for (std::size_t i = 1; i < list.size(); ++i) {
        CHECK(mesh.rotate_cw(list[i]) == list[i - 1]);
        CHECK(mesh.twin(mesh.prev(list[i - 1])) == list[i]);
      }
    }
  }
}

TEST_CASE("the valence of a grid's vertex is 2 at a corner, 3 on a side and 4 inside") {
  const Mesh mesh = build(shapes::grid(3, 3));
  CHECK(mesh.valence(FanId(0)) == 2);
  CHECK(mesh.valence(FanId(1)) == 3);
  CHECK(mesh.valence(FanId(5)) == 4);
  CHECK(mesh.is_boundary(FanId(1)));
  CHECK_FALSE(mesh.is_boundary(FanId(5)));
  CHECK(mesh.valence(FanId(0)) == outgoing(mesh, FanId(0)).size() + 1);
  CHECK(mesh.valence(FanId(5)) == outgoing(mesh, FanId(5)).size());
}

TEST_CASE("the heart of a star has the valence it was made with, and its dog toy's poles theirs") {
  CHECK(build(shapes::star(7, 2)).valence(FanId(0)) == 7);
  const Mesh toy = build(shapes::dog_toy(3));
  const auto of_pole = [&toy](std::uint32_t p) { return toy.valence(FanId(p)) == 2 * 3 + 2; };
  std::vector<std::uint32_t> vertices(toy.vertex_count());
  std::iota(vertices.begin(), vertices.end(), 0U);
  CHECK(std::count_if(vertices.begin(), vertices.end(), of_pole) == 4);
}

TEST_CASE("a vertex of two fans owns its own fan and a further one, and each is walked alone") {
  const Mesh mesh = build(shapes::hourglass());
  REQUIRE(mesh.split_vertices().size() == 1);
  const VertexId waist = mesh.split_vertices()[0];
  CHECK(mesh.fan_count() == mesh.vertex_count() + 1);
  const FanId further(mesh.vertex_count());
  CHECK(mesh.vertex(further) == waist);
  CHECK(mesh.valence(FanId(waist.value)) == 3);
  CHECK(mesh.valence(further) == 3);
}

TEST_CASE("an unused vertex has a fan without faces") {
  const Mesh mesh = build(shapes::unused_vertices());
  CHECK_FALSE(mesh.halfedge(FanId(0)).valid());
  CHECK(mesh.valence(FanId(0)) == 0);
  CHECK_FALSE(mesh.is_boundary(FanId(0)));
  CHECK(outgoing(mesh, FanId(0)).empty());
}

TEST_CASE("the arithmetic of an all-quad mesh agrees with the general path") {
  for (const NamedSoup& named : well_formed_zoo()) {
    CAPTURE(named.name);
    const Mesh quick = build(named.soup);
    const Mesh general = build(shapes::disjoint_union({named.soup, soup_of(3, {{0, 1, 2}})}));
    REQUIRE(quick.all_quads());
    REQUIRE_FALSE(general.all_quads());
    for (std::uint32_t number = 0; number < quick.halfedge_count(); ++number) {
      const HalfedgeId h(number);
      CHECK(quick.next(h) == general.next(h));
      CHECK(quick.prev(h) == general.prev(h));
      CHECK(quick.face(h) == general.face(h));
      CHECK(quick.corner(h) == general.corner(h));
      CHECK(quick.twin(h) == general.twin(h));
      CHECK(quick.origin(h) == general.origin(h));
      CHECK(quick.fan(h) == general.fan(h));
    }
    for (std::uint32_t f = 0; f < quick.face_count(); ++f) CHECK(quick.first(FaceId(f)) == general.first(FaceId(f)));
    for (std::uint32_t p = 0; p < quick.fan_count(); ++p) {
      CHECK(quick.halfedge(FanId(p)) == general.halfedge(FanId(p)));
    }
  }
}

TEST_CASE("face starts that say four everywhere are the same mesh as none") {
  PolygonSoup soup = shapes::grid(3, 2);
  for (std::uint32_t start = 0; start <= soup.corners.size(); start += 4) soup.face_starts.push_back(start);
  const Mesh mesh = build(soup);
  CHECK(mesh.all_quads());
  CHECK(mesh.face_count() == 6);
}

TEST_CASE("a mirrored mesh has every face turned over: corner k becomes corner n - 1 - k") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    const Mesh mirror = mesh.mirrored();
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      const std::uint32_t first = mesh.first(FaceId(f)).value;
      const std::uint32_t size = mesh.size(FaceId(f));
      for (std::uint32_t k = 0; k < size; ++k) {
        CHECK(mirror.origin(HalfedgeId(first + k)) == mesh.origin(HalfedgeId(first + size - 1 - k)));
      }
    }
  }
}

TEST_CASE("a mirrored mesh is the mesh of the mirrored soup, but for the numbers of further fans") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    const Mesh mirror = mesh.mirrored();
    PolygonSoup turned = named.soup;
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      const auto first = turned.corners.begin() + mesh.first(FaceId(f)).value;
      std::reverse(first, first + mesh.size(FaceId(f)));
    }
    const Mesh rebuilt = build(turned);
    REQUIRE(mirror.fan_count() == rebuilt.fan_count());
    for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
      const HalfedgeId h(number);
      CHECK(mirror.twin(h) == rebuilt.twin(h));
      CHECK(mirror.vertex(mirror.fan(h)) == rebuilt.vertex(rebuilt.fan(h)));
      std::vector<HalfedgeId> around = outgoing(mirror, mirror.fan(h));
      std::vector<HalfedgeId> expected = outgoing(rebuilt, rebuilt.fan(h));
      if (!mirror.is_boundary(mirror.fan(h))) {
        around = from_least(around);
        expected = from_least(expected);
      }
      CHECK(around == expected);
    }
  }
}

TEST_CASE("a mesh mirrored twice is itself") {
  for (const NamedSoup& named : whole_zoo()) {
    CAPTURE(named.name);
    const Mesh mesh = build(named.soup);
    const Mesh twice = mesh.mirrored().mirrored();
    for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
      const HalfedgeId h(number);
      CHECK(twice.origin(h) == mesh.origin(h));
      CHECK(twice.twin(h) == mesh.twin(h));
      CHECK(twice.fan(h) == mesh.fan(h));
    }
    for (std::uint32_t p = 0; p < mesh.fan_count(); ++p) {
      if (!mesh.is_boundary(FanId(p)) && mesh.halfedge(FanId(p)).valid()) {
        CHECK(from_least(outgoing(twice, FanId(p))) == from_least(outgoing(mesh, FanId(p))));
      } else {
        CHECK(outgoing(twice, FanId(p)) == outgoing(mesh, FanId(p)));
      }
    }
  }
}

TEST_CASE("a face that names a vertex there is not is refused by its number") {
  const Expected<Mesh> mesh = Mesh::build(soup_of(4, {{0, 1, 2, 3}, {0, 1, 4}}));
  REQUIRE_FALSE(mesh.has_value());
  CHECK(mesh.error().code == ErrorCode::BadIndex);
  CHECK(mesh.error().message.find("f1 names vertex v4") != std::string::npos);
}

TEST_CASE("a face of two corners is refused by its number") {
  const Expected<Mesh> mesh = Mesh::build(soup_of(4, {{0, 1, 2, 3}, {0, 1}}));
  REQUIRE_FALSE(mesh.has_value());
  CHECK(mesh.error().code == ErrorCode::TooFewCorners);
  CHECK(mesh.error().message.find("f1") != std::string::npos);
}

TEST_CASE("face starts that do not divide the corners are refused") {
  for (const std::vector<std::uint32_t>& starts : {std::vector<std::uint32_t>{0, 3}, {1, 4}, {0, 5}, {0, 5, 4}}) {
    PolygonSoup soup{.vertex_count = 4, .face_starts = starts};
    for (std::uint32_t v = 0; v < 4; ++v) soup.corners.push_back(VertexId(v));
    CHECK_FALSE(Mesh::build(soup).has_value());
  }
}
