#include "anchor_option.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/analysis/vertex_code.hpp>

namespace quadmatch::cli {
namespace {

Unexpected<Error> refuse(std::string message) { return Unexpected(Error{ErrorCode::BadArgument, std::move(message)}); }

/// One or two numbers with a sign between: "12", "12:3", "5-6".
struct Place {
  char form = '=';  ///< ':' a corner, '-' an edge, '=' a vertex
  std::uint32_t first = 0, second = 0;
};

std::optional<std::uint32_t> number(std::string_view text) {
  std::uint32_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Place> parse_place(std::string_view text) {
  const std::size_t sign = text.find_first_of(":-");
  const std::optional<std::uint32_t> first = number(text.substr(0, sign));
  if (!first) return std::nullopt;
  if (sign == std::string_view::npos) return Place{'=', *first, 0};
  const std::optional<std::uint32_t> second = number(text.substr(sign + 1));
  if (!second) return std::nullopt;
  return Place{text[sign], *first, *second};
}

Expected<HalfedgeId> corner_at(const NamedMesh& in, const Place& place) {
  const Mesh& mesh = in.mesh;
  if (place.first >= mesh.face_count()) {
    return refuse(fmt::format("{} has no face {}; its faces are 0 to {}", in.name, place.first, mesh.face_count() - 1));
  }
  const std::uint32_t size = mesh.size(FaceId(place.first));
  if (place.second >= size) {
    return refuse(fmt::format("face {} of {} has no corner {}; its corners are 0 to {}", place.first, in.name,
                              place.second, size - 1));
  }
  return HalfedgeId(mesh.first(FaceId(place.first)).value + place.second);
}

Expected<void> check_vertex(const NamedMesh& in, std::uint32_t vertex) {
  if (vertex < in.mesh.vertex_count()) return {};
  return refuse(
      fmt::format("{} has no vertex {}; its vertices are 0 to {}", in.name, vertex, in.mesh.vertex_count() - 1));
}

/// The half-edges from one vertex to another: at most one unless the mesh is dirty there.
std::vector<HalfedgeId> halfedges_between(const Mesh& mesh, std::uint32_t from, std::uint32_t to) {
  std::vector<HalfedgeId> found;
  for (std::uint32_t number = 0; number < mesh.halfedge_count(); ++number) {
    const HalfedgeId h(number);
    if (mesh.origin(h) == VertexId(from) && mesh.tip(h) == VertexId(to)) found.push_back(h);
  }
  return found;
}

/// The corners at `from` of the faces that lie left of the edge, or right of it where the mesh is turned over.
std::vector<HalfedgeId> corners_beside(const Mesh& mesh, std::uint32_t from, std::uint32_t to, Orientation seen) {
  if (seen == Orientation::Preserving) return halfedges_between(mesh, from, to);
  std::vector<HalfedgeId> corners = halfedges_between(mesh, to, from);
  for (HalfedgeId& corner : corners) corner = mesh.next(corner);
  return corners;
}

std::vector<UserAnchor> all_pairs(const std::vector<HalfedgeId>& sources, const std::vector<HalfedgeId>& targets) {
  std::vector<UserAnchor> pairs;
  for (const HalfedgeId source : sources) {
    for (const HalfedgeId target : targets) pairs.push_back({source, target});
  }
  return pairs;
}

Expected<void> check_edge(const NamedMesh& in, const Place& place) {
  for (const std::uint32_t end : {place.first, place.second}) {
    if (Expected<void> fine = check_vertex(in, end); !fine) return fine;
  }
  if (halfedges_between(in.mesh, place.first, place.second).empty() &&
      halfedges_between(in.mesh, place.second, place.first).empty()) {
    return refuse(fmt::format("{} has no edge between the vertices {} and {}", in.name, place.first, place.second));
  }
  return {};
}

Expected<std::vector<UserAnchor>> edge_anchors(const NamedMesh& source, const Place& from, const NamedMesh& target,
                                               const Place& to, Orientation orientation) {
  if (Expected<void> fine = check_edge(source, from); !fine) return Unexpected(fine.error());
  if (Expected<void> fine = check_edge(target, to); !fine) return Unexpected(fine.error());
  const auto laid = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    return all_pairs(halfedges_between(source.mesh, a, b), corners_beside(target.mesh, c, d, orientation));
  };
  std::vector<UserAnchor> anchors = laid(from.first, from.second, to.first, to.second);
  if (anchors.empty()) anchors = laid(from.second, from.first, to.second, to.first);
  if (anchors.empty()) {
    return refuse(
        fmt::format("edge {}-{} of {} and edge {}-{} of {} have no face on the same side; turn one of them round",
                    from.first, from.second, source.name, to.first, to.second, target.name));
  }
  return anchors;
}

/// The faces and edges of a fan in order: counter-clockwise, or clockwise where the mesh is turned over.
struct Star {
  std::vector<HalfedgeId> corners;
  std::vector<VertexCode> neighbours;  ///< at the far ends of its edges; one more than corners on the boundary
  bool closed = false;
};

Star star_of(const Mesh& mesh, const PerFan<VertexCode>& codes, FanId fan, Orientation seen) {
  const bool turned = seen == Orientation::Reversing;
  const auto before = [&](HalfedgeId h) { return codes[mesh.fan(mesh.next(h))]; };  // counter-clockwise
  const auto after = [&](HalfedgeId h) { return codes[mesh.fan(mesh.prev(h))]; };
  Star star;
  star.closed = !mesh.is_boundary(fan);
  for (const HalfedgeId h : mesh.outgoing(fan)) star.corners.push_back(h);
  if (turned) std::reverse(star.corners.begin(), star.corners.end());
  for (const HalfedgeId h : star.corners) star.neighbours.push_back(turned ? after(h) : before(h));
  if (!star.closed) star.neighbours.push_back(turned ? before(star.corners.back()) : after(star.corners.back()));
  return star;
}

std::vector<Star> stars_of(const Mesh& mesh, std::uint32_t vertex, Orientation seen) {
  const PerFan<VertexCode> codes = vertex_codes(mesh);
  std::vector<Star> stars;
  if (mesh.halfedge(FanId(vertex)).valid()) stars.push_back(star_of(mesh, codes, FanId(vertex), seen));
  for (std::uint32_t p = mesh.vertex_count(); p < mesh.fan_count(); ++p) {
    if (mesh.vertex(FanId(p)) == VertexId(vertex)) stars.push_back(star_of(mesh, codes, FanId(p), seen));
  }
  return stars;
}

/// Neighbours that look alike when corner i of one star lies on corner j of the other.
std::uint32_t agreement(const Star& one, std::size_t i, const Star& other, std::size_t j) {
  const std::size_t steps =
      std::min(one.neighbours.size() - (one.closed ? 0 : i), other.neighbours.size() - (other.closed ? 0 : j));
  std::uint32_t agreeing = 0;
  for (std::size_t k = 0; k < steps; ++k) {
    const VertexCode here = one.neighbours[(i + k) % one.neighbours.size()];
    if (here == other.neighbours[(j + k) % other.neighbours.size()]) ++agreeing;
  }
  return agreeing;
}

Expected<std::vector<UserAnchor>> vertex_anchors(const NamedMesh& source, std::uint32_t from, const NamedMesh& target,
                                                 std::uint32_t to, Orientation orientation) {
  if (Expected<void> fine = check_vertex(source, from); !fine) return Unexpected(fine.error());
  if (Expected<void> fine = check_vertex(target, to); !fine) return Unexpected(fine.error());
  std::vector<std::pair<std::uint32_t, UserAnchor>> ranked;
  for (const Star& one : stars_of(source.mesh, from, Orientation::Preserving)) {
    for (const Star& other : stars_of(target.mesh, to, orientation)) {
      const auto rank = [&](std::size_t i, std::size_t j) {
        ranked.emplace_back(agreement(one, i, other, j), UserAnchor{one.corners[i], other.corners[j]});
      };
      for (std::size_t j = 0; j < other.corners.size(); ++j) rank(0, j);
      for (std::size_t i = 1; i < one.corners.size(); ++i) rank(i, 0);
    }
  }
  if (ranked.empty()) {
    return refuse(fmt::format("vertex {} of {} or vertex {} of {} belongs to no face; choose another", from,
                              source.name, to, target.name));
  }
  std::stable_sort(ranked.begin(), ranked.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<UserAnchor> anchors;
  for (const auto& [agreeing, anchor] : ranked) anchors.push_back(anchor);
  return anchors;
}

Expected<std::vector<UserAnchor>> anchors_at(const NamedMesh& source, const Place& from, const NamedMesh& target,
                                             const Place& to, Orientation orientation) {
  if (from.form == '-') return edge_anchors(source, from, target, to, orientation);
  if (from.form == '=') return vertex_anchors(source, from.first, target, to.first, orientation);
  const Expected<HalfedgeId> corner = corner_at(source, from);
  if (!corner) return Unexpected(corner.error());
  const Expected<HalfedgeId> image = corner_at(target, to);
  if (!image) return Unexpected(image.error());
  return std::vector<UserAnchor>{{*corner, *image}};
}

/// Keep the anchors whose faces can lie on each other; an error where none can.
Expected<std::vector<UserAnchor>> fitting(const std::vector<UserAnchor>& anchors, const Mesh& source,
                                          const Mesh& target) {
  std::vector<UserAnchor> fit;
  for (const UserAnchor& anchor : anchors) {
    if (check_anchor(source, target, anchor)) fit.push_back(anchor);
  }
  if (fit.empty()) return Unexpected(check_anchor(source, target, anchors.front()).error());
  return fit;
}

}  // namespace

Expected<std::vector<UserAnchor>> parse_anchor(const std::string& text, const NamedMesh& source,
                                               const NamedMesh& target, Orientation orientation) {
  const auto named = [&text](Error error) {
    error.path = "--anchor " + text;
    return Unexpected(std::move(error));
  };
  const std::size_t equals = text.find('=');
  const std::optional<Place> from = parse_place(std::string_view(text).substr(0, equals));
  const std::optional<Place> to =
      equals == std::string::npos ? std::nullopt : parse_place(std::string_view(text).substr(equals + 1));
  if (!from || !to || from->form != to->form) {
    return named({ErrorCode::BadArgument,
                  "this is no anchor; write face:corner=face:corner, vertex-vertex=vertex-vertex or vertex=vertex, "
                  "counted from 0"});
  }
  Expected<std::vector<UserAnchor>> anchors = anchors_at(source, *from, target, *to, orientation);
  if (!anchors) return named(anchors.error());
  anchors = fitting(*anchors, source.mesh, target.mesh);
  if (!anchors) return named(anchors.error());
  return anchors;
}

}  // namespace quadmatch::cli
