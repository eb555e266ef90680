// The conditions of §2.1, one after the other, with the sizes of the mesh and of its components.

#include <quadmatch/mesh/check.hpp>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/mesh/components.hpp>
#include <quadmatch/mesh/disjoint_sets.hpp>

#include "open_edges.hpp"
#include "overlaps.hpp"

namespace quadmatch {
namespace {

constexpr std::array kKindNames{
    "not-a-quad",        "degenerate-face",      "unused-vertex",  "disconnected-vertex", "pinched-hole",
    "non-manifold-edge", "inconsistent-winding", "not-orientable", "overlapping-faces",   "duplicate-face",
};

/// One of the fans of a vertex that has several.
struct SplitFan {
  VertexId vertex;
  std::uint32_t fan;   ///< names the fan
  std::uint32_t loop;  ///< names the boundary loop that passes through it; FanId::kNone inside

  auto operator<=>(const SplitFan&) const = default;
};

class Examination {
 public:
  Examination(const Mesh& mesh, std::size_t kept);
  CheckReport run() &&;

 private:
  void gather_components();
  void examine_faces();
  void examine_edges();
  void examine_vertices();
  void trace_loops();
  void examine_fans();
  void examine_orientation();
  void examine_overlaps();
  void conclude();

  void close_edge(const OpenUse& one, const OpenUse& other);
  std::vector<SplitFan> split_fans();

  template <class... Values>
  void depart(DepartureKind kind, fmt::format_string<Values...> text, Values&&... values) {
    const auto index = static_cast<std::size_t>(kind);
    if (report_.departure_counts[index]++ >= kept_) return;
    found_[index].push_back({kind, fmt::format(text, std::forward<Values>(values)...)});
  }

  ComponentReport& component_of(FaceId face) { return report_.components[component_of_piece_[pieces_.of_face[face]]]; }
  ComponentReport& component_of(HalfedgeId h) { return component_of(mesh_.face(h)); }
  ComponentReport& component_of(FanId fan) { return component_of(mesh_.halfedge(fan)); }

  /// The fans at the lower and at the higher end of a half-edge.
  [[nodiscard]] std::pair<std::uint32_t, std::uint32_t> fans_at(const OpenUse& use) const {
    const std::uint32_t here = mesh_.fan(use.halfedge).value;
    const std::uint32_t there = mesh_.fan(mesh_.next(use.halfedge)).value;
    return mesh_.origin(use.halfedge) == use.low ? std::pair(here, there) : std::pair(there, here);
  }

  const Mesh& mesh_;
  const std::size_t kept_;
  CheckReport report_;
  std::vector<std::vector<Departure>> found_;  // by kind

  const Components pieces_;                        // across edges; one or more make a component
  std::vector<std::uint32_t> component_of_piece_;  // index into report_.components
  const OpenEdges open_;
  DisjointSets fans_;              // the mesh's fans, united again across cut edges of two faces
  DisjointSets loops_;             // fans along the boundary
  std::vector<bool> on_boundary_;  // fan by fan, told at the name it has in fans_
  std::vector<std::pair<std::uint32_t, std::uint32_t>> turned_;  // pieces that meet at a wrongly wound edge
};

Examination::Examination(const Mesh& mesh, std::size_t kept)
    : mesh_(mesh),
      kept_(kept),
      found_(kKindNames.size()),
      pieces_(connected_components(mesh)),
      open_(mesh),
      fans_(mesh.fan_count()),
      loops_(mesh.fan_count()),
      on_boundary_(mesh.fan_count(), false) {
  report_.departure_counts.assign(kKindNames.size(), 0);
}

CheckReport Examination::run() && {
  gather_components();
  examine_faces();
  examine_edges();
  examine_vertices();
  trace_loops();
  examine_fans();
  examine_orientation();
  examine_overlaps();
  conclude();
  return std::move(report_);
}

/// Pieces that meet at a vertex of several fans belong to one component.
void Examination::gather_components() {
  const auto pieces = static_cast<std::uint32_t>(pieces_.face_count.size());
  const auto piece_at = [this](FanId fan) { return pieces_.of_face[mesh_.face(mesh_.halfedge(fan))]; };
  DisjointSets united(pieces);
  for (std::uint32_t p = mesh_.vertex_count(); p < mesh_.fan_count(); ++p) {
    united.join(piece_at(FanId(p)), piece_at(FanId(mesh_.vertex(FanId(p)).value)));
  }

  // Pieces are numbered by their lowest face, and united ones are named by the lowest piece: ties stay in that order.
  std::vector<std::uint32_t> faces(pieces, 0);
  std::vector<std::uint32_t> order;
  for (std::uint32_t piece = 0; piece < pieces; ++piece) {
    faces[united.find(piece)] += pieces_.face_count[piece];
    if (united.find(piece) == piece) order.push_back(piece);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&faces](std::uint32_t a, std::uint32_t b) { return faces[a] > faces[b]; });

