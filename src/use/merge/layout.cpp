#include "layout.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNoJunction = MergedVertex::kNoJunction;

/// The junction of each vertex of a mesh, none where no face uses it.
PerVertex<std::uint32_t> junctions_of(const Mesh& mesh, Side side, const Cells& cells, const Junctions& junctions) {
  PerVertex<std::uint32_t> of_vertex(mesh.vertex_count(), kNoJunction);
  for (std::uint32_t c = 0; c < cells.corners.size(); ++c) {
    const HalfedgeId h = cells.corners[c][side];
    if (h.valid()) of_vertex[mesh.origin(h)] = junctions.of_corner[c];
  }
  return of_vertex;
}

using Places = std::map<Point, std::int64_t>;  // how many vertices of no face are there

Places unused_places(const Mesh& mesh, const PerVertex<std::uint32_t>& junctions) {
  Places places;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (junctions[VertexId(v)] == kNoJunction) ++places[mesh.positions().empty() ? Point{} : mesh.positions()[v]];
  }
  return places;
}

class VertexLayout {
 public:
  VertexLayout(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions, Layout& layout)
      : meshes_(meshes), junctions_(junctions), layout_(layout) {
    for (const Side side : kSides) {
      of_vertex_[static_cast<std::size_t>(side)] = junctions_of(mesh_of(meshes, side), side, cells, junctions);
    }
  }

  void run() {
    layout_.of_ours = PerVertex<VertexId>(mesh_of(meshes_, Side::Ours).vertex_count());
    layout_.of_theirs = PerVertex<VertexId>(mesh_of(meshes_, Side::Theirs).vertex_count());
    count_unused();
    const PerVertex<VertexId> replacement = replacements();
    for (std::uint32_t v = 0; v < layout_.of_ours.size(); ++v) add_ours(VertexId(v), replacement[VertexId(v)]);
    for (std::uint32_t v = 0; v < layout_.of_theirs.size(); ++v) add_theirs(VertexId(v));
  }

 private:
  [[nodiscard]] std::uint32_t junction(Side side, VertexId v) const {
    return of_vertex_[static_cast<std::size_t>(side)][v];
  }

  void add(Side side, VertexId v) {
    PerVertex<VertexId>& places = side == Side::Ours ? layout_.of_ours : layout_.of_theirs;
    if (places[v].valid()) return;
    places[v] = VertexId(static_cast<std::uint32_t>(layout_.vertices.size()));
    MergedVertex vertex{side, {}, junction(side, v)};
    vertex.in[side] = v;
    layout_.vertices.push_back(vertex);
  }

  void add_ours(VertexId v, VertexId replacement) {
    const std::uint32_t j = junction(Side::Ours, v);
    if (j == kNoJunction) {
      if (!take(removed_, Side::Ours, v)) add(Side::Ours, v);
    } else if (junctions_.list[j].decides == Side::Ours) {
      add(Side::Ours, v);
    } else if (replacement.valid()) {
      add(Side::Theirs, replacement);
    }
  }

  void add_theirs(VertexId v) {
    const std::uint32_t j = junction(Side::Theirs, v);
    const bool wanted = j == kNoJunction ? take(added_, Side::Theirs, v) : junctions_.list[j].decides == Side::Theirs;
    if (wanted) add(Side::Theirs, v);
  }

  /// For vertices of OURS at junctions that THEIRS decides: the vertices there of THEIRS, as far as they go.
  [[nodiscard]] PerVertex<VertexId> replacements() const {
    std::vector<std::pair<std::uint32_t, VertexId>> theirs;
    for (std::uint32_t v = 0; v < layout_.of_theirs.size(); ++v) {
      const std::uint32_t j = junction(Side::Theirs, VertexId(v));
      if (j != kNoJunction && junctions_.list[j].decides == Side::Theirs) theirs.emplace_back(j, v);
    }
    std::sort(theirs.begin(), theirs.end());
    PerVertex<VertexId> replacement(layout_.of_ours.size());
    std::vector<std::uint8_t> used(theirs.size(), 0);
    for (std::uint32_t v = 0; v < layout_.of_ours.size(); ++v) {
      const std::uint32_t j = junction(Side::Ours, VertexId(v));
      if (j == kNoJunction || junctions_.list[j].decides == Side::Ours) continue;
      auto k = static_cast<std::size_t>(std::lower_bound(theirs.begin(), theirs.end(), std::pair(j, VertexId(0))) -
                                        theirs.begin());
      while (k < theirs.size() && theirs[k].first == j && used[k] != 0) ++k;
      if (k == theirs.size() || theirs[k].first != j) continue;
      used[k] = 1;
      replacement[VertexId(v)] = theirs[k].second;
    }
    return replacement;
  }

