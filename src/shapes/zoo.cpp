#include <quadmatch/shapes/zoo.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "geometry.hpp"
#include "lattice.hpp"
#include "soup_builder.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

Point lattice_point(const Lattice::Index& index) {
  return {static_cast<double>(index[0]), static_cast<double>(index[1]), static_cast<double>(index[2])};
}

/// Faces between `rows` + 1 rings of `around` vertices each, the last ring being the first when closed.
void add_rings(SoupBuilder& builder, std::uint32_t around, std::uint32_t rows, bool closed) {
  const std::uint32_t rings = closed ? rows : rows + 1;
  const auto vertex = [&](std::uint32_t i, std::uint32_t j) { return VertexId((j % rings) * around + i % around); };
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < around; ++i) {
      builder.quad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
    }
  }
}

/// A side of a cube of k quads an edge: the lattice point of its lower left corner, and the steps right and up.
struct Side {
  Lattice::Index origin, right, up;
};

std::array<Side, 6> cube_sides(int k) {
  return {{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
           {{0, 0, k}, {1, 0, 0}, {0, 1, 0}},
           {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
           {{k, 0, 0}, {0, 1, 0}, {0, 0, 1}},
           {{k, k, 0}, {-1, 0, 0}, {0, 0, 1}},
           {{0, k, 0}, {0, -1, 0}, {0, 0, 1}}}};
}

template <class Position>
PolygonSoup cube_of(std::uint32_t k, Position position) {
  assert(k >= 1);
  SoupBuilder builder;
  Lattice lattice;
  const int count = static_cast<int>(k);
  for (const Side& side : cube_sides(count)) {
    const auto vertex = [&](int i, int j) {
      Lattice::Index index = side.origin;
      for (std::size_t axis = 0; axis < 3; ++axis) index[axis] += i * side.right[axis] + j * side.up[axis];
      return lattice.at(builder, index, position);
    };
    for (int j = 0; j < count; ++j) {
      for (int i = 0; i < count; ++i) {
        const VertexId a = vertex(i, j), b = vertex(i + 1, j), c = vertex(i + 1, j + 1), d = vertex(i, j + 1);
        builder.quad(a, b, c, d);
      }
    }
  }
  return builder.take();
}

/// The ribs of a dog toy: `tubes` of them, `rings` long, between the poles of the unit sphere.
class Ribs {
 public:
  Ribs(std::uint32_t tubes, std::uint32_t rings) : tubes_(tubes), rings_(rings) {}

  PolygonSoup build() {
    add_poles();
    add_rings_of_tubes();
    for (std::uint32_t tube = 0; tube < tubes_; ++tube) {
      for (std::uint32_t ring = 0; ring < rings_; ++ring) {
        for (std::uint32_t side = 0; side < 4; ++side) {
          builder_.quad(vertex(tube, ring, side), vertex(tube, ring + 1, side), vertex(tube, ring + 1, side + 1),
                        vertex(tube, ring, side + 1));
        }
      }
    }
    return builder_.take();
  }

 private:
  static constexpr double kThickness = 0.12;

  /// The sides of a tube are top (outside), right, bottom and left; the clefts between tubes belong to the tube on
  /// their left.
  void add_poles() {
    for (const double z : {1.0, -1.0}) {
      builder_.vertex(0, 0, z * (1 + kThickness));
      builder_.vertex(0, 0, z * (1 - 2 * kThickness));
      for (std::uint32_t tube = 0; tube < tubes_; ++tube) {
        const Heading cleft = heading((tube + 0.5) / tubes_);
        builder_.vertex(0.3 * cleft.cos, 0.3 * cleft.sin, z * 0.95);
      }
    }
  }

  void add_rings_of_tubes() {
    for (std::uint32_t tube = 0; tube < tubes_; ++tube) {
      for (std::uint32_t ring = 1; ring < rings_; ++ring) {
        // Rings stand densest where tubes part, and reach the poles at neither end.
        const Heading latitude = heading(0.5 * (ring + 0.5) / (rings_ + 1));
        const double half_width = 0.3 / tubes_ * (0.4 + 0.6 * latitude.sin);
        for (std::uint32_t side = 0; side < 4; ++side) {
          const double radius = side == 0 ? 1 + kThickness : side == 2 ? 1 - kThickness : 1.0;
          const Heading longitude = heading(1.0 * tube / tubes_ + (side == 1   ? half_width
                                                                   : side == 3 ? -half_width
                                                                               : 0.0));
          builder_.vertex(radius * latitude.sin * longitude.cos, radius * latitude.sin * longitude.sin,
                          radius * latitude.cos);
        }
      }
    }
  }

  VertexId vertex(std::uint32_t tube, std::uint32_t ring, std::uint32_t side) const {
    side %= 4;
    if (ring > 0 && ring < rings_) {
      return VertexId(2 * (tubes_ + 2) + (tube * (rings_ - 1) + ring - 1) * 4 + side);
    }
    const std::uint32_t pole = ring == 0 ? 0 : tubes_ + 2;
    if (side == 0) return VertexId(pole);
    if (side == 2) return VertexId(pole + 1);
    return VertexId(pole + 2 + (side == 1 ? tube : (tube + tubes_ - 1) % tubes_));
  }

  std::uint32_t tubes_, rings_;
  SoupBuilder builder_;
};

}  // namespace

