#include <quadmatch/shapes/dirty_zoo.hpp>

#include <quadmatch/shapes/zoo.hpp>

#include <cassert>

#include "geometry.hpp"
#include "soup_builder.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

/// Six vertices in two rows of three, as two quads side by side use them.
SoupBuilder two_by_three() {
  SoupBuilder builder;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0, 2.0}) builder.vertex(x, y, 0);
  }
  return builder;
}

}  // namespace

PolygonSoup mobius_strip(std::uint32_t n) {
  assert(n >= 3);
  SoupBuilder builder;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Heading along = heading(1.0 * i / n), across = heading(0.5 * i / n);
    for (const double side : {-0.5, 0.5}) {
      const double radius = 2 + side * across.cos;
      builder.vertex(radius * along.cos, radius * along.sin, side * across.sin);
    }
  }
  for (std::uint32_t i = 0; i + 1 < n; ++i) builder.face_of({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  builder.face_of({2 * n - 2, 1, 0, 2 * n - 1});
  return builder.take();
}

PolygonSoup klein_bottle(std::uint32_t m, std::uint32_t n) {
  assert(m >= 3 && n >= 3);
  SoupBuilder builder;
  // The figure-eight immersion: its section turns half round on the way along.
  for (std::uint32_t j = 0; j < n; ++j) {
    const Heading along = heading(1.0 * j / n), half = heading(0.5 * j / n);
    for (std::uint32_t i = 0; i < m; ++i) {
      const Heading once = heading(1.0 * i / m), twice = heading(2.0 * i / m);
      const double radius = 2 + half.cos * once.sin - half.sin * twice.sin;
      builder.vertex(radius * along.cos, radius * along.sin, half.sin * once.sin + half.cos * twice.sin);
    }
  }
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) {
    return VertexId(j < n ? j * m + i % m : (m - i % m) % m);
  };
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < m; ++i) {
      builder.quad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
  return builder.take();
}

PolygonSoup book() {
  SoupBuilder builder;
  builder.vertex(0, 0, 0);
  builder.vertex(0, 0, 1);
  for (std::uint32_t page = 0; page < 3; ++page) {
    const Heading out = heading(page / 3.0);
    builder.vertex(out.cos, out.sin, 0);
    builder.vertex(out.cos, out.sin, 1);
    builder.face_of({0, 2 * page + 2, 2 * page + 3, 1});
  }
  return builder.take();
}

PolygonSoup observation_2_2(std::uint32_t tubes) {
  assert(tubes >= 2);
  enum : std::uint32_t { NorthTop, NorthBottom, SouthTop, SouthBottom };
  SoupBuilder builder;
  for (const double y : {1.0, -1.0}) {
    for (const double z : {0.1, -0.1}) builder.vertex(0, y, z);
  }
  for (std::uint32_t tube = 0; tube < tubes; ++tube) {
    builder.face_of({NorthTop, SouthTop, SouthBottom, NorthBottom});
    builder.face_of({NorthTop, NorthBottom, SouthBottom, SouthTop});
  }
  return builder.take();
}

PolygonSoup hourglass() {
  PolygonSoup above = cube(), below = cube();
  for (Point& point : below.positions) point = point - Point{1, 1, 1};
  PolygonSoup both = disjoint_union({above, below});
  // The lower cube's vertex at the origin is written as the upper cube's, and the gap in the numbers closed.
  const auto at_origin = [](const PolygonSoup& soup) {
    std::uint32_t v = 0;
    while (soup.positions[v] != Point{}) ++v;
    return v;
  };
  const VertexId waist(at_origin(above)), twin(above.vertex_count + at_origin(below));
  for (VertexId& v : both.corners) {
    if (v == twin) {
      v = waist;
    } else if (v > twin) {
      --v.value;
    }
  }
  both.positions.erase(both.positions.begin() + twin.value);
  --both.vertex_count;
  return both;
}

PolygonSoup bow_tie() {
  SoupBuilder builder;
  builder.vertex(0, 0, 0);
  for (const double side : {1.0, -1.0}) {
    builder.vertex(side, -side, 0);
    builder.vertex(2 * side, 0, 0);
    builder.vertex(side, side, 0);
  }
  builder.face_of({0, 1, 2, 3});
  builder.face_of({0, 4, 5, 6});
  return builder.take();
}

PolygonSoup wrongly_wound() {
  SoupBuilder builder = two_by_three();
  builder.face_of({0, 1, 4, 3});
  builder.face_of({1, 4, 5, 2});
  return builder.take();
}

PolygonSoup self_glued_face() {
  SoupBuilder builder;
  for (const double half : {3.0, 1.0}) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const Heading to = heading(0.25 * i);
      builder.vertex(half * (to.cos - to.sin), half * (to.cos + to.sin), 0);
    }
  }
  builder.face_of({0, 1, 2, 3, 0, 4, 7, 6, 5, 4});
  builder.face_of({4, 5, 6, 7});
  return builder.take();
}

PolygonSoup degenerate_face() {
  SoupBuilder builder;
  for (const double y : {0.0, 1.0}) {
    for (const double x : {0.0, 1.0, 2.0, 3.0}) {
      if (x != 2.0 || y != 1.0) builder.vertex(x, y, 0);
    }
  }
  builder.face_of({0, 1, 5, 4});
  builder.face_of({1, 2, 5, 5});
  builder.face_of({2, 3, 6, 5});
  return builder.take();
}

PolygonSoup duplicate_faces() {
  PolygonSoup soup = cube();
  const std::vector<VertexId> last(soup.corners.end() - 4, soup.corners.end());
  soup.corners.insert(soup.corners.end(), last.begin(), last.end());
  return soup;
}

PolygonSoup overlapping_faces() {
  SoupBuilder builder;
  builder.vertex(0, 0, 0);
  builder.vertex(1, 0, 0);
  builder.vertex(1, 1, 0);
  builder.vertex(0, 1, 0);
  builder.vertex(2, -1, 0);
  builder.face_of({0, 1, 2, 3});
  builder.face_of({2, 1, 0, 4});
  return builder.take();
}

PolygonSoup unused_vertices() {
  SoupBuilder builder;
  for (std::uint32_t v = 0; v < 10; ++v) {
    const Heading around = heading(v / 10.0);
    builder.vertex(around.cos, around.sin, 0);
  }
  builder.face_of({1, 3, 5, 7});
  return builder.take();
}

}  // namespace quadmatch::shapes