  /// What THEIRS took away and added, beyond what OURS added too.
  void count_unused() {
    std::array<Places, 3> places;
    for (const Side side : kSides) {
      const auto s = static_cast<std::size_t>(side);
      places[s] = unused_places(mesh_of(meshes_, side), of_vertex_[s]);
    }
    for (const auto& [point, count] : places[0]) removed_[point] = std::max<std::int64_t>(0, count - places[2][point]);
    for (const auto& [point, count] : places[2]) {
      const std::int64_t before = places[0][point];
      added_[point] = std::max<std::int64_t>(0, count - std::max(before, places[1][point]));
    }
  }

  /// One of those counted, if this vertex is where there are any left.
  [[nodiscard]] bool take(Places& counted, Side side, VertexId v) const {
    const Mesh& mesh = mesh_of(meshes_, side);
    const auto found = counted.find(mesh.positions().empty() ? Point{} : mesh.positions()[v.value]);
    if (found == counted.end() || found->second == 0) return false;
    --found->second;
    return true;
  }

  const ThreeMeshes& meshes_;
  const Junctions& junctions_;
  Layout& layout_;
  std::array<PerVertex<std::uint32_t>, 3> of_vertex_;
  Places removed_, added_;
};

/// The vertex of the result at a corner of a cell that it has.
VertexId vertex_at(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions, const Layout& layout,
                   std::uint32_t corner) {
  const Side side = junctions.at(corner).decides;
  const VertexId v = mesh_of(meshes, side).origin(cells.corners[corner][side]);
  return side == Side::Ours ? layout.of_ours[v] : layout.of_theirs[v];
}

/// @param common  only by corners that all three have.
void enter_others(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions, bool common,
                  Layout& layout) {
  for (const std::uint32_t cell : layout.cells) {
    const InThree<FaceId>& faces = cells.faces[cell];
    const bool in_all = std::all_of(faces.in.begin(), faces.in.end(), [](FaceId f) { return f.valid(); });
    if (common && !in_all) continue;
    for (std::uint32_t c = cells.first_corner[cell]; c < cells.first_corner[cell + 1]; ++c) {
      InThree<VertexId>& in = layout.vertices[vertex_at(meshes, cells, junctions, layout, c).value].in;
      for (const Side side : kSides) {
        if (!in[side].valid() && cells.corners[c][side].valid()) {
          in[side] = mesh_of(meshes, side).origin(cells.corners[c][side]);
        }
      }
    }
  }
}

}  // namespace

Layout lay_out(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions) {
  Layout layout;
  for (std::uint32_t cell = 0; cell < cells.faces.size(); ++cell) {
    if (is_present(cells, junctions, cell)) layout.cells.push_back(cell);
  }
  VertexLayout(meshes, cells, junctions, layout).run();
  enter_others(meshes, cells, junctions, true, layout);
  enter_others(meshes, cells, junctions, false, layout);
  return layout;
}

PolygonSoup soup_of(const ThreeMeshes& meshes, const Cells& cells, const Junctions& junctions, const Layout& layout) {
  PolygonSoup soup;
  soup.vertex_count = static_cast<std::uint32_t>(layout.vertices.size());
  soup.face_starts = {0};
  bool all_quads = true;
  for (const std::uint32_t cell : layout.cells) {
    for (std::uint32_t c = cells.first_corner[cell]; c < cells.first_corner[cell + 1]; ++c) {
      soup.corners.push_back(vertex_at(meshes, cells, junctions, layout, c));
    }
    all_quads = all_quads && cells.first_corner[cell + 1] - cells.first_corner[cell] == 4;
    soup.face_starts.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  }
  if (all_quads) soup.face_starts.clear();
  return soup;
}

}  // namespace quadmatch::use