PolygonSoup grid(std::uint32_t m, std::uint32_t n) {
  assert(m >= 1 && n >= 1);
  SoupBuilder builder;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i <= m; ++i) builder.vertex(i, j, 0);
  }
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t i = 0; i < m; ++i) {
      const std::uint32_t corner = j * (m + 1) + i;
      builder.face_of({corner, corner + 1, corner + m + 2, corner + m + 1});
    }
  }
  return builder.take();
}

PolygonSoup cylinder(std::uint32_t m, std::uint32_t n) {
  assert(m >= 3 && n >= 1);
  SoupBuilder builder;
  for (std::uint32_t j = 0; j <= n; ++j) {
    for (std::uint32_t i = 0; i < m; ++i) {
      const Heading around = heading(1.0 * i / m);
      builder.vertex(around.cos, around.sin, 1.0 * j / n);
    }
  }
  add_rings(builder, m, n, false);
  return builder.take();
}

PolygonSoup star(std::uint32_t n, std::uint32_t k) {
  assert(n >= 3 && k >= 1);
  SoupBuilder builder;
  builder.vertex(0, 0, 0);
  // Petal s owns the points (i, j), 1 <= i <= k, 0 <= j <= k of its grid; j runs towards the next petal, whose first
  // row i closes it.
  for (std::uint32_t s = 0; s < n; ++s) {
    const Heading right = heading(1.0 * s / n), up = heading((s + 1.0) / n);
    for (std::uint32_t i = 1; i <= k; ++i) {
      for (std::uint32_t j = 0; j <= k; ++j) {
        builder.vertex(i * right.cos + j * up.cos, i * right.sin + j * up.sin, 0);
      }
    }
  }
  const auto vertex = [&](std::uint32_t s, std::uint32_t i, std::uint32_t j) {
    if (i == 0 && j == 0) return VertexId(0);
    if (i == 0) return VertexId(1 + ((s + 1) % n) * k * (k + 1) + (j - 1) * (k + 1));
    return VertexId(1 + s * k * (k + 1) + (i - 1) * (k + 1) + j);
  };
  for (std::uint32_t s = 0; s < n; ++s) {
    for (std::uint32_t j = 0; j < k; ++j) {
      for (std::uint32_t i = 0; i < k; ++i) {
        builder.quad(vertex(s, i, j), vertex(s, i + 1, j), vertex(s, i + 1, j + 1), vertex(s, i, j + 1));
      }
    }
  }
  return builder.take();
}

PolygonSoup torus(std::uint32_t m, std::uint32_t n) {
  assert(m >= 3 && n >= 3);
  SoupBuilder builder;
  for (std::uint32_t j = 0; j < n; ++j) {
    const Heading along = heading(1.0 * j / n);
    for (std::uint32_t i = 0; i < m; ++i) {
      const Heading around = heading(1.0 * i / m);
      const double radius = 2 + around.cos;
      builder.vertex(radius * along.cos, -radius * along.sin, around.sin);
    }
  }
  add_rings(builder, m, n, true);
  return builder.take();
}

