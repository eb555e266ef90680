// Cells, junctions, layout: then there is a mesh. After it, data by data, whose value each element has.

#include <quadmatch/use/merge.hpp>

#include <algorithm>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/verify/verify.hpp>

#include "../data/scalar_types.hpp"
#include "../data/texture_lists.hpp"
#include "positions.hpp"
#include "records.hpp"
#include "report.hpp"

namespace quadmatch {
namespace use {
namespace {

/// The positions of vertices of no face, in a certain order.
std::vector<Point> unused_vertices(const Mesh& mesh) {
  PerVertex<std::uint8_t> used(mesh.vertex_count(), 0);
  for (const VertexId v : mesh.corners()) used[v] = 1;
  std::vector<Point> points;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
    if (used[VertexId(v)] == 0) points.push_back(mesh.positions().empty() ? Point{} : mesh.positions()[v]);
  }
  std::sort(points.begin(), points.end());
  return points;
}

class Merger {
 public:
  Merger(const ThreeFiles& files, const Match& to_ours, const Match& to_theirs, Side preferred)
      : files_(files),
        to_ours_(to_ours),
        to_theirs_(to_theirs),
        preferred_(preferred),
        meshes_{&files[0]->mesh, &files[1]->mesh, &files[2]->mesh},
        cells_(lay_cells(meshes_, to_ours, to_theirs)),
        junctions_(find_junctions(meshes_, cells_, preferred)),
        layout_(lay_out(meshes_, cells_, junctions_)) {
    for (const Side side : {Side::Ours, Side::Theirs}) {
      changes_[static_cast<std::size_t>(side)] = changes_of(meshes_, cells_, junctions_, side);
    }
  }

  Expected<Merged> run() {
    std::vector<Origin> faces;
    for (const std::uint32_t cell : layout_.cells) faces.push_back(face_origin(cell));
    const MergedRecords records(files_, faces, preferred_, tally_);
    put_in_order(records.order());
    gather_origins();
    start(records);
    if (Expected<void> built = build(); !built) return Unexpected(built.error());
    merge_data();
    report();
    return std::move(merged_);
  }

  /// Is the side the base, as far as a merge can tell? After `run`.
  [[nodiscard]] bool is_unchanged(Side side) const {
    const SideChanges& changes = changes_[static_cast<std::size_t>(side)];
    return !changes.connectivity() && changes.moved_vertices == 0 && !changed_data_[static_cast<std::size_t>(side)] &&
           unused_vertices(mesh_of(meshes_, Side::Base)) == unused_vertices(mesh_of(meshes_, side));
  }

 private:
  [[nodiscard]] Origin face_origin(std::uint32_t cell) const {
    bool inside = true;  // of a conflict, with all its corners
    for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
      inside = inside && junctions_.at(c).in_conflict();
    }
    return origin_of(cells_.faces[cell], inside, preferred_);
  }

  void put_in_order(const std::vector<std::uint32_t>& order) {
    std::vector<std::uint32_t> ordered;
    for (const std::uint32_t face : order) ordered.push_back(layout_.cells[face]);
    layout_.cells = std::move(ordered);
  }

  void gather_origins() {
    for (const MergedVertex& vertex : layout_.vertices) {
      const bool only = vertex.junction != MergedVertex::kNoJunction && junctions_.list[vertex.junction].in_conflict();
      origins_.vertices.push_back(origin_of(vertex.in, only, vertex.side));
      merged_.vertex_origins.push_back(vertex.in);
    }
    for (const std::uint32_t cell : layout_.cells) {
      origins_.faces.push_back(face_origin(cell));
      merged_.face_origins.push_back(cells_.faces[cell]);
      const bool only = origins_.faces.back().in != origin_of(cells_.faces[cell], false, preferred_).in;
      for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
        origins_.corners.push_back(origin_of(cells_.corners[c], only, preferred_));
      }
    }
  }

  /// What is not merged element by element.
  void start(const MergedRecords& records) {
    const MeshFile& ours = file_of(files_, Side::Ours);
    result_.format = ours.format;
    result_.path = ours.path;
    result_.position_type = ours.position_type;
    result_.face_records = records.records();
    result_.comments = ours.comments;
    result_.notes = ours.notes;
    const ScalarType theirs = file_of(files_, Side::Theirs).position_type;
    if (theirs != ours.position_type) result_.position_type = holding_both(ours.position_type, theirs);
  }

