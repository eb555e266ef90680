// Rows: somebody who removes or inserts an edge loop does so from end to end, so what one mesh has and the other has
// not is a whole row of quads. Costs do not know that: of two rows side by side the one fits here and the other there,
// most of all beside extraordinary vertices, and what is left free jumps from one to the other. Every row of which a
// good part is free is offered to be the one, if that costs little: its other faces are laid on nothing, and all
// between them and what was free beside them move up by one.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "mending.hpp"

namespace quadmatch::regions {
namespace {

/// What share of a row must be free already, and what share must be free in the end.
constexpr double kLeastFree = 0.2, kLeastWhole = 0.9;
constexpr std::size_t kLeastRow = 3;
/// Rows cross: one that is straight lets another be seen.
constexpr int kMostRounds = 3;
/// How many rows off what is free may lie.
constexpr std::size_t kMostRowsOff = 3;
/// What all may cost more: so much for each face that moves up, and for each of the row that was free already.
constexpr double kMostExtra = 0.15, kMostExtraByFree = 0.05;

/// One of the two meshes, and what lies on it or on what it lies.
class View {
 public:
  View(Workbench& bench, bool of_source) : bench_(bench), of_source_(of_source) {}

  [[nodiscard]] const Mesh& mesh() const { return of_source_ ? bench_.sides.source.mesh : bench_.sides.target.mesh; }
  [[nodiscard]] const Mesh& other() const { return of_source_ ? bench_.sides.target.mesh : bench_.sides.source.mesh; }
  [[nodiscard]] bool is_free(FaceId face) const {
    return !(of_source_ ? bench_.patchwork.is_matched(face) : bench_.patchwork.is_taken(face));
  }
  [[nodiscard]] HalfedgeId partner(HalfedgeId h) const {
    return of_source_ ? bench_.patchwork.image(h) : bench_.patchwork.preimage(h);
  }
  [[nodiscard]] Candidate pair(HalfedgeId h, HalfedgeId partner) const {
    return of_source_ ? Candidate{h, partner} : Candidate{partner, h};
  }

 private:
  Workbench& bench_;
  bool of_source_;
};

/// A row, by the half-edges through which it is entered, face by face.
using Row = std::vector<HalfedgeId>;

bool is_quad(const Mesh& mesh, HalfedgeId h) { return h.valid() && mesh.size(mesh.face(h)) == 4; }

/// The quad beside one, on the side of its second corner (1) or the other (3), entered from the same end of the row.
HalfedgeId beside(const Mesh& mesh, HalfedgeId entry, std::uint32_t side) {
  const HalfedgeId over = mesh.twin(turned(mesh, entry, side));
  return is_quad(mesh, over) ? turned(mesh, over, side) : HalfedgeId();
}

class Rows {
 public:
  Rows(Workbench& bench, bool of_source)
      : bench_(bench),
        view_(bench, of_source),
        mesh_(view_.mesh()),
        walked_(mesh_.halfedge_count(), false),
        seen_(mesh_.face_count(), 0),
        settled_(mesh_.halfedge_count(), 0) {}

  std::size_t straighten() {
    std::vector<Offer> offers;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      if (!view_.is_free(FaceId(f)) || mesh_.size(FaceId(f)) != 4) continue;
      for (const std::uint32_t corner : {0U, 1U}) offer_row(HalfedgeId(mesh_.first(FaceId(f)).value + corner), offers);
    }
    std::stable_sort(offers.begin(), offers.end(), [](const Offer& a, const Offer& b) {
      return a.free > b.free;  // what explains most comes first
    });
    std::size_t changed = 0;
    for (const Offer& offer : offers) changed += take(offer);
    return changed;
  }

 private:
  /// From a face of the row to the free one, in which case that is the last.
  using Column = std::vector<HalfedgeId>;
  struct Offer {
    Row row;
    std::size_t free;
  };

  void offer_row(HalfedgeId start, std::vector<Offer>& offers) {
    if (walked_[start.value]) return;
    Row row = row_through(start);
    const std::size_t free = free_faces(row);
    if (row.size() < kLeastRow || static_cast<double>(free) < kLeastFree * static_cast<double>(row.size())) return;
    if (free == row.size()) {
      settle(row);
    } else {
      offers.push_back({std::move(row), free});
    }
  }
  /// From end to end, or once round; empty if it crosses itself, from wherever on it one starts.
  [[nodiscard]] Row row_through(HalfedgeId start) {
    ++now_;
    Row row;
    for (HalfedgeId entry = start, exit; is_quad(mesh_, entry); entry = mesh_.twin(exit)) {
      if (entry == start && !row.empty()) return row;
      exit = walk(entry);
      if (std::exchange(seen_[mesh_.face(entry)], now_) == now_) return {};
      row.push_back(entry);
    }
    Row before;
    for (HalfedgeId over = mesh_.twin(start), entry; is_quad(mesh_, over); over = mesh_.twin(entry)) {
      entry = walk(over);
      if (std::exchange(seen_[mesh_.face(over)], now_) == now_) return {};
      before.push_back(entry);
    }
    row.insert(row.begin(), before.rbegin(), before.rend());
    return row;
  }
  /// Note that a row was walked here, either way. @return the half-edge opposite
  HalfedgeId walk(HalfedgeId entry) {
    const HalfedgeId opposite = turned(mesh_, entry, 2);
    walked_[entry.value] = walked_[opposite.value] = true;
    return opposite;
  }
  [[nodiscard]] std::size_t free_faces(const Row& row) const {
    return static_cast<std::size_t>(
        std::count_if(row.begin(), row.end(), [&](HalfedgeId entry) { return view_.is_free(mesh_.face(entry)); }));
  }
  void settle(const Row& row) {
    const auto size = static_cast<std::uint32_t>(row.size());
    for (const HalfedgeId entry : row) settled_[entry.value] = settled_[turned(mesh_, entry, 2).value] = size;
  }

