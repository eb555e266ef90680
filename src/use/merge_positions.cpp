#include "merge_positions.hpp"

#include <optional>
#include <utility>

#include "harmonic.hpp"

namespace quadmatch::use {
namespace {

/// How far another side moves the vertices of a side.
class Displacement {
 public:
  /// Known at vertices with a corner that all three have, outside of conflicts.
  Displacement(const ThreeFiles& files, const Cells& cells, const Junctions& junctions, Side side)
      : mesh_(file_of(files, side).mesh),
        moves_{3, std::vector<std::uint8_t>(mesh_.vertex_count(), 0),
               std::vector<double>(3 * mesh_.vertex_count(), 0)} {
    const Mesh &base = file_of(files, Side::Base).mesh, &mover = file_of(files, other(side)).mesh;
    for (std::uint32_t c = 0; c < cells.corners.size(); ++c) {
      const InThree<HalfedgeId>& corner = cells.corners[c];
      const bool in_all = corner[Side::Base].valid() && corner[Side::Ours].valid() && corner[Side::Theirs].valid();
      if (!in_all || junctions.at(c).in_conflict()) continue;
      const VertexId v = mesh_.origin(corner[side]);
      if (moves_.known[v.value] != 0) continue;
      moves_.known[v.value] = 1;
      const Point& before = base.positions()[base.origin(corner[Side::Base]).value];
      const Point& after = mover.positions()[mover.origin(corner[other(side)]).value];
      for (std::size_t k = 0; k < 3; ++k) {
        moves_.values[3 * std::size_t{v.value} + k] = after[k] - before[k];
        any_ = any_ || after[k] != before[k];
      }
    }
  }

  /// By how much it is moved; by nothing where it hangs together with nothing that is.
  [[nodiscard]] Point at(VertexId v) {
    if (!any_) return {};
    if (moves_.known[v.value] == 0 && !std::exchange(interpolated_, true)) interpolate_rest();
    const double* const move = moves_.values.data() + 3 * std::size_t{v.value};
    return moves_.known[v.value] == 0 ? Point{} : Point{move[0], move[1], move[2]};
  }

 private:
  void interpolate_rest() {
    const std::vector<double> weights = edge_weights(mesh_);
    std::vector<WeightedEdge> edges;
    for (std::uint32_t h = 0; h < mesh_.halfedge_count(); ++h) {
      edges.push_back({mesh_.origin(HalfedgeId(h)).value, mesh_.tip(HalfedgeId(h)).value, weights[h]});
    }
    interpolate(edges, moves_);
  }

  const Mesh& mesh_;
  GraphValues moves_;
  bool any_ = false;
  bool interpolated_ = false;
};

/// Does a side alone decide where the vertex is, but for what the other moves around it?
bool is_carried(const Layout& layout, const Junctions& junctions, std::size_t vertex) {
  const std::uint32_t j = layout.vertices[vertex].junction;
  if (j == MergedVertex::kNoJunction) return false;
  return junctions.list[j].in_conflict() || junctions.list[j].by_ours != junctions.list[j].by_theirs;
}

}  // namespace

MergedPositions merge_positions(const ThreeFiles& files, const Cells& cells, const Junctions& junctions,
                                const Layout& layout, const Origins& origins, Side preferred, ValueTally& tally) {
  for (const MeshFile* const file : files) {
    if (file->mesh.positions().empty()) return {};
  }
  const auto point = [&](Side side, std::uint32_t v) { return file_of(files, side).mesh.positions()[v]; };
  std::vector<Origin> elements = origins.vertices;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (!is_carried(layout, junctions, k)) continue;
    const Side side = layout.vertices[k].side;
    elements[k] = {{Origin::kNowhere, Origin::kNowhere, Origin::kNowhere}};
    elements[k].in[static_cast<std::size_t>(side)] = layout.vertices[k].in[side].value;
  }
  const Picks picks =
      pick("positions", Domain::Vertex, elements, preferred,
           [&](Side a, std::uint32_t i, Side b, std::uint32_t j) { return point(a, i) == point(b, j); });
  tally.enter(picks);

  MergedPositions merged;
  std::array<std::optional<Displacement>, 3> moves;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const Side side = picks.sides[k];
    Point place = point(side, elements[k][side]);
    if (is_carried(layout, junctions, k)) {
      std::optional<Displacement>& displacement = moves[static_cast<std::size_t>(side)];
      if (!displacement) displacement.emplace(files, cells, junctions, side);
      const Point move = displacement->at(layout.vertices[k].in[side]);
      if (move != Point{}) ++merged.carried_along;
      for (std::size_t c = 0; c < 3; ++c) place[c] += move[c];
    }
    merged.points.push_back(place);
  }
  return merged;
}

}  // namespace quadmatch::use
