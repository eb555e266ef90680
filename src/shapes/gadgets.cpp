#include <quadmatch/shapes/gadgets.hpp>

#include <algorithm>

#include <quadmatch/mesh/mesh.hpp>

#include "gadget_frame.hpp"
#include "geometry.hpp"
#include "soup_builder.hpp"

namespace quadmatch::shapes {
namespace {

constexpr std::uint32_t kChain = 4;  // quads that an edge becomes
constexpr std::uint32_t kBlock = 8;  // quads of M1 for each vertex and the edge behind it

/// Two vertices across a chain, or where it is joined to a gadget; left and right as seen along the chain.
struct CrossSection {
  VertexId left, right;
};

void add_chain(SoupBuilder& builder, const std::vector<CrossSection>& sections) {
  for (std::size_t k = 0; k + 1 < sections.size(); ++k) {
    builder.quad(sections[k].right, sections[k + 1].right, sections[k + 1].left, sections[k].left);
  }
}

// M1.

/// A place on the strip that runs counter-clockwise around a circle: `along` in turns, `left` of its middle.
Point on_circle(std::uint32_t n, double along, double left) {
  const Heading there = heading(along / n);
  const double radius = 0.25 * n - left;
  return {radius * there.cos, radius * there.sin, 0};
}

/// The hexagon of four quads of a vertex, and where chains come and leave.
struct Hexagon {
  CrossSection comes, leaves;
};

/// The faces a, x, y, b about inner vertices u and w.
Hexagon add_hexagon(SoupBuilder& builder, std::uint32_t n, std::uint32_t j, Gadgets gadgets) {
  const auto vertex = [&](double along, double left) { return builder.vertex(on_circle(n, j + along, left)); };
  constexpr double kWide = 0.25, kHigh = 0.35;
  // Corner by corner around, counter-clockwise; the first two are those of the edge a chain comes to.
  const std::array<VertexId, 6> rim = {vertex(-kWide, 0.2), vertex(-kWide, -0.2), vertex(0, -kHigh),
                                       vertex(kWide, -0.2), vertex(kWide, 0.2),   vertex(0, kHigh)};
  // The six corners of the rim, named by whose corner they are: a and b have three, x and y two.
  const std::size_t turn = gadgets == Gadgets::Corners ? 0 : 2;
  const auto corner = [&](std::size_t k) { return rim[(k + turn) % 6]; };
  // With Gadgets::Adjacency the rim is turned by two, so that chains come to x and leave from y.
  const VertexId a = corner(0), y1 = corner(1), y2 = corner(2), b = corner(3), x2 = corner(4), x1 = corner(5);
  const bool level = gadgets == Gadgets::Corners;
  const VertexId u = level ? vertex(-0.09, 0) : vertex(0, -0.12), w = level ? vertex(0.09, 0) : vertex(0, 0.12);
  builder.quad(u, x1, a, y1);
  builder.quad(u, w, x2, x1);
  builder.quad(w, u, y1, y2);
  builder.quad(w, y2, b, x2);
  return {{rim[0], rim[1]}, {rim[4], rim[3]}};
}

// M2.

/// Where chains are joined to the gadget of a vertex; left and right as seen from the vertex.
using Joints = std::array<CrossSection, 3>;

VertexId add_vertex(SoupBuilder& builder, Vector place) { return builder.vertex(place.x, place.y, 0); }

// Sizes of a gadget in radii of its frame.
constexpr double kHole = 0.1, kSides = 0.22, kJoints = 0.36, kHalfPort = 0.07;

/// The two vertices at which a chain is joined to a port.
CrossSection add_joint(SoupBuilder& builder, const Frame& frame, const Port& port) {
  const Vector middle = frame.centre + kJoints * frame.radius * port.leaving;
  // It looks half way to where the chain goes next.
  const Vector aside = kHalfPort * frame.radius * left_of(unit(port.leaving + port.edge));
  return {add_vertex(builder, middle + aside), add_vertex(builder, middle - aside)};
}

/// Ports and links around a hole. From the chain a port's opposite side is the link before it, clockwise.
Joints add_ring(SoupBuilder& builder, const Frame& frame) {
  Joints joints;
  std::array<VertexId, 3> hole, sides;
  for (std::size_t k = 0; k < 3; ++k) {
    const Port& port = frame.ports[k];
    const Vector aside = 1.6 * kHalfPort * frame.radius * left_of(port.leaving);
    hole[k] = add_vertex(builder, frame.centre + kHole * frame.radius * port.leaving);
    sides[k] = add_vertex(builder, frame.centre + kSides * frame.radius * port.leaving - aside);
    joints[k] = add_joint(builder, frame, port);
  }
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    builder.quad(hole[k], sides[k], joints[k].right, joints[k].left);
    builder.quad(hole[next], hole[k], joints[k].left, sides[next]);
  }
  return joints;
}

/// Three quads about a vertex.
Joints add_triple(SoupBuilder& builder, const Frame& frame) {
  Joints joints;
  const VertexId centre = add_vertex(builder, frame.centre);
  for (std::size_t k = 0; k < 3; ++k) joints[k] = add_joint(builder, frame, frame.ports[k]);
  for (std::size_t k = 0; k < 3; ++k) {
    builder.quad(centre, joints[(k + 2) % 3].left, joints[k].right, joints[k].left);
  }
  return joints;
}

std::size_t place_of(std::uint32_t edge, const std::array<std::uint32_t, 3>& turns) {
  return static_cast<std::size_t>(std::find(turns.begin(), turns.end(), edge) - turns.begin());
}

/// The chain along an edge of the graph: from the first gadget to the line, along it, and off it to the second.
void add_edge(SoupBuilder& builder, const std::array<const Frame*, 2>& ends, const std::array<std::size_t, 2>& at,
              const std::array<CrossSection, 2>& joints) {
  const Port& first = ends[0]->ports[at[0]];
  const Port& second = ends[1]->ports[at[1]];
  const Vector from = ends[0]->centre + ends[0]->radius * first.edge;
  const Vector to = ends[1]->centre + ends[1]->radius * second.edge;
  const double narrow = std::min(first.chain_half_width, second.chain_half_width);
  const double wide = std::max(first.chain_half_width, second.chain_half_width);
  const auto section = [&](Vector middle, double half_width) {
    const Vector aside = half_width * left_of(first.edge);
    return CrossSection{add_vertex(builder, middle + aside), add_vertex(builder, middle - aside)};
  };
  std::vector<CrossSection> sections = {joints[0]};
  sections.push_back(section(from, first.chain_half_width));
  sections.push_back(section(0.5 * (from + to), std::min(wide, 2 * narrow)));
  sections.push_back(section(to, second.chain_half_width));
  sections.push_back({joints[1].right, joints[1].left});
  add_chain(builder, sections);
}

// The match.

/// For each two faces that are adjacent, one of them first: its half-edge on the edge between.
HalfedgeId halfedge_towards(const Mesh& mesh, FaceId face, FaceId neighbour) {
  for (const HalfedgeId h : mesh.halfedges(face)) {
    if (mesh.twin(h).valid() && mesh.face(mesh.twin(h)) == neighbour) return h;
  }
  return {};
}

/// Lay a closed strip on another: each face so that the edge to the one behind it fits.
void rotate_along(const Mesh& source, const Mesh& target, std::vector<FacePair>& pairs) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const FacePair& next = pairs[(k + 1) % pairs.size()];
    const std::uint32_t from = source.corner(halfedge_towards(source, pairs[k].source, next.source));
    const std::uint32_t to = target.corner(halfedge_towards(target, pairs[k].target, next.target));
    pairs[k].rotation = (to + 4 - from) % 4;
  }
}

