#include "certain_rows.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace quadmatch::use {
namespace {

/// A row of quads: the side to the same hand of each.
struct Row {
  std::vector<HalfedgeId> sides;
  bool closed = false;
  bool straight = true;  ///< closed, or from boundary to boundary: what an edit can take out
};

class Rows {
 public:
  Rows(const Mesh& source, const Match& match, PerFace<std::uint8_t>& certain)
      : mesh_(source),
        certain_(certain),
        is_matched_(source.face_count(), 0),
        is_seen_(source.halfedge_count(), 0),
        is_beside_(source.halfedge_count(), 0) {
    for (const Region& region : match.regions) {
      for (const FacePair& pair : region.faces) is_matched_[pair.source] = 1;
    }
  }

  void mark() {
    for (std::uint32_t h = 0; h < mesh_.halfedge_count(); ++h) {
      const HalfedgeId side(h);
      if (is_seen_[side] == 0 && is_beside_gone(side)) look_at(side);
    }
  }

 private:
  [[nodiscard]] bool is_beside_gone(HalfedgeId side) const {
    const HalfedgeId beside = mesh_.twin(side);
    return is_matched_[mesh_.face(side)] != 0 && beside.valid() && is_matched_[mesh_.face(beside)] == 0 &&
           mesh_.size(mesh_.face(side)) == 4 && mesh_.size(mesh_.face(beside)) == 4;
  }

  void look_at(HalfedgeId side) {
    const Row gone = row_of(mesh_.twin(side)), row = row_of(side);
    const bool all_gone = gone.straight && std::all_of(gone.sides.begin(), gone.sides.end(),
                                                       [&](HalfedgeId s) { return is_matched_[mesh_.face(s)] == 0; });
    for (const HalfedgeId s : gone.sides) is_beside_[s] = 1;
    const auto is_beside = [&](HalfedgeId s) { return mesh_.twin(s).valid() && is_beside_[mesh_.twin(s)] != 0; };
    const bool could_be_meant = row.straight && row.closed == gone.closed && row.sides.size() == gone.sides.size() &&
                                std::all_of(row.sides.begin(), row.sides.end(), is_beside);
    for (const HalfedgeId s : row.sides) {
      if (!is_beside(s) || !is_beside_gone(s)) continue;
      is_seen_[s] = 1;
      if (all_gone && !could_be_meant) certain_[mesh_.face(s)] = 1;
    }
    for (const HalfedgeId s : gone.sides) is_beside_[s] = 0;
  }

  /// The row that goes on past the sides before and after this one.
  [[nodiscard]] Row row_of(HalfedgeId side) const {
    Row row{{side}};
    const auto walk = [&](auto across, auto along) {
      for (HalfedgeId here = side; row.sides.size() <= mesh_.halfedge_count();) {
        const HalfedgeId beyond = mesh_.twin((mesh_.*across)(here));
        if (!beyond.valid()) return;
        row.straight = row.straight && mesh_.size(mesh_.face(beyond)) == 4;
        if (mesh_.size(mesh_.face(beyond)) != 4) return;
        here = (mesh_.*along)(beyond);
        row.closed = here == side;
        if (row.closed) return;
        row.sides.push_back(here);
      }
    };
    walk(&Mesh::next, &Mesh::next);
    if (!row.closed) walk(&Mesh::prev, &Mesh::prev);
    return row;
  }

  const Mesh& mesh_;
  PerFace<std::uint8_t>& certain_;
  PerFace<std::uint8_t> is_matched_;
  PerHalfedge<std::uint8_t> is_seen_;
  PerHalfedge<std::uint8_t> is_beside_;  // of the row that is looked at
};

}  // namespace

void mark_certain_rows(const Mesh& source, const Match& match, PerFace<std::uint8_t>& certain) {
  Rows(source, match, certain).mark();
}

}  // namespace quadmatch::use
