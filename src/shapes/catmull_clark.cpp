// Catmull and Clark, "Recursively generated B-spline surfaces on arbitrary topological meshes", 1978.

#include <quadmatch/shapes/catmull_clark.hpp>

#include <utility>

#include "edge_table.hpp"
#include "geometry.hpp"
#include "soup_faces.hpp"

namespace quadmatch::shapes {
namespace {

/// What the rule of an old vertex needs to know of its surroundings.
struct Star {
  Point face_points = {};
  Point crease_ends = {};  // the other ends of its edges that are not between two faces
  Point ends = {};         // the other ends of all its edges
  std::uint32_t faces = 0, creases = 0, edges = 0;
};

bool is_crease(const UndirectedEdge& edge) { return edge.uses != 2; }

std::vector<Point> find_face_points(const PolygonSoup& soup) {
  std::vector<Point> points(face_count(soup));
  for (std::uint32_t f = 0; f < points.size(); ++f) {
    Point sum = {};
    const auto corners = corners_of(soup, f);
    for (const VertexId v : corners) sum = sum + soup.positions[v.value];
    points[f] = (1.0 / static_cast<double>(corners.size())) * sum;
  }
  return points;
}

/// The sum of the points of an edge's faces, for each edge.
std::vector<Point> sum_face_points(const PolygonSoup& soup, const EdgeTable& table,
                                   const std::vector<Point>& face_points) {
  std::vector<Point> sums(table.edges.size());
  for (std::uint32_t f = 0; f < face_points.size(); ++f) {
    for (std::uint32_t c = first_corner(soup, f); c < first_corner(soup, f + 1); ++c) {
      Point& sum = sums[table.of_corner[c]];
      sum = sum + face_points[f];
    }
  }
  return sums;
}

std::vector<Point> find_edge_points(const PolygonSoup& soup, const EdgeTable& table,
                                    const std::vector<Point>& face_points) {
  std::vector<Point> points = sum_face_points(soup, table, face_points);
  for (std::size_t e = 0; e < points.size(); ++e) {
    const UndirectedEdge& edge = table.edges[e];
    const Point ends = soup.positions[edge.lower.value] + soup.positions[edge.upper.value];
    points[e] = is_crease(edge) ? 0.5 * ends : 0.25 * (ends + points[e]);
  }
  return points;
}

std::vector<Star> gather_stars(const PolygonSoup& soup, const EdgeTable& table, const std::vector<Point>& face_points) {
  std::vector<Star> stars(soup.vertex_count);
  for (std::uint32_t f = 0; f < face_points.size(); ++f) {
    for (const VertexId v : corners_of(soup, f)) {
      Star& star = stars[v.value];
      star.face_points = star.face_points + face_points[f];
      ++star.faces;
    }
  }
  for (const UndirectedEdge& edge : table.edges) {
    for (const auto& [here, there] : {std::pair(edge.lower, edge.upper), std::pair(edge.upper, edge.lower)}) {
      Star& star = stars[here.value];
      const Point& end = soup.positions[there.value];
      star.ends = star.ends + end;
      ++star.edges;
      if (!is_crease(edge)) continue;
      star.crease_ends = star.crease_ends + end;
      ++star.creases;
    }
  }
  return stars;
}

Point moved_vertex(const Point& here, const Star& star) {
  if (star.creases == 2) return 0.75 * here + 0.125 * star.crease_ends;
  if (star.creases > 0 || star.edges == 0) return here;
  // (Q + 2 R + (n - 3) S) / n, with Q the mean of the face points, R that of the edges' midpoints, S the vertex.
  const double n = star.edges;
  const Point faces = (1.0 / star.faces) * star.face_points;
  const Point midpoints = 0.5 * (here + (1.0 / n) * star.ends);
  return (1.0 / n) * (faces + 2.0 * midpoints + (n - 3.0) * here);
}

std::vector<Point> refine_positions(const PolygonSoup& soup, const EdgeTable& table) {
  const std::vector<Point> face_points = find_face_points(soup);
  const std::vector<Point> edge_points = find_edge_points(soup, table, face_points);
  const std::vector<Star> stars = gather_stars(soup, table, face_points);
  std::vector<Point> points;
  points.reserve(stars.size() + edge_points.size() + face_points.size());
  for (std::uint32_t v = 0; v < soup.vertex_count; ++v) points.push_back(moved_vertex(soup.positions[v], stars[v]));
  points.insert(points.end(), edge_points.begin(), edge_points.end());
  points.insert(points.end(), face_points.begin(), face_points.end());
  return points;
}

}  // namespace

PolygonSoup catmull_clark(const PolygonSoup& soup) {
  const EdgeTable table = build_edge_table(soup);
  const std::uint32_t faces = face_count(soup);
  const std::uint32_t first_edge_point = soup.vertex_count;
  const std::uint32_t first_face_point = first_edge_point + static_cast<std::uint32_t>(table.edges.size());

  PolygonSoup refined;
  refined.vertex_count = first_face_point + faces;
  refined.corners.reserve(4 * soup.corners.size());
  for (std::uint32_t f = 0; f < faces; ++f) {
    const std::uint32_t begin = first_corner(soup, f), end = first_corner(soup, f + 1);
    std::uint32_t side_before = table.of_corner[end - 1];
    for (std::uint32_t c = begin; c < end; ++c) {
      const std::uint32_t side = table.of_corner[c];
      refined.corners.insert(refined.corners.end(),
                             {soup.corners[c], VertexId(first_edge_point + side), VertexId(first_face_point + f),
                              VertexId(first_edge_point + side_before)});
      side_before = side;
    }
  }
  if (!soup.positions.empty()) refined.positions = refine_positions(soup, table);
  return refined;
}

PolygonSoup catmull_clark(PolygonSoup soup, unsigned steps) {
  for (unsigned step = 0; step < steps; ++step) soup = catmull_clark(std::as_const(soup));
  return soup;
}

std::vector<TextureCoordinate> refine_coordinates(const PolygonSoup& soup,
                                                  const std::vector<TextureCoordinate>& coordinates) {
  const auto mean = [](const TextureCoordinate& a, const TextureCoordinate& b) {
    return TextureCoordinate{0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])};
  };
  std::vector<TextureCoordinate> refined;
  refined.reserve(4 * coordinates.size());
  for (std::uint32_t f = 0, count = face_count(soup); f < count; ++f) {
    const std::uint32_t begin = first_corner(soup, f), end = first_corner(soup, f + 1);
    TextureCoordinate centre = {};
    for (std::uint32_t c = begin; c < end; ++c) {
      centre[0] += coordinates[c][0] / (end - begin);
      centre[1] += coordinates[c][1] / (end - begin);
    }
    for (std::uint32_t c = begin; c < end; ++c) {
      const TextureCoordinate& after = coordinates[c + 1 < end ? c + 1 : begin];
      const TextureCoordinate& before = coordinates[c > begin ? c - 1 : end - 1];
      refined.insert(refined.end(),
                     {coordinates[c], mean(coordinates[c], after), centre, mean(before, coordinates[c])});
    }
  }
  return refined;
}

}  // namespace quadmatch::shapes