/// The three pairs of a vertex of the graph, which the cycle enters by one port and leaves by another.
std::array<FacePair, 3> pass(std::uint32_t j, std::uint32_t v, std::size_t enter, std::size_t leave, Gadgets gadgets) {
  enum : std::uint32_t { A, X, Y, B };
  const auto pair = [&](std::uint32_t of_hexagon, std::size_t of_gadget) {
    const std::uint32_t size = gadgets == Gadgets::Corners ? 6 : 3;
    return FacePair{FaceId(kBlock * j + of_hexagon), FaceId(size * v + static_cast<std::uint32_t>(of_gadget))};
  };
  if (gadgets == Gadgets::Adjacency) return {pair(X, enter), pair(Y, leave), pair(A, 3 - enter - leave)};
  // To the next port counter-clockwise: a turn, then straight on, as by y. Else straight on, then a turn, as by x.
  if (leave == (enter + 1) % 3) return {pair(A, 2 * enter), pair(Y, 2 * enter + 1), pair(B, 2 * leave)};
  return {pair(A, 2 * enter), pair(X, 2 * leave + 1), pair(B, 2 * leave)};
}

}  // namespace

PolygonSoup cycle_mesh(std::uint32_t n, Gadgets gadgets) {
  SoupBuilder points;  // hexagons first, since the last chain ends at the first of them
  std::vector<Hexagon> hexagons;
  for (std::uint32_t j = 0; j < n; ++j) hexagons.push_back(add_hexagon(points, n, j, gadgets));
  const PolygonSoup blocks = points.take();

  SoupBuilder builder;
  for (const Point& point : blocks.positions) builder.vertex(point);
  for (std::uint32_t j = 0; j < n; ++j) {
    for (std::uint32_t f = 0; f < 4; ++f) builder.face(std::span(blocks.corners).subspan(16 * j + 4 * f, 4));
    std::vector<CrossSection> sections = {hexagons[j].leaves};
    for (std::uint32_t k = 1; k < kChain; ++k) {
      const double along = j + 0.25 + 0.5 * k / kChain;
      const VertexId left = builder.vertex(on_circle(n, along, 0.2));
      sections.push_back({left, builder.vertex(on_circle(n, along, -0.2))});
    }
    sections.push_back(hexagons[(j + 1) % n].comes);
    add_chain(builder, sections);
  }
  return builder.take();
}