  report_.components.resize(order.size());
  component_of_piece_.resize(pieces);
  for (std::uint32_t rank = 0; rank < order.size(); ++rank) {
    report_.components[rank].faces = faces[order[rank]];
    component_of_piece_[order[rank]] = rank;
  }
  for (std::uint32_t piece = 0; piece < pieces; ++piece) {
    component_of_piece_[piece] = component_of_piece_[united.find(piece)];
  }
}

void Examination::examine_faces() {
  std::vector<VertexId> sorted;
  for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
    const std::uint32_t size = mesh_.size(FaceId(f));
    ++(size == 3 ? report_.triangles : size == 4 ? report_.quads : report_.larger);
    if (size != 4) depart(DepartureKind::NotAQuad, "f{} has {} corners", f, size);

    const auto corners = mesh_.corners().subspan(mesh_.first(FaceId(f)).value, size);
    sorted.assign(corners.begin(), corners.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) depart(DepartureKind::DegenerateFace, "f{} visits v{} twice", f, twice->value);
  }
}

void Examination::examine_edges() {
  for (std::uint32_t number = 0; number < mesh_.halfedge_count(); ++number) {
    const HalfedgeId h(number);
    if (mesh_.twin(h).valid() && h < mesh_.twin(h)) ++component_of(h).edges;
  }
  for (const std::span<const OpenUse> uses : open_) {
    ComponentReport& component = component_of(uses.front().halfedge);
    ++component.edges;
    if (uses.size() == 2) close_edge(uses[0], uses[1]);
    if (uses.size() <= 2) continue;
    component.manifold = false;
    depart(DepartureKind::NonManifoldEdge, "the edge v{}-v{} has {} faces", uses.front().low.value,
           uses.front().high.value, uses.size());
  }
}

/// The mesh cuts an edge of two half-edges where they run the same way or belong to one face; the surface itself goes
/// on there.
void Examination::close_edge(const OpenUse& one, const OpenUse& other) {
  fans_.join(fans_at(one).first, fans_at(other).first);
  fans_.join(fans_at(one).second, fans_at(other).second);
  if (mesh_.origin(one.halfedge) != mesh_.origin(other.halfedge)) return;
  const FaceId face = mesh_.face(one.halfedge);
  const FaceId beside = mesh_.face(other.halfedge);
  turned_.emplace_back(pieces_.of_face[face], pieces_.of_face[beside]);
  depart(DepartureKind::InconsistentWinding, "f{} and f{} both run from v{} to v{}", face.value, beside.value,
         mesh_.origin(one.halfedge).value, mesh_.tip(one.halfedge).value);
}

/// Valences count distinct edges; a vertex is on the boundary where one of them has one face only.
void Examination::examine_vertices() {
  PerVertex<std::uint32_t> valence(mesh_.vertex_count(), 0);
  PerVertex<std::uint8_t> on_boundary(mesh_.vertex_count(), 0);
  for (std::uint32_t number = 0; number < mesh_.halfedge_count(); ++number) {
    const HalfedgeId h(number);
    if (mesh_.twin(h).valid()) ++valence[mesh_.origin(h)];  // the other end is counted at the twin
  }
  for (const std::span<const OpenUse> uses : open_) {
    for (const VertexId v : {uses.front().low, uses.front().high}) {
      ++valence[v];
      if (uses.size() == 1) on_boundary[v] = 1;
    }
  }
  for (std::uint32_t number = 0; number < mesh_.vertex_count(); ++number) {
    const VertexId v(number);
    if (!mesh_.halfedge(FanId(number)).valid()) {
      depart(DepartureKind::UnusedVertex, "v{} belongs to no face", number);
      continue;
    }
    ComponentReport& component = component_of(FanId(number));
    ++component.vertices;
    if (valence[v] != (on_boundary[v] != 0 ? 3 : 4)) ++component.extraordinary;
  }
}

/// Follow the boundary from fan to fan. @pre examine_edges() has united the fans.
void Examination::trace_loops() {
  for (const std::span<const OpenUse> uses : open_) {
    if (uses.size() != 1) continue;
    const auto [low, high] = fans_at(uses.front());
    for (const std::uint32_t fan : {low, high}) on_boundary_[fans_.find(fan)] = true;
    loops_.join(fans_.find(low), fans_.find(high));
  }
  for (std::uint32_t fan = 0; fan < mesh_.fan_count(); ++fan) {
    if (on_boundary_[fan] && loops_.find(fan) == fan) ++component_of(FanId(fan)).boundary_loops;
  }
}

