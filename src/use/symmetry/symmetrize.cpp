// Sides are told apart first; then positions are mirrored, and all else is a transfer of the mesh onto itself.

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/use/symmetry.hpp>

#include "mirror_map.hpp"
#include "mirror_plane.hpp"
#include "mirror_regions.hpp"
#include "part_mesh.hpp"

namespace quadmatch {
namespace use {
namespace {

constexpr std::uint32_t kNone = 0xffffffff;

std::int8_t sign_of(double number) { return static_cast<std::int8_t>(number > 0 ? 1 : number < 0 ? -1 : 0); }

/// Tells the sides of a mirror apart.
class Sides {
 public:
  Sides(const Mesh& mesh, const Match& match, MirrorSide side)
      : mesh_(mesh),
        side_(side),
        images_(images_of(mesh, mesh, match.regions)),
        area_(mesh.face_count(), kNone),
        faces_(mesh.face_count(), 0) {
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      if (area_[FaceId(f)] == kNone && is_beside(FaceId(f))) flood(FaceId(f));
    }
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
      const FaceId face(f), partner = partner_of(face);
      if (!partner.valid() || partner <= face) continue;
      const double ahead =
          area_[face] == area_[partner] ? height(face) - height(partner) : ahead_[area_[face]] - ahead_[area_[partner]];
      faces_[face] = sign_of(ahead);
      faces_[partner] = sign_of(-ahead);
    }
  }

  [[nodiscard]] const PerFace<std::int8_t>& faces() const { return faces_; }

  /// Of a vertex with a partner of its own: that of its faces, or by its place where they do not agree.
  [[nodiscard]] PerVertex<std::int8_t> vertices(const std::vector<VertexPair>& pairs) const {
    PerVertex<std::uint8_t> ahead(mesh_.vertex_count(), 0), behind(mesh_.vertex_count(), 0);
    for (std::uint32_t h = 0; h < mesh_.halfedge_count(); ++h) {
      const std::int8_t face = faces_[mesh_.face(HalfedgeId(h))];
      if (face > 0) ahead[mesh_.origin(HalfedgeId(h))] = 1;
      if (face < 0) behind[mesh_.origin(HalfedgeId(h))] = 1;
    }
    PerVertex<std::int8_t> sides(mesh_.vertex_count(), 0);
    for (const auto& [v, w] : pairs) {
      if (w <= v) continue;
      const int by_faces = ahead[v] - behind[v] - ahead[w] + behind[w];
      sides[v] = sign_of(by_faces != 0 ? by_faces : height(v) - height(w));
      sides[w] = static_cast<std::int8_t>(-sides[v]);
    }
    return sides;
  }

 private:
  [[nodiscard]] FaceId partner_of(FaceId f) const {
    const HalfedgeId there = images_[mesh_.first(f)];
    return there.valid() ? mesh_.face(there) : FaceId();
  }
  /// Has it a partner other than itself?
  [[nodiscard]] bool is_beside(FaceId f) const { return partner_of(f).valid() && partner_of(f) != f; }
  [[nodiscard]] double height(VertexId v) const {
    const double coordinate = mesh_.positions()[v.value][side_.axis];
    return side_.positive ? coordinate : -coordinate;
  }
  [[nodiscard]] double height(FaceId f) const {
    double sum = 0;
    for (const HalfedgeId h : mesh_.halfedges(f)) sum += height(mesh_.origin(h));
    return sum / mesh_.size(f);
  }

  /// All faces that can be reached without crossing the centre line.
  void flood(FaceId seed) {
    const auto area = static_cast<std::uint32_t>(ahead_.size());
    ahead_.push_back(0);
    std::vector<FaceId> to_visit{seed};
    area_[seed] = area;
    while (!to_visit.empty()) {
      const FaceId face = to_visit.back();
      to_visit.pop_back();
      ahead_[area] += height(face) - height(partner_of(face));
      for (const HalfedgeId h : mesh_.halfedges(face)) {
        const HalfedgeId beside = mesh_.twin(h);
        if (!beside.valid() || images_[h] == beside) continue;
        const FaceId next = mesh_.face(beside);
        if (area_[next] != kNone || !is_beside(next)) continue;
        area_[next] = area;
        to_visit.push_back(next);
      }
    }
  }

