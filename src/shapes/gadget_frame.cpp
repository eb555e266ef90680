#include "gadget_frame.hpp"

#include <algorithm>

namespace quadmatch::shapes {
namespace {

constexpr double kUnit = 10.0;         // of the grid, so that files with five decimals hold what is drawn
constexpr double kShareOfRoom = 0.42;  // of the way to the nearest edge or vertex: two disks leave room for a chain
constexpr double kLean = 0.4;          // below a half
constexpr double kChainShare = 0.3;    // of the sine between edges

double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }

Vector place(const GridPoint& point) {
  return {kUnit * static_cast<double>(point[0]), kUnit * static_cast<double>(point[1])};
}

double distance_to_segment(Vector point, Vector from, Vector to) {
  const Vector along = to - from;
  const double share = std::clamp(dot(point - from, along) / dot(along, along), 0.0, 1.0);
  return length(point - (from + share * along));
}

/// Counter-clockwise from the positive x axis; exact, since grid points are integers.
bool before(const GridPoint& a, const GridPoint& b) {
  const auto upper = [](const GridPoint& p) { return p[1] > 0 || (p[1] == 0 && p[0] > 0); };
  if (upper(a) != upper(b)) return upper(a);
  return a[0] * b[1] - a[1] * b[0] > 0;
}

std::array<std::uint32_t, 3> turns_about(std::uint32_t v, const CubicGraph& graph,
                                         const std::vector<GridPoint>& points) {
  std::vector<std::pair<GridPoint, std::uint32_t>> around;
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    const auto& [from, to] = graph.edges[e];
    if (from != v && to != v) continue;
    const GridPoint& other = points[from == v ? to : from];
    around.emplace_back(GridPoint{other[0] - points[v][0], other[1] - points[v][1]}, e);
  }
  std::sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return before(a.first, b.first); });
  std::array<std::uint32_t, 3> turns = {around[0].second, around[1].second, around[2].second};
  std::rotate(turns.begin(), std::min_element(turns.begin(), turns.end()), turns.end());
  return turns;
}

/// How far it is to the nearest other vertex, or edge of other vertices.
double room_about(std::uint32_t v, const CubicGraph& graph, const std::vector<GridPoint>& points) {
  double room = 1e300;
  for (const auto& [from, to] : graph.edges) {
    if (from == v || to == v) {
      room = std::min(room, length(place(points[from]) - place(points[to])));
    } else {
      room = std::min(room, distance_to_segment(place(points[v]), place(points[from]), place(points[to])));
    }
  }
  return room;
}

/// Turned by as much as a unit vector is from the x axis.
Vector turned(Vector a, Vector by) { return {a.x * by.x - a.y * by.y, a.x * by.y + a.y * by.x}; }

/// The sine of the angle between two directions, 1 where it is a right angle or more.
double opening(Vector a, Vector b) { return dot(a, b) <= 0 ? 1.0 : std::abs(cross(a, b)); }

/// Chains leave the gadget about a third of a turn apart, turned as a whole to where the edges lead (the mean of the
/// edges' directions once each is turned back by its share), and lean towards their edges, but never so that half a
/// turn is left free.
void set_leaving(std::array<Port, 3>& ports) {
  const Vector thirds[3] = {{1, 0}, {-0.5, 0.8660254037844386}, {-0.5, -0.8660254037844386}};
  Vector sum;
  for (std::size_t k = 0; k < 3; ++k) sum = sum + turned(ports[k].edge, thirds[(3 - k) % 3]);
  for (std::size_t k = 0; k < 3; ++k) {
    ports[k].leaving = unit(turned(unit(sum), thirds[k]) + kLean * ports[k].edge);
  }
}

void set_widths(std::array<Port, 3>& ports, double radius) {
  for (std::size_t k = 0; k < 3; ++k) {
    const double narrowest =
        std::min(opening(ports[k].edge, ports[(k + 1) % 3].edge), opening(ports[k].edge, ports[(k + 2) % 3].edge));
    ports[k].chain_half_width = std::min(0.15, kChainShare * narrowest) * radius;
  }
}

}  // namespace

std::vector<Frame> frames_of(const CubicGraph& graph, const std::vector<GridPoint>& points) {
  std::vector<Frame> frames(graph.vertex_count);
  for (std::uint32_t v = 0; v < graph.vertex_count; ++v) {
    Frame& frame = frames[v];
    frame.centre = place(points[v]);
    frame.radius = kShareOfRoom * room_about(v, graph, points);
    frame.turns = turns_about(v, graph, points);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& [from, to] = graph.edges[frame.turns[k]];
      frame.ports[k].edge = unit(place(points[from == v ? to : from]) - frame.centre);
    }
    set_leaving(frame.ports);
    set_widths(frame.ports, frame.radius);
  }
  return frames;
}

}  // namespace quadmatch::shapes
