#include "rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <unordered_set>
#include <utility>

namespace quadmatch::use {
namespace {

/// Of so many faces that came, one may be something else that happened beside the rows.
constexpr std::size_t kOneStrayOf = 10;
/// A flat patch has four corners more of one kind than of the other. Irregular lines have as many as three by chance.
constexpr std::int64_t kMostTurns = 3;
/// A patch with poles in it has fewer, and is told by how often its rim turns either way.
constexpr std::int64_t kOneCornerOf = 4;
/// Where positions and corners do not tell which row is the old one, the match slides from one row to the next and
/// back: so many rows to either side.
constexpr std::uint32_t kReach = 3;
/// A chord is a row only if one of so many of its own quads came.
constexpr std::size_t kOneOwnOf = 3;

/// In widths of a new row: how near the old boundary has to be.
constexpr double kAtOldBoundary = 0.1;

/// A poly-chord: the half-edges by which it enters its quads, one after the other.
struct Chord {
  std::vector<HalfedgeId> entries;
  bool ends_at_polygon = false;  ///< an edge loop would have split that too
};

/// Both lines beside a chord. The left one is on the way from the entry's origin.
enum class Flank { Left, Right };

class RowCount {
 public:
  explicit RowCount(const Scene& scene) : scene_(scene), mesh_(*scene.after->mesh) {
    for (const FaceId f : scene.faces_after) came_.insert(f.value);
    uncovered_ = came_;
  }

  std::uint32_t run() {
    for (const FaceId f : scene_.faces_after) {
      if (mesh_.size(f) != 4) continue;
      for (std::uint32_t k = 0; k < 2; ++k) add_candidate(HalfedgeId(mesh_.first(f).value + k));
    }
    accept_best();
    note_rungs();
    if (accepted_ == 0 || uncovered_.size() > came_.size() / kOneStrayOf ||
        std::any_of(candidates_.begin(), candidates_.end(),
                    [&](const Candidate& c) { return c.is_sure() && turns_corners(c.chord); })) {
      return 0;
    }
    const double more = static_cast<double>(came_.size()) - static_cast<double>(scene_.faces_before.size());
    return std::max(1U, static_cast<std::uint32_t>(std::lround(more * accepted_ / static_cast<double>(length_))));
  }

 private:
  [[nodiscard]] bool came(FaceId f) const { return came_.contains(f.value); }

  /// The chord that enters a quad across a half-edge; marks it as walked.
  Chord walk(HalfedgeId start) {
    Chord chord;
    if (const bool closed = go_on(start, chord.entries, chord.ends_at_polygon); closed) return chord;
    std::vector<HalfedgeId> behind;
    if (const HalfedgeId other = mesh_.twin(start); other.valid()) {
      if (mesh_.size(mesh_.face(other)) == 4) {
        go_on(other, behind, chord.ends_at_polygon);
      } else {
        chord.ends_at_polygon = true;
      }
    }
    // Backwards it entered where it leaves forwards.
    for (HalfedgeId& h : behind) h = opposite(h);
    std::reverse(behind.begin(), behind.end());
    chord.entries.insert(chord.entries.begin(), behind.begin(), behind.end());
    return chord;
  }

  /// Straight on from an entry, to the end or round to it again; true where it closes.
  bool go_on(HalfedgeId start, std::vector<HalfedgeId>& entries, bool& ends_at_polygon) {
    HalfedgeId entry = start;
    do {
      walked_.insert(std::min(entry, opposite(entry)).value);
      entries.push_back(entry);
      const HalfedgeId beyond = mesh_.twin(opposite(entry));
      if (!beyond.valid()) return false;
      if (mesh_.size(mesh_.face(beyond)) != 4) {
        ends_at_polygon = true;
        return false;
      }
      entry = beyond;
    } while (entry != start);
    return true;
  }

  [[nodiscard]] HalfedgeId opposite(HalfedgeId h) const { return mesh_.next(mesh_.next(h)); }