PolygonSoup cube() { return cube_subdivided(1); }

PolygonSoup cube_subdivided(std::uint32_t k) { return cube_of(k, lattice_point); }

PolygonSoup sphere(std::uint32_t k) {
  return cube_of(k, [k](const Lattice::Index& index) {
    return normalized(2.0 * lattice_point(index) - Point{1.0 * k, 1.0 * k, 1.0 * k});
  });
}

PolygonSoup prism(std::uint32_t n) {
  assert(n >= 3);
  SoupBuilder builder;
  for (const double z : {0.0, 1.0}) {
    for (std::uint32_t i = 0; i < n; ++i) {
      const Heading around = heading(1.0 * i / n);
      builder.vertex(around.cos, around.sin, z);
    }
  }
  std::vector<VertexId> bottom, top;
  for (std::uint32_t i = 0; i < n; ++i) {
    bottom.push_back(VertexId(n - 1 - i));
    top.push_back(VertexId(n + i));
  }
  builder.face(bottom);
  builder.face(top);
  add_rings(builder, n, 1, false);
  return builder.take();
}

PolygonSoup grating(std::uint32_t m, std::uint32_t n) {
  assert(m >= 1 && n >= 1);
  const int width = 2 * static_cast<int>(m) + 1, height = 2 * static_cast<int>(n) + 1;
  const auto solid = [&](int i, int j) {
    return i >= 0 && j >= 0 && i < width && j < height && (i % 2 == 0 || j % 2 == 0);
  };
  SoupBuilder builder;
  Lattice lattice;
  const auto wall = [&](int i, int j, int to_i, int to_j) {
    builder.quad(lattice.at(builder, {i, j, 0}, lattice_point), lattice.at(builder, {to_i, to_j, 0}, lattice_point),
                 lattice.at(builder, {to_i, to_j, 1}, lattice_point), lattice.at(builder, {i, j, 1}, lattice_point));
  };
  const auto plate = [&](int i, int j, int z, int right, int up) {
    builder.quad(lattice.at(builder, {i, j, z}, lattice_point),
                 lattice.at(builder, {i + right, j + up, z}, lattice_point),
                 lattice.at(builder, {i + 1, j + 1, z}, lattice_point),
                 lattice.at(builder, {i + up, j + right, z}, lattice_point));
  };
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      if (!solid(i, j)) continue;
      plate(i, j, 0, 0, 1);
      plate(i, j, 1, 1, 0);
      if (!solid(i, j - 1)) wall(i, j, i + 1, j);
      if (!solid(i + 1, j)) wall(i + 1, j, i + 1, j + 1);
      if (!solid(i, j + 1)) wall(i + 1, j + 1, i, j + 1);
      if (!solid(i - 1, j)) wall(i, j + 1, i, j);
    }
  }
  return builder.take();
}

PolygonSoup dog_toy(std::uint32_t genus, std::uint32_t rings) {
  assert(genus >= 1 && rings >= 2);
  return Ribs(genus + 1, rings).build();
}

PolygonSoup disjoint_union(const std::vector<PolygonSoup>& soups) {
  SoupBuilder builder;
  std::uint32_t first = 0;
  bool positions = true;
  for (const PolygonSoup& soup : soups) {
    positions = positions && soup.positions.size() == soup.vertex_count;
    for (std::uint32_t v = 0; v < soup.vertex_count; ++v) {
      builder.vertex(soup.positions.empty() ? Point{} : soup.positions[v]);
    }
    for (std::uint32_t f = 0, count = face_count(soup); f < count; ++f) {
      std::vector<VertexId> corners;
      for (const VertexId v : corners_of(soup, f)) corners.push_back(VertexId(first + v.value));
      builder.face(corners);
    }
    first += soup.vertex_count;
  }
  PolygonSoup all = builder.take();
  if (!positions) all.positions.clear();
  return all;
}

PolygonSoup many_components(std::uint32_t n) {
  assert(n >= 1);
  std::vector<PolygonSoup> cubes(n, cube());
  for (std::uint32_t i = 0; i < n; ++i) {
    for (Point& point : cubes[i].positions) point[0] += 2.0 * i;
  }
  return disjoint_union(cubes);
}

}  // namespace quadmatch::shapes
