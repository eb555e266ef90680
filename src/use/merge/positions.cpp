#include "positions.hpp"

#include <optional>
#include <utility>

#include "../data/harmonic.hpp"

namespace quadmatch::use {
namespace {

/// How far another side moves the vertices of a side.
class Displacement {
 public:
  /// Known at vertices with a corner that all three have, outside of conflicts.
  /// @param held  as of `held_junctions`.
  Displacement(const ThreeFiles& files, const Cells& cells, const Junctions& junctions,
               const std::vector<std::uint8_t>& held, Side side)
      : mesh_(file_of(files, side).mesh),
        moves_{3, std::vector<std::uint8_t>(mesh_.vertex_count(), 0),
               std::vector<double>(std::size_t{3} * mesh_.vertex_count(), 0)} {
    const Mesh &base = file_of(files, Side::Base).mesh, &mover = file_of(files, other(side)).mesh;
    for (std::uint32_t c = 0; c < cells.corners.size(); ++c) {
      const InThree<HalfedgeId>& corner = cells.corners[c];
      const bool in_all = corner[Side::Base].valid() && corner[Side::Ours].valid() && corner[Side::Theirs].valid();
      if (!in_all) continue;
      const VertexId v = mesh_.origin(corner[side]);
      if (moves_.known[v.value] != 0) continue;  // by another corner
      if (junctions.at(c).in_conflict() || held[junctions.of_corner[c]] != 0) continue;
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

/// The junctions that a side left as they are and moved.
std::vector<std::uint8_t> moved_junctions(const ThreeFiles& files, const Cells& cells, const Junctions& junctions,
                                          Side side) {
  const Mesh &base = file_of(files, Side::Base).mesh, &mesh = file_of(files, side).mesh;
  std::vector<std::uint8_t> moved(junctions.list.size(), 0);
  for (std::uint32_t c = 0; c < cells.corners.size(); ++c) {
    const HalfedgeId before = cells.corners[c][Side::Base], after = cells.corners[c][side];
    if (!before.valid() || !after.valid() || junctions.at(c).by(side)) continue;
    const bool same = base.positions()[base.origin(before).value] == mesh.positions()[mesh.origin(after).value];
    if (!same) moved[junctions.of_corner[c]] = 1;
  }
  return moved;
}

/// Junctions that the side which is not preferred moved as part of an edit in conflict: those that hang together with
/// the conflict. There the result holds the preferred side, too. Where it moved most of the mesh, that is a pose and
/// part of no edit.
std::vector<std::uint8_t> held_junctions(const ThreeFiles& files, const Cells& cells, const Junctions& junctions,
                                         Side preferred) {
  const std::size_t count = junctions.list.size();
  std::vector<std::uint8_t> held(count, 0);
  if (junctions.areas == 0) return held;
  const std::vector<std::uint8_t> moved = moved_junctions(files, cells, junctions, other(preferred));
  std::vector<std::uint32_t> starts(count + 1, 0), cells_at(cells.corners.size());
  for (const std::uint32_t j : junctions.of_corner) ++starts[j + 1];
  for (std::size_t j = 1; j <= count; ++j) starts[j] += starts[j - 1];
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  for (std::uint32_t cell = 0; cell < cells.faces.size(); ++cell) {
    for (std::uint32_t c = cells.first_corner[cell]; c < cells.first_corner[cell + 1]; ++c) {
      cells_at[next[junctions.of_corner[c]]++] = cell;
    }
  }
  std::vector<std::uint32_t> reached;
  for (std::uint32_t j = 0; j < count; ++j) {
    if (junctions.list[j].in_conflict()) reached.push_back(j);
  }
  std::size_t held_count = 0;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    for (std::uint32_t i = starts[reached[k]]; i < starts[reached[k] + 1]; ++i) {
      for (std::uint32_t c = cells.first_corner[cells_at[i]]; c < cells.first_corner[cells_at[i] + 1]; ++c) {
        const std::uint32_t j = junctions.of_corner[c];
        if (moved[j] == 0 || held[j] != 0 || junctions.list[j].in_conflict()) continue;
        held[j] = 1;
        ++held_count;
        reached.push_back(j);
      }
    }
  }
  if (2 * held_count > count) held.assign(count, 0);
  return held;
}

/// Whose place a vertex has, if a side alone decides it, but for what the other moves around it.
std::optional<Side> decided_by(const Layout& layout, const Junctions& junctions, const std::vector<std::uint8_t>& held,
                               Side preferred, std::size_t vertex) {
  const std::uint32_t j = layout.vertices[vertex].junction;
  if (j == MergedVertex::kNoJunction) return std::nullopt;
  if (held[j] != 0) return preferred;
  const Junction& junction = junctions.list[j];
  if (junction.in_conflict() || junction.by_ours != junction.by_theirs) return layout.vertices[vertex].side;
  return std::nullopt;
}

}  // namespace

MergedPositions merge_positions(const ThreeFiles& files, const Cells& cells, const Junctions& junctions,
                                const Layout& layout, const Origins& origins, Side preferred, ValueTally& tally) {
  for (const MeshFile* const file : files) {
    if (file->mesh.positions().empty()) return {};
  }
  const auto point = [&](Side side, std::uint32_t v) { return file_of(files, side).mesh.positions()[v]; };
  const std::vector<std::uint8_t> held = held_junctions(files, cells, junctions, preferred);
  std::vector<Origin> elements = origins.vertices;
  for (std::size_t k = 0; k < elements.size(); ++k) {
    if (const auto side = decided_by(layout, junctions, held, preferred, k)) {
      elements[k] = origin_of(layout.vertices[k].in, true, *side);
    }
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
    if (decided_by(layout, junctions, held, preferred, k)) {
      std::optional<Displacement>& displacement = moves[static_cast<std::size_t>(side)];
      if (!displacement) displacement.emplace(files, cells, junctions, held, side);
      const Point move = displacement->at(VertexId(elements[k][side]));
      if (move != Point{}) ++merged.carried_along;
      for (std::size_t c = 0; c < 3; ++c) place[c] += move[c];
    }
    merged.points.push_back(place);
  }
  return merged;
}

}  // namespace quadmatch::use