Expected<CubicGraphMesh> cubic_graph_mesh(const CubicGraph& graph, Gadgets gadgets) {
  const Expected<std::vector<GridPoint>> points = planar_drawing(graph);
  if (!points) return Unexpected(points.error());
  const std::vector<Frame> frames = frames_of(graph, *points);
  SoupBuilder builder;
  std::vector<Joints> joints;
  CubicGraphMesh mesh;
  for (const Frame& frame : frames) {
    joints.push_back(gadgets == Gadgets::Corners ? add_ring(builder, frame) : add_triple(builder, frame));
    mesh.turns.push_back(frame.turns);
  }
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    const auto& [from, to] = graph.edges[e];
    const std::array<std::size_t, 2> at = {place_of(e, mesh.turns[from]), place_of(e, mesh.turns[to])};
    add_edge(builder, {&frames[from], &frames[to]}, at, {joints[from][at[0]], joints[to][at[1]]});
  }
  mesh.soup = builder.take();
  return mesh;
}

std::vector<FacePair> match_along(const std::vector<std::uint32_t>& cycle, const CubicGraph& graph,
                                  const CubicGraphMesh& mesh, Gadgets gadgets) {
  const std::uint32_t n = graph.vertex_count;
  const std::uint32_t first_chain = (gadgets == Gadgets::Corners ? 6 : 3) * n;
  const auto edge_between = [&](std::uint32_t v, std::uint32_t w) {
    const auto found = std::find_if(graph.edges.begin(), graph.edges.end(),
                                    [&](const auto& e) { return std::minmax(e[0], e[1]) == std::minmax(v, w); });
    return static_cast<std::uint32_t>(found - graph.edges.begin());
  };
  std::vector<FacePair> pairs;
  for (std::uint32_t j = 0; j < n; ++j) {
    const std::uint32_t v = cycle[j], next = cycle[(j + 1) % n];
    const std::uint32_t comes = edge_between(cycle[(j + n - 1) % n], v), leaves = edge_between(v, next);
    for (const FacePair& pair : pass(j, v, place_of(comes, mesh.turns[v]), place_of(leaves, mesh.turns[v]), gadgets)) {
      pairs.push_back(pair);
    }
    for (std::uint32_t k = 0; k < kChain; ++k) {
      const std::uint32_t along = graph.edges[leaves][0] == v ? k : kChain - 1 - k;
      pairs.push_back({FaceId(kBlock * j + 4 + k), FaceId(first_chain + kChain * leaves + along)});
    }
  }
  if (gadgets == Gadgets::Corners) rotate_along(*Mesh::build(cycle_mesh(n)), *Mesh::build(mesh.soup), pairs);
  return pairs;
}

}  // namespace quadmatch::shapes