  std::size_t take(const Offer& offer) {
    const Row& row = offer.row;
    free_of_row_ = free_faces(row);
    std::vector<Column> columns;
    std::size_t whole = 0;
    ++now_;
    for (const HalfedgeId entry : row) {
      if (view_.is_free(mesh_.face(entry))) {
        ++whole;
        continue;
      }
      std::optional<Column> column = column_from(entry);
      if (!column) continue;
      for (const HalfedgeId h : *column) seen_[mesh_.face(h)] = now_;
      ++whole;
      columns.push_back(std::move(*column));
    }
    if (columns.empty() || static_cast<double>(whole) < kLeastWhole * static_cast<double>(row.size())) return 0;
    double extra = 0;
    std::size_t moved = 0;
    for (const Column& column : columns) {
      extra += extra_cost(column);
      moved += column.size() - 1;
    }
    const auto free = static_cast<double>(free_of_row_);
    if (extra > kMostExtra * static_cast<double>(moved) + kMostExtraByFree * free) return 0;
    for (const Column& column : columns) move_up(column);
    settle(row);
    return moved;
  }
  /// The shorter one of both sides; nothing if neither ends at a free face soon.
  [[nodiscard]] std::optional<Column> column_from(HalfedgeId entry) const {
    std::optional<Column> best;
    for (const std::uint32_t side : {1U, 3U}) {
      std::optional<Column> column = column_from(entry, side);
      if (column && (!best || column->size() < best->size())) best = std::move(column);
    }
    return best;
  }
  [[nodiscard]] std::optional<Column> column_from(HalfedgeId entry, std::uint32_t side) const {
    Column column{entry};
    while (column.size() <= kMostRowsOff) {
      const HalfedgeId next = beside(mesh_, column.back(), side);
      if (!next.valid() || seen_[mesh_.face(next)] == now_) return std::nullopt;
      const bool is_free = view_.is_free(mesh_.face(next));
      if (is_free && settled_[next.value] >= free_of_row_) return std::nullopt;
      if (!is_free && beside(view_.other(), view_.partner(column.back()), side) != view_.partner(next)) {
        return std::nullopt;
      }
      column.push_back(next);
      if (is_free) return column;
    }
    return std::nullopt;
  }
  [[nodiscard]] double extra_cost(const Column& column) const {
    double extra = 0;
    for (std::size_t k = 0; k + 1 < column.size(); ++k) {
      const HalfedgeId partner = view_.partner(column[k]);
      extra +=
          bench_.misfit.cost(view_.pair(column[k + 1], partner)) - bench_.misfit.cost(view_.pair(column[k], partner));
    }
    return extra;
  }
  void move_up(const Column& column) {
    Patchwork& patchwork = bench_.patchwork;
    std::vector<Candidate> pairs;
    for (std::size_t k = 0; k + 1 < column.size(); ++k) {
      const HalfedgeId partner = view_.partner(column[k]);
      pairs.push_back(view_.pair(column[k + 1], partner));
    }
    for (std::size_t k = 0; k + 1 < column.size(); ++k) {
      patchwork.lift(bench_.sides.source.mesh.face(view_.pair(column[k], view_.partner(column[k])).source));
    }
    const std::uint32_t region = region_beside(pairs.back());
    for (const Candidate& pair : pairs) patchwork.lay(pair, region);
  }
  /// Of a face that lies beside a pair on both sides; a fresh one if there is none.
  [[nodiscard]] std::uint32_t region_beside(Candidate pair) {
    const Mesh& source = bench_.sides.source.mesh;
    auto [s, t] = pair;
    do {
      if (bench_.patchwork.beyond(s, t) == Beyond::InPlace) return bench_.patchwork.region(source.face(source.twin(s)));
      s = source.next(s);
      t = bench_.sides.target.mesh.next(t);
    } while (s != pair.source);
    return bench_.patchwork.fresh_region();
  }

  Workbench& bench_;
  View view_;
  const Mesh& mesh_;
  std::vector<bool> walked_;  // half-edges of rows that were looked at
  PerFace<std::uint32_t> seen_;
  std::vector<std::uint32_t> settled_;  // for those of rows that are free from end to end, how long these are
  std::size_t free_of_row_ = 0;         // faces of the row that is offered
  std::uint32_t now_ = 0;
};

}  // namespace

std::size_t straighten_rows(Workbench& bench) {
  std::size_t changed = 0;
  for (int round = 0; round < kMostRounds; ++round) {
    std::size_t changed_now = 0;
    for (const bool of_source : {true, false}) changed_now += Rows(bench, of_source).straighten();
    changed += changed_now;
    if (changed_now == 0) break;
  }
  return changed;
}

}  // namespace quadmatch::regions