  Expected<void> build() {
    PolygonSoup soup = soup_of(meshes_, cells_, junctions_, layout_);
    MergedPositions positions = merge_positions(files_, cells_, junctions_, layout_, origins_, preferred_, tally_);
    soup.positions = std::move(positions.points);
    merged_.report.carried_along = positions.carried_along;
    Expected<Mesh> mesh = Mesh::build(std::move(soup));
    if (!mesh) return Unexpected(mesh.error());
    result_.mesh = *std::move(mesh);
    return {};
  }

  void merge_data() {
    const std::array<const Property*, 3> lists{find_texture_list(*files_[0]), find_texture_list(*files_[1]),
                                               find_texture_list(*files_[2])};
    NewNumbers numbers{layout_, face_places(Side::Ours), face_places(Side::Theirs), {}};
    result_.texture_coordinates = merged_pool(
        "texture coordinates",
        {texture_coordinates_of(*files_[0]), texture_coordinates_of(*files_[1]), texture_coordinates_of(*files_[2])},
        &numbers);
    result_.normals = merged_pool("normals", {files_[0]->normals, files_[1]->normals, files_[2]->normals}, nullptr);
    result_.properties = merge_properties(files_, lists, origins_, preferred_, tally_);
    write_texture_list(lists);
    merge_carried(files_, numbers, result_, tally_);
  }

  std::optional<IndexedAttribute> merged_pool(const char* name,
                                              const std::array<std::optional<IndexedAttribute>, 3>& pools,
                                              NewNumbers* numbers) {
    if (!pools[1] && !pools[2]) {
      if (pools[0]) tally_.enter_remark(name, Domain::Corner, "both sides dropped them");
      tally_.ours_changed = tally_.ours_changed || pools[0];
      tally_.theirs_changed = tally_.theirs_changed || pools[0];
      return std::nullopt;
    }
    const auto pointer = [&](std::size_t k) { return pools[k] ? &*pools[k] : nullptr; };
    MergedPool merged = merge_pools(name, {pointer(0), pointer(1), pointer(2)}, origins_.corners, preferred_, tally_);
    if (numbers != nullptr) numbers->texture = std::move(merged.places);
    const std::vector<std::uint32_t>& indices = merged.attribute.corner_index;
    const bool any = std::any_of(indices.begin(), indices.end(),
                                 [](std::uint32_t index) { return index != IndexedAttribute::kNoIndex; });
    if (!any && !(pools[1] && pools[2])) return std::nullopt;  // a side dropped them, and the other made none
    return std::move(merged.attribute);
  }

  /// A list of PLY's again, where OURS has it.
  void write_texture_list(const std::array<const Property*, 3>& lists) {
    const Property* const like = lists[1] != nullptr ? lists[1] : lists[2];
    if (like == nullptr || !result_.texture_coordinates) return;
    const Property* const first = file_of(files_, Side::Ours).properties.data();
    const std::size_t place = like == lists[1] ? static_cast<std::size_t>(like - first) : result_.properties.size();
    const auto at =
        result_.properties.begin() + static_cast<std::ptrdiff_t>(std::min(place, result_.properties.size()));
    result_.properties.insert(at, texture_list_of(result_.mesh, *result_.texture_coordinates, *like));
  }

  /// Where the faces of a side are now; those that are gone where the next one is.
  [[nodiscard]] std::vector<std::uint32_t> face_places(Side side) const {
    constexpr std::uint32_t kGone = Origin::kNowhere;
    const auto end = static_cast<std::uint32_t>(layout_.cells.size());
    std::vector<std::uint32_t> places(mesh_of(meshes_, side).face_count() + std::size_t{1}, kGone);
    for (std::uint32_t place = 0; place < end; ++place) {
      const FaceId f = cells_.faces[layout_.cells[place]][side];
      if (f.valid()) places[f.value] = place;
    }
    places.back() = end;
    for (std::size_t f = places.size() - 1; f > 0; --f) {
      if (places[f - 1] == kGone) places[f - 1] = places[f];
    }
    return places;
  }

