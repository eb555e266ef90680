// Kinds are named for what came; where faces went, the area is looked at from the other end. Questions are asked from
// the most particular to the most general, and the first that says yes names the change (docs/design/016-diff.md).

#include "naming.hpp"

#include <algorithm>
#include <vector>

#include <quadmatch/mesh/disjoint_sets.hpp>

#include "lifted.hpp"
#include "rows.hpp"

namespace quadmatch::use {
namespace {

/// The sides of the rim, by what is beyond them before and after.
struct RimCounts {
  std::size_t all = 0;
  std::size_t at_boundary = 0;  ///< nothing before, new faces after
  std::size_t between = 0;      ///< matched faces before, new faces after
  std::size_t cut = 0;          ///< matched faces before, nothing after
  std::size_t joined = 0;       ///< nothing before, matched faces after
  std::size_t shifted = 0;      ///< matched faces before, other ones after
};

RimCounts count(const Scene& scene) {
  RimCounts counts;
  counts.all = scene.rim.size();
  for (const RimSide& side : scene.rim) {
    if (side.in_after == Beyond::Unmatched) {
      counts.at_boundary += side.in_before == Beyond::Nothing ? 1 : 0;
      counts.between += side.in_before == Beyond::Matched ? 1 : 0;
    } else if (side.in_before == Beyond::Matched) {
      ++(side.in_after == Beyond::Nothing ? counts.cut : counts.shifted);
    } else if (side.in_before == Beyond::Nothing) {
      ++counts.joined;
    }
  }
  return counts;
}

/// Closed or open lines that the sides of the rim make, joined where they share a vertex.
std::size_t count_rims(const Scene& scene) {
  const Mesh& mesh = *scene.before->mesh;
  std::vector<std::uint32_t> vertices;
  for (const RimSide& side : scene.rim) {
    vertices.push_back(mesh.origin(side.before).value);
    vertices.push_back(mesh.tip(side.before).value);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  const auto place = [&](VertexId v) {
    return static_cast<std::uint32_t>(std::lower_bound(vertices.begin(), vertices.end(), v.value) - vertices.begin());
  };
  DisjointSets sets(static_cast<std::uint32_t>(vertices.size()));
  for (const RimSide& side : scene.rim) sets.join(place(mesh.origin(side.before)), place(mesh.tip(side.before)));
  std::size_t rims = 0;
  for (std::uint32_t k = 0; k < vertices.size(); ++k) rims += sets.find(k) == k ? 1 : 0;
  return rims;
}

/// No more faces after than before.
ChangeKind name_balanced(const Scene& scene) {
  const RimCounts counts = count(scene);
  const std::size_t cuts = counts.cut + counts.joined + counts.shifted;
  if (scene.faces_after.empty() || cuts > 0) {
    if (counts.joined + counts.shifted == 0 && !scene.joined) return ChangeKind::Rip;
    if (counts.cut + counts.shifted == 0 && !scene.torn) return ChangeKind::Weld;
    return ChangeKind::Reattachment;
  }
  // Between several rims there are parts that are the same, which are joined otherwise.
  return count_rims(scene) > 1 && scene.pieces_before == scene.pieces_after ? ChangeKind::Reattachment
                                                                            : ChangeKind::Reconnection;
}

/// Faces came between matched ones that were adjacent, or between others.
bool is_wall(const Scene& scene, const RimCounts& counts) {
  return 2 * counts.between >= counts.all && 2 * count_walled(scene) >= counts.between;
}

/// More faces after than before.
Name name_growth(const Scene& scene) {
  const RimCounts counts = count(scene);
  if (counts.all == 0) return {ChangeKind::NewComponent};
  const bool only_new_within = counts.between + counts.at_boundary == 0;
  if (only_new_within && scene.pieces_before > scene.pieces_after) return {ChangeKind::Bridge};
  if (const std::uint32_t rows = count_inserted_rows(scene); rows > 0) return {ChangeKind::InsertedLoop, rows};
  if (is_wall(scene, counts) || is_lifted_patch(scene)) return {ChangeKind::Extrusion};
  if (2 * counts.at_boundary >= counts.all) {
    return scene.positions && is_split_at_boundary(scene) ? Name{ChangeKind::InsertedLoop, 1}
                                                          : Name{ChangeKind::Addition};
  }
  if (2 * counts.between >= counts.all) return {ChangeKind::Opening};
  // A few faces more are no refinement.
  return {4 * scene.faces_after.size() >= 5 * scene.faces_before.size() ? ChangeKind::Refinement
                                                                        : ChangeKind::Reconnection};
}

}  // namespace

Name name_of(const Scene& scene) {
  if (scene.faces_after.size() > scene.faces_before.size()) return name_growth(scene);
  if (scene.faces_after.size() == scene.faces_before.size()) return {name_balanced(scene)};
  const Name name = name_growth(backwards(scene));
  return {inverse(name.kind), name.rows};
}

}  // namespace quadmatch::use