  /// The side of a chord's quad on one flank.
  [[nodiscard]] HalfedgeId flank_side(HalfedgeId entry, Flank flank) const {
    return flank == Flank::Left ? mesh_.prev(entry) : mesh_.next(entry);
  }

  /// The nearest face that came, on one flank of a quad of a chord.
  [[nodiscard]] std::optional<FaceId> newcomer_beside(HalfedgeId entry, Flank flank) const {
    HalfedgeId side = flank == Flank::Left ? mesh_.prev(entry) : mesh_.next(entry);
    for (std::uint32_t steps = 0; steps < kReach; ++steps) {
      const HalfedgeId other = mesh_.twin(side);
      if (!other.valid()) break;
      const FaceId beside = mesh_.face(other);
      if (came(beside)) return beside;
      if (mesh_.size(beside) != 4) break;
      side = opposite(other);
    }
    return std::nullopt;
  }

  /// A chord, and how many of its quads came.
  struct Candidate {
    Chord chord;
    std::size_t own = 0;
    bool accepted = false;

    /// A row that came, not one beside it.
    [[nodiscard]] bool is_sure() const { return accepted || own == chord.entries.size(); }
  };

  void add_candidate(HalfedgeId start) {
    if (walked_.contains(std::min(start, opposite(start)).value)) return;
    Candidate candidate{walk(start)};
    const std::vector<HalfedgeId>& entries = candidate.chord.entries;
    candidate.own = static_cast<std::size_t>(
        std::count_if(entries.begin(), entries.end(), [&](HalfedgeId entry) { return came(mesh_.face(entry)); }));
    if (candidate.chord.ends_at_polygon || kOneOwnOf * candidate.own < entries.size() || !is_row(candidate.chord))
      return;
    candidates_.push_back(std::move(candidate));
  }

  /// Those of which the largest share came, first: beside them, others have nothing left to explain.
  void accept_best() {
    std::stable_sort(candidates_.begin(), candidates_.end(), [](const Candidate& a, const Candidate& b) {
      return a.own * b.chord.entries.size() > b.own * a.chord.entries.size();
    });
    for (Candidate& candidate : candidates_) {
      const std::vector<HalfedgeId>& entries = candidate.chord.entries;
      const auto left = static_cast<std::size_t>(std::count_if(entries.begin(), entries.end(), [&](HalfedgeId entry) {
        return uncovered_.contains(mesh_.face(entry).value);
      }));
      if (kOneOwnOf * left >= entries.size()) accept(candidate);
    }
  }

  /// Did almost each of its quads come, or one beside it?
  [[nodiscard]] bool is_row(const Chord& chord) const {
    const auto without = std::count_if(chord.entries.begin(), chord.entries.end(), [&](HalfedgeId entry) {
      return !came(mesh_.face(entry)) && !newcomer_beside(entry, Flank::Left) && !newcomer_beside(entry, Flank::Right);
    });
    return static_cast<std::size_t>(without) <= chord.entries.size() / kOneStrayOf;
  }

  void accept(Candidate& candidate) {
    candidate.accepted = true;
    ++accepted_;
    length_ += candidate.chord.entries.size();
    for (const HalfedgeId entry : candidate.chord.entries) {
      uncovered_.erase(mesh_.face(entry).value);
      // Where none of the halves was matched, the other one came as well.
      for (const Flank flank : {Flank::Left, Flank::Right}) {
        if (const std::optional<FaceId> beside = newcomer_beside(entry, flank)) uncovered_.erase(beside->value);
      }
    }
  }

  void note_rungs() {
    for (const Candidate& candidate : candidates_) {
      if (!candidate.is_sure()) continue;
      for (const HalfedgeId entry : candidate.chord.entries) {
        rungs_.insert(mesh_.edge(entry).value);
        rungs_.insert(mesh_.edge(opposite(entry)).value);
      }
    }
  }

  [[nodiscard]] std::int64_t excess(HalfedgeId corner) const {
    const FanId fan = mesh_.fan(corner);
    return static_cast<std::int64_t>(mesh_.valence(fan)) - (mesh_.is_boundary(fan) ? 3 : 4);
  }

