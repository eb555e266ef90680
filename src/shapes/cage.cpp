#include "cage.hpp"

#include <algorithm>
#include <cassert>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace quadmatch::shapes {

Cage::Vertex Cage::add_vertex(const Point& position) {
  points_.push_back(position);
  return static_cast<Vertex>(points_.size() - 1);
}

Cage::Chart Cage::add_chart() {
  charts_.emplace_back();
  return static_cast<Chart>(charts_.size() - 1);
}

Cage::Face Cage::add_face(Part part, Chart chart, std::uint32_t column, std::uint32_t row,
                          const std::array<Vertex, 4>& corners) {
  faces_.push_back({corners, part, chart, column, row});
  ChartSize& size = charts_[chart];
  size.columns = std::max(size.columns, column + 1);
  size.rows = std::max(size.rows, row + 1);
  return static_cast<Face>(faces_.size() - 1);
}

std::vector<std::array<Cage::Vertex, 2>> Cage::rim_of(std::span<const Face> faces) const {
  std::set<std::pair<Vertex, Vertex>> sides;
  for (const Face f : faces) {
    for (std::size_t k = 0; k < 4; ++k) sides.insert({faces_[f].corners[k], faces_[f].corners[(k + 1) % 4]});
  }
  std::map<Vertex, Vertex> onward;
  for (const auto& [from, to] : sides) {
    if (sides.count({to, from}) == 0) onward[from] = to;
  }
  const CageFace& lowest = faces_[*std::min_element(faces.begin(), faces.end())];
  std::size_t k = 0;
  while (onward.count(lowest.corners[k]) == 0 || onward[lowest.corners[k]] != lowest.corners[(k + 1) % 4]) ++k;
  std::vector<std::array<Vertex, 2>> rim;
  const Vertex start = lowest.corners[k];
  Vertex here = start;
  do {
    rim.push_back({here, onward[here]});
    here = onward[here];
  } while (here != start);
  return rim;
}

std::vector<Cage::Face> Cage::extrude(std::span<const Face> faces, Part part, Chart chart, const Motion& motion) {
  const auto rim = rim_of(faces);
  std::map<Vertex, Vertex> lifted;
  for (const auto& side : rim) lifted[side[0]] = add_vertex(points_[side[0]]);
  std::set<Vertex> moving;
  for (const Face f : faces) {
    for (Vertex& v : faces_[f].corners) {
      if (const auto copy = lifted.find(v); copy != lifted.end()) v = copy->second;
      moving.insert(v);
    }
  }
  for (const Vertex v : moving) points_[v] = motion(points_[v]);

  std::vector<Face> ring;
  const std::uint32_t row = charts_[chart].rows;
  for (const auto& [from, to] : rim) {
    const auto column = static_cast<std::uint32_t>(ring.size());
    ring.push_back(add_face(part, chart, column, row, {from, to, lifted[to], lifted[from]}));
  }
  return ring;
}

Point Cage::centre(std::span<const Face> faces) const {
  Point sum = {};
  for (const Face f : faces) {
    for (const Vertex v : faces_[f].corners) sum = sum + points_[v];
  }
  return (0.25 / static_cast<double>(faces.size())) * sum;
}

Cage::Face Cage::farthest(std::span<const Face> faces, const Point& direction) const {
  return *std::max_element(faces.begin(), faces.end(), [&](Face a, Face b) {
    return dot(centre(std::span(&a, 1)), direction) < dot(centre(std::span(&b, 1)), direction);
  });
}

void Cage::move_parts(std::span<const Part> parts, const Motion& motion) {
  std::vector<bool> moves(points_.size(), true);
  for (const CageFace& face : faces_) {
    if (std::find(parts.begin(), parts.end(), face.part) != parts.end()) continue;
    for (const Vertex v : face.corners) moves[v] = false;
  }
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (moves[v]) points_[v] = motion(points_[v]);
  }
}

void Cage::move_all(const Motion& motion) {
  for (Point& point : points_) point = motion(point);
}

/// Charts on shelves, from the lower left, a quarter unit apart; the lower left corner of each, in units.
std::vector<TextureCoordinate> Cage::place_charts() const {
  constexpr double kShelf = 24.0, kGap = 0.25;
  std::vector<TextureCoordinate> corners;
  double x = kGap, y = kGap, height = 0;
  for (const ChartSize& chart : charts_) {
    if (x + chart.columns > kShelf) {
      x = kGap;
      y += height + kGap;
      height = 0;
    }
    corners.push_back({x, y});
    x += chart.columns + kGap;
    height = std::max(height, 1.0 * chart.rows);
  }
  return corners;
}

Model Cage::finish(const std::vector<PartName>& names, unsigned steps, double unit) const {
  std::vector<Face> order(faces_.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto place = [&](Face f) { return std::pair(faces_[f].part, f); };
  std::sort(order.begin(), order.end(), [&](Face a, Face b) { return place(a) < place(b); });

  const std::vector<TextureCoordinate> lower_left = place_charts();
  Model model;
  model.soup.vertex_count = static_cast<std::uint32_t>(points_.size());
  model.soup.positions = points_;
  for (std::uint32_t f = 0; f < order.size(); ++f) {
    const CageFace& face = faces_[order[f]];
    const PartName& name = names[face.part];
    if (model.parts.empty() || model.parts.back().name != name.name) {
      model.parts.push_back({name.name, name.material, f << (2 * steps)});
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const double right = k == 1 || k == 2 ? 1 : 0, up = k >= 2 ? 1 : 0;
      model.soup.corners.push_back(VertexId(face.corners[k]));
      model.coordinates.push_back({unit * (lower_left[face.chart][0] + face.column + right),
                                   unit * (lower_left[face.chart][1] + face.row + up)});
    }
  }
  for (unsigned step = 0; step < steps; ++step) {
    model.coordinates = refine_coordinates(model.soup, model.coordinates);
    model.soup = catmull_clark(model.soup);
  }
  return model;
}

Cage::Motion scale_and_move(const Point& centre, const Point& factors, const Point& by) {
  return [=](const Point& point) {
    const Point offset = point - centre;
    return centre + by + Point{factors[0] * offset[0], factors[1] * offset[1], factors[2] * offset[2]};
  };
}

Point turned(const Point& point, const Point& about, const Point& axis, double turns) {
  const Heading angle = heading(turns);  // Rodrigues' formula
  const Point offset = point - about;
  return about + angle.cos * offset + angle.sin * cross(axis, offset) + ((1 - angle.cos) * dot(axis, offset)) * axis;
}

}  // namespace quadmatch::shapes