  const Mesh& mesh_;
  const MirrorSide side_;
  const PerHalfedge<HalfedgeId> images_;
  PerFace<std::uint32_t> area_;
  std::vector<double> ahead_;  // of each area: how far its faces are ahead of their partners
  PerFace<std::int8_t> faces_;
};

bool carries_more_than_positions(Carry carry) {
  return carry.texture_coordinates || carry.colours || carry.properties || carry.groups || carry.materials ||
         carry.smoothing || carry.normals;
}

/// Half of the mirror: from one side to the other, and nothing back.
Match half_of(const Mesh& mesh, const Match& match, const PerFace<std::int8_t>& sides) {
  const PerFan<VertexCode> codes = vertex_codes(mesh);
  const PerHalfedge<HalfedgeId> images = images_of(mesh, mesh, match.regions);
  MirrorMap map(mesh, codes);
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const HalfedgeId first = mesh.first(FaceId(f));
    if (images[first].valid()) map.lay({first, images[first]}, Fit::Free);
  }
  Match half;
  half.regions = regions_of(mesh, codes, map, [&](FaceId face) { return sides[face] > 0; });
  half.vertices = vertices_of(mesh, half.regions, false);
  return half;
}

Expected<void> check_wishes(const MeshFile& file, const Symmetry& symmetry, const SymmetrizeOptions& options) {
  const auto refuse = [&](std::string message) {
    return Unexpected(Error{ErrorCode::BadArgument, std::move(message), file.path});
  };
  if (file.mesh.positions().empty()) return refuse("it has no positions, so nobody can say which side is which");
  if (!symmetry.plane) return refuse("it has no mirror, so there are no sides to copy");
  const Point& normal = symmetry.plane->normal;
  if (symmetry.plane->fits() && std::abs(normal[options.from.axis]) < 0.1) {
    const auto main = std::max_element(normal.begin(), normal.end()) - normal.begin();
    return refuse(fmt::format("its sides lie to +{0} and -{0}, none to {1}; choose the axis across the mirror",
                              "xyz"[main], "xyz"[options.from.axis]));
  }
  if (options.carry.positions && !symmetry.plane->fits()) {
    return refuse(
        fmt::format("the model is posed: in the best plane, mirrored vertices miss their partners by {:.1f} % of the "
                    "model's size; mirror positions in the rest pose, or leave them out of what is copied",
                    100 * symmetry.plane->error));
  }
  return {};
}

/// Mirror one side's positions onto the other, and bring the centre line into the plane.
void mirror_positions(const MeshFile& file, const Symmetry& symmetry, const PerVertex<std::int8_t>& sides,
                      Symmetrized& result) {
  const std::span<const Point> before = file.mesh.positions();
  std::vector<Point> after(before.begin(), before.end());
  const double least = 1e-4 * mean_edge(file.mesh);  // the last digits of a file are no motion
  for (const auto& [v, w] : symmetry.match.vertices) {
    if (v != w && sides[v] >= 0) continue;  // v takes w's
    Point there = symmetry.plane->mirrored(before[w.value]);
    if (v == w) {
      for (std::size_t axis = 0; axis < 3; ++axis) there[axis] = (there[axis] + before[v.value][axis]) / 2;
    }
    const Point& here = before[v.value];
    const double way = std::hypot(there[0] - here[0], there[1] - here[1], there[2] - here[2]);
    after[v.value] = there;
    result.moved += way > least ? 1 : 0;
    result.farthest = std::max(result.farthest, way);
  }
  result.file.mesh = with_positions(result.file.mesh, std::move(after));
}

}  // namespace
}  // namespace use

std::vector<std::int8_t> sides_of_faces(const Mesh& mesh, const Symmetry& symmetry, MirrorSide side) {
  const use::Sides sides(mesh, symmetry.match, side);
  return {sides.faces().begin(), sides.faces().end()};
}

Expected<Symmetrized> symmetrize(const MeshFile& file, const Symmetry& symmetry, const SymmetrizeOptions& options) {
  if (Expected<void> fine = use::check_wishes(file, symmetry, options); !fine) return Unexpected(fine.error());
  const use::Sides sides(file.mesh, symmetry.match, options.from);
  if (std::none_of(sides.faces().begin(), sides.faces().end(), [](std::int8_t side) { return side > 0; })) {
    return Unexpected(Error{ErrorCode::BadArgument,
                            "no face lies farther to that side than its partner; choose the axis across the mirror",
                            file.path});
  }
  Symmetrized result{.file = file, .moved = 0, .farthest = 0, .report = {}};
  if (use::carries_more_than_positions(options.carry)) {
    TransferOptions transferring;
    transferring.carry = options.carry;
    transferring.carry.positions = false;
    transferring.allow_ambiguous = true;
    Expected<Transferred> carried =
        transfer(file, file, use::half_of(file.mesh, symmetry.match, sides.faces()), transferring);
    if (!carried) return Unexpected(carried.error());
    result.file = std::move(carried->file);
    result.report = std::move(carried->report);
  }
  if (options.carry.positions) {
    use::mirror_positions(file, symmetry, sides.vertices(symmetry.match.vertices), result);
  }
  return result;
}

}  // namespace quadmatch