  /// From the tip of a rung straight on over rungs, to the first vertex that is not regular or the last one.
  [[nodiscard]] std::int64_t excess_across(HalfedgeId rung) const {
    // Rows that close to a ring the other way have no last vertex.
    for (std::size_t steps = 0; steps < rungs_.size(); ++steps) {
      const HalfedgeId flank = mesh_.next(rung);
      if (excess(flank) != 0) return excess(flank);
      const HalfedgeId over = mesh_.twin(flank);
      if (!over.valid() || !rungs_.contains(mesh_.edge(mesh_.next(over)).value)) return 0;
      rung = mesh_.next(over);
    }
    return 0;
  }

  /// Does the vertex that a rung leaves lack an edge, and has the one at its other end one too much?
  [[nodiscard]] bool is_corner(HalfedgeId rung) const { return excess(rung) < 0 && excess_across(rung) > 0; }

  /// A wall around a patch is a row too, but turns where the patch has corners: the vertex above lacks a quad, and the
  /// one below has one too much. All round a patch it turns one way; a row beside irregular lines may have such places
  /// too, on either flank.
  [[nodiscard]] bool turns_corners(const Chord& chord) const {
    std::int64_t turns = 0, corners = 0;
    for (const HalfedgeId entry : chord.entries) {
      const int left = is_corner(entry) ? 1 : 0, right = is_corner(opposite(entry)) ? 1 : 0;
      turns += left - right;
      corners += left + right;
    }
    return std::abs(turns) > kMostTurns ||
           (corners > kMostTurns && kOneCornerOf * corners >= static_cast<std::int64_t>(chord.entries.size()));
  }

  const Scene& scene_;
  const Mesh& mesh_;
  std::unordered_set<std::uint32_t> came_, uncovered_, walked_, rungs_;
  std::vector<Candidate> candidates_;
  std::uint32_t accepted_ = 0;
  std::size_t length_ = 0;
};

Point middle(const Mesh& mesh, HalfedgeId h) {
  const Point &from = mesh.positions()[mesh.origin(h).value], &to = mesh.positions()[mesh.tip(h).value];
  return {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2, (from[2] + to[2]) / 2};
}

double distance(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Is the far side of the quad that came beyond a boundary edge where that edge was?
bool holds_old_boundary(const Scene& scene, const RimSide& side) {
  const Mesh &before = *scene.before->mesh, &after = *scene.after->mesh;
  if (side.in_before != Beyond::Nothing || side.in_after != Beyond::Unmatched) return false;
  const HalfedgeId entry = after.twin(side.after);
  if (after.size(after.face(entry)) != 4) return false;
  const HalfedgeId far = after.next(after.next(entry));
  if (after.twin(far).valid()) return false;
  const Point there = middle(after, far);
  return distance(there, middle(before, side.before)) < kAtOldBoundary * distance(there, middle(after, entry));
}

}  // namespace

bool is_split_at_boundary(const Scene& scene) {
  if (scene.before->mesh->positions().empty() || scene.after->mesh->positions().empty()) return false;
  const auto holding = std::count_if(scene.rim.begin(), scene.rim.end(),
                                     [&](const RimSide& side) { return holds_old_boundary(scene, side); });
  return 2 * static_cast<std::size_t>(holding) > scene.rim.size() &&
         scene.faces_after.size() <= scene.rim.size() + scene.faces_before.size();
}

std::uint32_t count_inserted_rows(const Scene& scene) {
  if (scene.faces_after.size() <= scene.faces_before.size()) return 0;
  const auto joined = std::count_if(scene.rim.begin(), scene.rim.end(), [](const RimSide& side) {
    return side.in_before != Beyond::Nothing && side.in_after == Beyond::Unmatched;
  });
  return 2 * static_cast<std::size_t>(joined) > scene.rim.size() ? RowCount(scene).run() : 0;
}

}  // namespace quadmatch::use
