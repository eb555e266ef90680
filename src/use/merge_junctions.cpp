#include "merge_junctions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <quadmatch/mesh/disjoint_sets.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

class Finder {
 public:
  Finder(const ThreeMeshes& meshes, const Cells& cells, Side preferred)
      : meshes_(meshes), cells_(cells), preferred_(preferred), areas_(0) {
    std::uint32_t vertices = 0;
    for (const Side side : kSides) {
      first_key_[static_cast<std::size_t>(side)] = vertices;
      vertices += mesh_of(meshes, side).vertex_count();
    }
    keys_ = vertices;
  }

  Junctions run() {
    gather();
    for (const auto& [side, flag] : {std::pair(Side::Ours, &Junction::by_ours), {Side::Theirs, &Junction::by_theirs}}) {
      mark_differences(Side::Base, side, flag);
    }
    mark_differences(Side::Ours, Side::Theirs, &Junction::differs);
    find_areas();
    decide();
    while (find_new_meetings()) decide();
    number_areas();
    return std::move(found_);
  }

 private:
  /// The vertex at a corner, as a number of its own among the vertices of all three; kNone where the mesh has no such
  /// cell.
  [[nodiscard]] std::uint32_t key(std::uint32_t corner, Side side) const {
    const HalfedgeId h = cells_.corners[corner][side];
    if (!h.valid()) return kNone;
    return first_key_[static_cast<std::size_t>(side)] + mesh_of(meshes_, side).origin(h).value;
  }

  void gather() {
    DisjointSets sets(keys_);
    for (std::uint32_t c = 0; c < cells_.corners.size(); ++c) {
      std::uint32_t last = kNone;
      for (const Side side : kSides) {
        const std::uint32_t here = key(c, side);
        if (here != kNone && last != kNone) sets.join(here, last);
        if (here != kNone) last = here;
      }
    }
    std::vector<std::uint32_t> number(keys_, kNone);
    found_.of_corner.reserve(cells_.corners.size());
    for (std::uint32_t c = 0; c < cells_.corners.size(); ++c) {
      std::uint32_t any = kNone;
      for (const Side side : kSides) any = std::min(any, key(c, side));
      std::uint32_t& junction = number[sets.find(any)];
      if (junction == kNone) {
        junction = static_cast<std::uint32_t>(found_.list.size());
        found_.list.emplace_back();
      }
      found_.of_corner.push_back(junction);
    }
  }

  /// A junction is the same in two meshes if the same corners are there, joined in the same way: the vertices at them
  /// correspond one to one.
  void mark_differences(Side one, Side another, bool Junction::*flag) {
    std::vector<std::uint32_t> partner(keys_, kNone);
    for (std::uint32_t c = 0; c < cells_.corners.size(); ++c) {
      const std::uint32_t a = key(c, one), b = key(c, another);
      if (a == kNone && b == kNone) continue;
      bool same = a != kNone && b != kNone;
      if (same) {
        if (partner[a] == kNone) partner[a] = b;
        if (partner[b] == kNone) partner[b] = a;
        same = partner[a] == b && partner[b] == a;
      }
      if (!same) found_.list[found_.of_corner[c]].*flag = true;
    }
  }