  void report() {
    MergeReport& report = merged_.report;
    report.ours = changes_[1];
    report.theirs = changes_[2];
    report.same_added_faces = cells_.same_added;
    report.areas = conflict_areas(meshes_, cells_, junctions_, layout_, result_.mesh);
    report.doubtful = doubtful_parts(meshes_, cells_, junctions_, Side::Ours, to_ours_);
    for (DoubtfulPart& part : doubtful_parts(meshes_, cells_, junctions_, Side::Theirs, to_theirs_)) {
      report.doubtful.push_back(part);
    }
    report.new_departures = new_departures(meshes_, result_.mesh);
    changed_data_ = {false, tally_.ours_changed, tally_.theirs_changed};
    report.values = std::move(tally_.conflicts);
    report.attributes = std::move(tally_.attributes);
  }

  ThreeFiles files_;
  const Match& to_ours_;
  const Match& to_theirs_;
  Side preferred_;
  ThreeMeshes meshes_;
  Cells cells_;
  Junctions junctions_;
  Layout layout_;
  Origins origins_;
  ValueTally tally_;
  std::array<SideChanges, 3> changes_ = {};
  std::array<bool, 3> changed_data_ = {};
  Merged merged_{.file = {.mesh = *Mesh::build({})}, .face_origins = {}, .vertex_origins = {}, .report = {}};
  MeshFile& result_ = merged_.file;
};

template <class Id>
void swap_sides(std::vector<InThree<Id>>& origins) {
  for (InThree<Id>& origin : origins) std::swap(origin[Side::Ours], origin[Side::Theirs]);
}

/// A merge with OURS and THEIRS in each other's place, told the right way round. @pre one of them is unchanged.
void swap_sides(Merged& merged) {
  swap_sides(merged.face_origins);
  swap_sides(merged.vertex_origins);
  MergeReport& report = merged.report;
  std::swap(report.ours, report.theirs);
  for (MergedAttribute& attribute : report.attributes) std::swap(attribute.from_ours, attribute.from_theirs);
  for (DoubtfulPart& part : report.doubtful) part.side = other(part.side);
}

Expected<void> check_match(const MeshFile& base, const MeshFile& side, const Match& match) {
  const Verdict verdict = verify(base.mesh, side.mesh, match, 1);
  if (verdict.sound()) return {};
  return Unexpected(Error{
      ErrorCode::MatchDoesNotFit,
      fmt::format("the match is not sound for these meshes: {}; match them again", verdict.faults.front().message),
      side.path});
}

/// There is nothing to merge by.
Unexpected<Error> nothing_in_common(const MeshFile& base, const MeshFile& side) {
  return Unexpected(Error{
      ErrorCode::BadArgument,
      fmt::format("it has no part in common with {}, so there is nothing to merge by; name the mesh that both sides "
                  "were made from",
                  base.path == "-" ? "standard input" : base.path),
      side.path});
}

}  // namespace
}  // namespace use

Expected<Merged> merge(const MeshFile& base, const MeshFile& ours, const MeshFile& theirs, const Match& to_ours,
                       const Match& to_theirs, const MergeOptions& options) {
  if (Expected<void> sound = use::check_match(base, ours, to_ours); !sound) return Unexpected(sound.error());
  if (Expected<void> sound = use::check_match(base, theirs, to_theirs); !sound) return Unexpected(sound.error());

  use::Merger merger({&base, &ours, &theirs}, to_ours, to_theirs, options.prefer);
  Expected<Merged> merged = merger.run();
  if (!merged) return merged;
  if (merger.is_unchanged(Side::Theirs)) {
    merged->file = ours;
    return merged;
  }
  if (merger.is_unchanged(Side::Ours)) {
    merged = use::Merger({&base, &theirs, &ours}, to_theirs, to_ours, options.prefer).run();
    if (!merged) return merged;
    use::swap_sides(*merged);
    merged->file = theirs;
    return merged;
  }
  const MergeReport& report = merged->report;
  if (report.ours.connectivity() && report.theirs.connectivity()) {
    if (report.ours.matched_faces == 0) return use::nothing_in_common(base, ours);
    if (report.theirs.matched_faces == 0) return use::nothing_in_common(base, theirs);
  }
  return merged;
}

}  // namespace quadmatch
