#include "junctions.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <quadmatch/mesh/disjoint_sets.hpp>

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
    key_count_ = vertices;
    keys_.reserve(cells.corners.size());
    for (const InThree<HalfedgeId>& corner : cells.corners) {
      keys_.push_back({key(corner, Side::Base), key(corner, Side::Ours), key(corner, Side::Theirs)});
    }
  }

  Junctions run() {
    gather();
    for (const auto& [side, flag] : {std::pair(Side::Ours, &Junction::by_ours), {Side::Theirs, &Junction::by_theirs}}) {
      mark_differences(Side::Base, side, flag);
    }
    mark_differences(Side::Ours, Side::Theirs, &Junction::differs);
    find_areas();
    decide();
    number_areas();
    return std::move(found_);
  }

 private:
  using Keys = std::array<std::uint32_t, 3>;

  /// The vertex at a corner, as a number of its own among the vertices of all three; kNone where the mesh has no such
  /// cell.
  [[nodiscard]] std::uint32_t key(const InThree<HalfedgeId>& corner, Side side) const {
    const HalfedgeId h = corner[side];
    if (!h.valid()) return kNone;
    return first_key_[static_cast<std::size_t>(side)] + mesh_of(meshes_, side).origin(h).value;
  }

  void gather() {
    DisjointSets sets(key_count_);
    std::vector<std::uint32_t> joined(key_count_, kNone);  // what a vertex was joined to last: mostly to the same
    for (const Keys& corner : keys_) {
      std::uint32_t last = kNone;
      for (const std::uint32_t here : corner) {
        if (here == kNone) continue;
        if (last != kNone && joined[here] != last) sets.join(here, last);
        joined[here] = last;
        last = here;
      }
    }
    std::vector<std::uint32_t> number(key_count_, kNone);
    found_.of_corner.reserve(keys_.size());
    for (const Keys& corner : keys_) {
      const std::uint32_t any = *std::min_element(corner.begin(), corner.end());
      if (number[any] == kNone) {  // else the vertex was met before
        std::uint32_t& junction = number[sets.find(any)];
        if (junction == kNone) {
          junction = static_cast<std::uint32_t>(found_.list.size());
          found_.list.emplace_back();
        }
        number[any] = junction;
      }
      found_.of_corner.push_back(number[any]);
    }
  }

  /// A junction is the same in two meshes if the same corners are there, joined in the same way: the vertices at them
  /// correspond one to one.
  void mark_differences(Side one, Side another, bool Junction::*flag) {
    std::vector<std::uint32_t> partner(key_count_, kNone);
    for (std::size_t c = 0; c < keys_.size(); ++c) {
      const std::uint32_t a = keys_[c][static_cast<std::size_t>(one)], b = keys_[c][static_cast<std::size_t>(another)];
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

  /// Is it other than in the base on this side, and not the same on the other?
  [[nodiscard]] bool is_own_change(std::uint32_t corner, Side side) const {
    const Junction& junction = found_.at(corner);
    return junction.by(side) && (junction.differs || !junction.by(other(side)));
  }

  /// @param[in,out] first  a junction of the edit, if there is one already.
  void join_edit(std::uint32_t& first, std::uint32_t junction) {
    if (first == kNone) first = junction;
    areas_.join(first, junction);
  }

  /// An edit is what one side changed at junctions that share faces, one after the other; edits that share a face meet.
  void find_areas() {
    areas_ = DisjointSets(static_cast<std::uint32_t>(found_.list.size()));
    for (std::size_t cell = 0; cell < cells_.faces.size(); ++cell) {
      std::uint32_t first_ours = kNone, first_theirs = kNone;
      for (std::uint32_t c = cells_.first_corner[cell]; c < cells_.first_corner[cell + 1]; ++c) {
        if (is_own_change(c, Side::Ours)) join_edit(first_ours, found_.of_corner[c]);
        if (is_own_change(c, Side::Theirs)) join_edit(first_theirs, found_.of_corner[c]);
      }
      if (first_ours == kNone || first_theirs == kNone) continue;
      areas_.join(first_ours, first_theirs);
      conflicts_.push_back(first_ours);
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
  std::uint32_t key_count_ = 0;
  std::vector<Keys> keys_;  ///< of each corner
  Junctions found_;
  DisjointSets areas_;
  std::vector<std::uint32_t> conflicts_;  ///< junctions
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