  /// An edit is what one side changed at junctions that share faces, one after the other.
  void find_areas() {
    areas_ = DisjointSets(static_cast<std::uint32_t>(found_.list.size()));
    for (std::size_t cell = 0; cell < cells_.faces.size(); ++cell) {
      for (const Side side : {Side::Ours, Side::Theirs}) {
        std::uint32_t first = kNone;
        for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
          if (!found_.at(c).by(side)) continue;
          if (first == kNone) first = found_.of_corner[c];
          areas_.join(first, found_.of_corner[c]);
        }
      }
    }
    for (std::uint32_t j = 0; j < found_.list.size(); ++j) {
      const Junction& junction = found_.list[j];
      if (junction.by_ours && junction.by_theirs && junction.differs) conflicts_.push_back(j);
    }
  }

  void decide() {
    std::vector<std::uint8_t> in_conflict(found_.list.size(), 0);
    for (const std::uint32_t j : conflicts_) in_conflict[areas_.find(j)] = 1;
    for (std::uint32_t j = 0; j < found_.list.size(); ++j) {
      Junction& junction = found_.list[j];
      junction.area = in_conflict[areas_.find(j)] != 0 ? areas_.find(j) : Junction::kNoArea;
      junction.decides = junction.in_conflict()                    ? preferred_
                         : junction.by_theirs && !junction.by_ours ? Side::Theirs
                                                                   : Side::Ours;
    }
  }

  /// Is there a junction among those of a cell that follows this side because it alone changed it?
  [[nodiscard]] bool is_changed(std::uint32_t corner, Side side) const {
    const Junction& junction = found_.at(corner);
    return !junction.in_conflict() && junction.by(side) && !junction.by(other(side));
  }

  [[nodiscard]] std::uint32_t vertex_key(std::uint32_t corner) const { return key(corner, found_.at(corner).decides); }

  /// Cells between changes of both sides, where such a meeting may be.
  [[nodiscard]] std::vector<std::uint32_t> cells_between() const {
    std::vector<std::uint32_t> between;
    for (std::uint32_t cell = 0; cell + 1 < cells_.first_corner.size(); ++cell) {
      bool ours = false, theirs = false;
      for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
        ours = ours || is_changed(c, Side::Ours);
        theirs = theirs || is_changed(c, Side::Theirs);
      }
      if (ours && theirs) between.push_back(cell);
    }
    return between;
  }

  /// Two corners of a cell, each with one of another cell at the same vertex of the result.
  struct Shared {
    std::uint32_t cell, own, others;
  };

  /// Two faces that meet in a vertex only because OURS joined them there, and in another only because THEIRS did, meet
  /// as in no mesh: an edge of too many faces, or two faces laid on each other.
  bool find_new_meetings() {
    const std::vector<std::uint32_t> between = cells_between();
    if (between.empty()) return false;
    const std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> at_vertex = corners_near(between);
    bool any = false;
    for (const std::uint32_t cell : between) {
      std::vector<Shared> shared;
      for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
        for (const auto& [there, corner] : at_vertex[place_[vertex_key(c)]]) {
          if (there != cell) shared.push_back({there, c, corner});
        }
      }
      std::stable_sort(shared.begin(), shared.end(), [](const Shared& a, const Shared& b) { return a.cell < b.cell; });
      any = join_new(shared) || any;
    }
    return any;
  }

  /// The corners at each vertex of the result that one of these cells has.
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> corners_near(
      const std::vector<std::uint32_t>& between) {
    place_.assign(keys_, kNone);
    std::uint32_t count = 0;
    for (const std::uint32_t cell : between) {
      for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
        if (place_[vertex_key(c)] == kNone) place_[vertex_key(c)] = count++;
      }
    }
    std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> at_vertex(count);
    for (std::uint32_t cell = 0; cell + 1 < cells_.first_corner.size(); ++cell) {
      if (!is_present(cells_, found_, cell)) continue;
      for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
        const std::uint32_t place = place_[vertex_key(c)];
        if (place != kNone) at_vertex[place].emplace_back(cell, c);
      }
    }
    return at_vertex;
  }

  [[nodiscard]] bool joined_only_by(Side side, const Shared& shared) const {
    return is_changed(shared.own, side) && key(shared.own, other(side)) != key(shared.others, other(side));
  }

  bool join_new(const std::vector<Shared>& shared) {
    bool any = false;
    for (std::size_t a = 0; a < shared.size(); ++a) {
      for (std::size_t b = 0; b < shared.size() && joined_only_by(Side::Ours, shared[a]); ++b) {
        if (shared[a].cell != shared[b].cell || !joined_only_by(Side::Theirs, shared[b])) continue;
        areas_.join(found_.of_corner[shared[a].own], found_.of_corner[shared[b].own]);
        conflicts_.push_back(found_.of_corner[shared[a].own]);
        any = true;
      }
    }
    return any;
  }

  void number_areas() {
    std::vector<std::uint32_t> number(found_.list.size(), kNone);
    for (Junction& junction : found_.list) {
      if (!junction.in_conflict()) continue;
      if (number[junction.area] == kNone) number[junction.area] = found_.areas++;
      junction.area = number[junction.area];
    }
  }

  const ThreeMeshes& meshes_;
  const Cells& cells_;
  Side preferred_;
  std::array<std::uint32_t, 3> first_key_ = {};
  std::uint32_t keys_ = 0;
  Junctions found_;
  DisjointSets areas_;
  std::vector<std::uint32_t> conflicts_;  ///< junctions
  std::vector<std::uint32_t> place_;      ///< of a vertex in what `corners_near` gives
};

}  // namespace

Junctions find_junctions(const ThreeMeshes& meshes, const Cells& cells, Side preferred) {
  return Finder(meshes, cells, preferred).run();
}

bool is_present(const Cells& cells, const Junctions& junctions, std::uint32_t cell) {
  const InThree<FaceId>& faces = cells.faces[cell];
  if (faces[Side::Ours].valid() == faces[Side::Theirs].valid()) return faces[Side::Ours].valid();
  return faces[junctions.at(cells.first_corner[cell]).decides].valid();
}

}  // namespace quadmatch::use
