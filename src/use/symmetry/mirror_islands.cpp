#include "mirror_islands.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace quadmatch::use {
namespace {

/// Edits are local: of the faces one in so many may be free. Where there are more, the mirror itself is in question.
constexpr std::uint32_t kLocal = 8;
/// Where no row is skipped, of so many corners well inside of an island one may look other than the one opposite.
constexpr std::size_t kAlike = 8;
/// Faces grown and hops looked at, at most, by those of the mesh, and beside that for the smallest.
constexpr std::size_t kBudget = 64, kLeastBudget = 1 << 20;
/// Hops that must agree; fewer could by chance.
constexpr std::uint32_t kLeastVotes = 4;
/// Of the hops over so many rows that lead to faces of an island, how many must lead to their partners.
constexpr double kAgree = 0.75;

/// Rows about an edit of which nobody knows whether they lie well.
constexpr int kRowsInDoubt = 4;
/// Rows skipped on the one side or on the other; none is the rule.
constexpr std::array<std::pair<std::size_t, std::size_t>, 5> kHops{{{0, 0}, {1, 0}, {0, 1}, {2, 0}, {0, 2}}};

struct Hop {
  std::array<Germ, kHops.size()> germs;  ///< by kHops; not valid where they lead nowhere
};

struct Island {
  Germ germ;
  std::uint32_t votes = 0;
  std::uint32_t faces = 0;
};

class Islands {
 public:
  Islands(const Mesh& mesh, const PerFan<VertexCode>& codes, MirrorMap& map)
      : mesh_(mesh), codes_(codes), map_(map), island_(mesh, codes, &map) {}

  void run() {
    const std::vector<Germ> before = map_.laid(), in_doubt = map_.erode(kRowsInDoubt);
    bool any = false;
    for (int row = 0; row < kRowsInDoubt; ++row) map_.cover_rim(Fit::Notch);
    while (kLocal * (mesh_.face_count() - map_.faces()) <= mesh_.face_count()) {
      look_for_hops();
      const Island best = most_agreed();
      if (!is_lifted_ || best.votes == 0) break;
      any = true;
      grow(best.germ);
      for (const Germ& germ : island_.laid()) map_.lay(germ, Fit::Free);
    }
    island_.clear();
    if (!any) map_.clear();
    for (const Germ& germ : any ? in_doubt : before) map_.lay(germ, Fit::Free);
  }

 private:
  /// The half-edge by which one enters the face beyond so many quads; not valid where there are none.
  [[nodiscard]] HalfedgeId beyond(HalfedgeId entry, std::size_t rows) const {
    for (; rows > 0 && entry.valid(); --rows) {
      if (mesh_.size(mesh_.face(entry)) != 4 || map_.image(entry).valid()) return {};
      entry = mesh_.twin(mesh_.next(mesh_.next(entry)));
    }
    return entry;
  }

  void look_for_hops() {
    hops_.clear();
    for (const Germ& laid : map_.laid()) {
      look_beyond(mesh_.face(laid.from));
      if (mesh_.face(laid.to) != mesh_.face(laid.from)) look_beyond(mesh_.face(laid.to));
    }
  }

  void look_beyond(FaceId face) {
    for (const HalfedgeId h : mesh_.halfedges(face)) {
      const HalfedgeId beside = mesh_.twin(h), opposite = mesh_.twin(map_.image(h));
      if (!beside.valid() || !opposite.valid() || map_.image(beside) == opposite) continue;
      Hop hop;
      bool any = false;
      for (std::size_t k = 0; k < kHops.size(); ++k) {
        const HalfedgeId from = beyond(beside, kHops[k].first), to = beyond(opposite, kHops[k].second);
        const bool is_free = from.valid() && to.valid() && !map_.image(from).valid() && !map_.image(to).valid();
        if (is_free) hop.germs[k] = {from, to};
        any = any || is_free;
      }
      if (any) hops_.push_back(hop);
    }
  }

  void grow(Germ germ) {
    island_.clear();
    if (island_.lay(germ, Fit::Vertices)) island_.grow(Fit::Vertices);
  }

  /// Of the maps that hops lead to, the one with most hops and faces.
  Island most_agreed() {
    Island best;
    is_lifted_ = false;
    for (std::size_t k = 0; k < kHops.size(); ++k) {
      PerHalfedge<HalfedgeId> tried(mesh_.halfedge_count());  // where a germ led that is part of a map looked at
      for (const Hop& hop : hops_) {
        const Germ germ = hop.germs[k];
        if (!germ.from.valid() || tried[germ.from] == germ.to) continue;
        if (spent_ > kBudget * mesh_.face_count() + kLeastBudget) return {};
        grow(germ);
        spent_ += island_.faces() + hops_.size();
        const Island island{germ, k > 0 || looks_right() ? votes(k) : 0, island_.faces()};
        for (const Germ& laid : island_.laid()) mark(laid, tried);
        if (!is_likely(island)) continue;
        is_lifted_ = is_lifted_ || k > 0;
        if (island.votes + island.faces > best.votes + best.faces) best = island;
      }
    }
    return best;
  }

  void mark(Germ laid, PerHalfedge<HalfedgeId>& tried) const {
    HalfedgeId here = laid.from, there = laid.to;
    for (std::uint32_t k = 0; k < mesh_.size(mesh_.face(laid.from)); ++k) {
      tried[here] = there;
      tried[there] = here;
      here = mesh_.next(here);
      there = mesh_.prev(there);
    }
  }

  /// Do hops lead there from all around?
  static bool is_likely(const Island& island) {
    return island.votes >= kLeastVotes && island.votes * island.votes >= island.faces;
  }

  /// Do corners well inside of the island look like those opposite?
  [[nodiscard]] bool looks_right() const {
    const auto is_inside = [&](HalfedgeId h) {
      const HalfedgeId beside = mesh_.twin(h);
      return beside.valid() && island_.image(beside).valid() && island_.image(beside) == mesh_.twin(island_.image(h));
    };
    std::size_t inside = 0, other = 0;
    for (const Germ& laid : island_.laid()) {
      for (const HalfedgeId h : mesh_.halfedges(mesh_.face(laid.from))) {
        if (!is_inside(h) || !is_inside(mesh_.prev(h))) continue;
        ++inside;
        other += codes_[mesh_.fan(h)] == codes_[mesh_.fan(mesh_.next(island_.image(h)))] ? 0 : 1;
      }
    }
    return kAlike * other <= inside;
  }

  /// Hops over so many rows that lead to partners; none where too many lead from one face of the island to another.
  [[nodiscard]] std::uint32_t votes(std::size_t k) const {
    std::uint32_t agree = 0, all = 0;
    for (const Hop& hop : hops_) {
      const Germ germ = hop.germs[k];
      if (!germ.from.valid()) continue;
      const HalfedgeId image = island_.image(germ.from);
      all += image.valid() && island_.image(germ.to).valid() ? 1 : 0;
      agree += image == germ.to ? 1 : 0;
    }
    return agree >= kAgree * all ? agree : 0;
  }

  const Mesh& mesh_;
  const PerFan<VertexCode>& codes_;
  MirrorMap& map_;
  MirrorMap island_;
  std::vector<Hop> hops_;
  std::size_t spent_ = 0;
  bool is_lifted_ = false;  // is there an island to which hops over rows lead?
};

}  // namespace

void lay_islands(const Mesh& mesh, const PerFan<VertexCode>& codes, MirrorMap& map) { Islands(mesh, codes, map).run(); }

}  // namespace quadmatch::use