/// The fans of all vertices that have several, by vertex.
std::vector<SplitFan> Examination::split_fans() {
  std::vector<SplitFan> fans;
  const auto add = [this, &fans](VertexId v, std::uint32_t p) {
    const std::uint32_t fan = fans_.find(p);
    fans.push_back({v, fan, on_boundary_[fan] ? loops_.find(fan) : FanId::kNone});
  };
  for (const VertexId v : mesh_.split_vertices()) add(v, v.value);
  for (std::uint32_t p = mesh_.vertex_count(); p < mesh_.fan_count(); ++p) add(mesh_.vertex(FanId(p)), p);
  std::sort(fans.begin(), fans.end());
  fans.erase(std::unique(fans.begin(), fans.end()), fans.end());
  return fans;
}

/// Conditions 1 and 2. Two fans of one vertex on the same boundary loop make that loop pass the vertex twice.
void Examination::examine_fans() {
  const std::vector<SplitFan> fans = split_fans();
  std::vector<std::uint32_t> loops;
  for (auto first = fans.begin(), last = first; first != fans.end(); first = last) {
    loops.clear();
    for (; last != fans.end() && last->vertex == first->vertex; ++last) {
      if (last->loop != FanId::kNone) loops.push_back(last->loop);
    }
    if (last - first == 1) continue;
    component_of(FanId(first->fan)).manifold = false;
    depart(DepartureKind::DisconnectedVertex, "the faces around v{} form {} fans that share no edge",
           first->vertex.value, last - first);
    std::sort(loops.begin(), loops.end());
    if (std::adjacent_find(loops.begin(), loops.end()) != loops.end()) {
      depart(DepartureKind::PinchedHole, "a hole passes v{} twice, so no disk closes it", first->vertex.value);
    }
  }
}

/// Give every piece two sides and glue sides at wrongly wound edges: a piece both of whose sides become one has a
/// Moebius strip through it.
void Examination::examine_orientation() {
  if (turned_.empty()) return;
  const auto pieces = static_cast<std::uint32_t>(pieces_.face_count.size());
  DisjointSets sides(2 * pieces);
  for (const auto& [a, b] : turned_) {
    sides.join(2 * a, 2 * b + 1);
    sides.join(2 * a + 1, 2 * b);
  }
  for (std::uint32_t piece = 0; piece < pieces; ++piece) {
    ComponentReport& component = report_.components[component_of_piece_[piece]];
    if (sides.find(2 * piece) == sides.find(2 * piece + 1)) component.orientable = false;
  }
  std::vector<bool> named(report_.components.size(), false);
  for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
    const std::uint32_t component = component_of_piece_[pieces_.of_face[FaceId(f)]];
    if (report_.components[component].orientable || named[component]) continue;
    named[component] = true;
    depart(DepartureKind::NotOrientable, "the component of f{} is one-sided, however its faces are turned", f);
  }
}

void Examination::examine_overlaps() {
  for (const Overlap& overlap : overlapping_quads(mesh_)) {
    depart(DepartureKind::OverlappingFaces, "f{} and f{} share {} vertices and {} edges, not just one or the other",
           overlap.one.value, overlap.other.value, overlap.shared_vertices, overlap.shared_edges);
  }
  for (const Duplicate& duplicate : duplicate_faces(mesh_)) {
    depart(DepartureKind::DuplicateFace, "f{} has the same vertices as f{}", duplicate.face.value,
           duplicate.original.value);
  }
}

void Examination::conclude() {
  report_.faces = mesh_.face_count();
  for (ComponentReport& component : report_.components) {
    component.euler = std::int64_t{component.vertices} - component.edges + component.faces;
    const std::int64_t closed = 2 - component.euler - component.boundary_loops;
    if (component.manifold && closed >= 0) {
      component.genus = static_cast<std::uint32_t>(component.orientable ? closed / 2 : closed);
    }
    report_.vertices += component.vertices;
    report_.edges += component.edges;
    report_.boundary_loops += component.boundary_loops;
    report_.extraordinary += component.extraordinary;
  }
  for (std::vector<Departure>& of_kind : found_) {
    std::move(of_kind.begin(), of_kind.end(), std::back_inserter(report_.departures));
  }
}

}  // namespace

const char* to_string(DepartureKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

bool CheckReport::well_formed() const {
  return std::all_of(departure_counts.begin(), departure_counts.end(), [](std::size_t count) { return count == 0; });
}

CheckReport check(const Mesh& mesh, std::size_t kept) { return Examination(mesh, kept).run(); }

}  // namespace quadmatch
