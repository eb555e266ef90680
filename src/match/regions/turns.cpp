// Turns: a part that hangs on the rest by a closed ring of quads lies on its partner as well when it is turned about
// that ring, as far as corners tell, if it is a limb without extraordinary vertices or one that looks the same from
// several sides. Each such part is offered turned by any number of quads, as a whole.
//
// Lengths decide, as they are in the models: what fits a stretch to matches that lie turned excuses them. The taper of
// a face, the ratio of its opposite edges, says most where a model was posed. Without lengths, of two turns that are as
// good the smaller one is taken.

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "mending.hpp"
#include "nth_smallest.hpp"

namespace quadmatch::regions {
namespace {

/// Shorter rings are tips and corners of boxes.
constexpr std::size_t kLeastRing = 4;
/// Turns of one part that are tried at most: those whose first row fits best.
constexpr std::size_t kMostTurns = 3, kMostTurnsWithoutLengths = 8;
/// Where nothing is torn at a ring, its row must fit this badly, by what is usual, and turned to this share of that.
constexpr double kBad = 1.5, kFalls = 0.8;
/// What a corner costs that disagrees, errors of 4.5 times what is usual in lengths and in tapers, and a turn by a
/// quad.
constexpr double kCorner = 0.15, kWorst = 0.45, kTurn = 0.1;
constexpr double kMostUsual = 4.5, kLeastUsual = 0.015;
constexpr double kLeastGain = 1e-6;  // of costs, so that rounding decides nothing
/// Faces visited at most, by faces of the source.
constexpr std::size_t kBudget = 20;

/// A closed ring of quads, by the half-edges through which it is entered, face by face.
using Ring = std::vector<HalfedgeId>;

HalfedgeId across(const Mesh& mesh, HalfedgeId entry) { return mesh.twin(turned(mesh, entry, 2)); }

/// The ring that is entered here; nothing if it ends, crosses itself, has other faces than quads, or was seen before.
/// @param was_seen  asked of every half-edge through which it is entered; remembers.
template <class WasSeen>
std::optional<Ring> ring_from(const Mesh& mesh, HalfedgeId start, WasSeen was_seen) {
  Ring ring;
  HalfedgeId entry = start;
  do {
    if (!entry.valid() || mesh.size(mesh.face(entry)) != 4 || was_seen(entry)) return std::nullopt;
    ring.push_back(entry);
    entry = across(mesh, entry);
  } while (entry != start);
  return ring;
}

/// What hangs on a ring at one side of it: the half-edges by which it does, in the order of the ring.
struct Hem {
  std::vector<HalfedgeId> source, target;
  std::vector<HalfedgeId> source_back, target_back;  ///< beyond the other side of the ring; empty at a boundary
  bool is_matched = true;                            ///< the first on the first; else they only lie so as the ring does
};

class Turns {
 public:
  explicit Turns(Workbench& bench)
      : bench_(bench),
        with_lengths_(bench.misfit.uses_lengths()),
        source_seen_(source_.face_count(), 0),
        target_seen_(target_.face_count(), 0),
        walked_(source_.halfedge_count(), false) {}

  std::size_t undo() {
    if (with_lengths_) learn_what_is_usual();
    std::size_t changed = 0;
    for (const FaceId face : faces_to_look_at()) {
      if (spent_ >= budget_) break;
      for (const std::uint32_t corner : {0U, 1U}) changed += turn_about(HalfedgeId(source_.first(face).value + corner));
    }
    return changed;
  }

 private:
  using Size = std::int64_t;
  /// Of lengths and of tapers, see Misfit.
  struct Errors {
    double length = 1, taper = 1;
  };

  /// Lengths may fit badly anywhere; without them only what is torn is looked at.
  [[nodiscard]] std::vector<FaceId> faces_to_look_at() {
    std::vector<FaceId> faces;
    if (with_lengths_) {
      for (std::uint32_t f = 0; f < source_.face_count(); ++f) faces.push_back(FaceId(f));
      return faces;
    }
    for (const HalfedgeId entry : bench_.rim.entries()) {
      faces.push_back(source_.face(entry));
      for (const HalfedgeId h : source_.halfedges(faces.back())) {
        if (const HalfedgeId beside = source_.twin(h); beside.valid()) faces.push_back(source_.face(beside));
      }
    }
    return faces;
  }
  std::size_t turn_about(HalfedgeId start) {
    if (walked_[start.value] || source_.size(source_.face(start)) != 4) return 0;
    ++now_;
    const std::optional<Ring> ring = ring_from(source_, start, [&](HalfedgeId entry) {
      const bool was_walked = walked_[entry.value] || std::exchange(source_seen_[source_.face(entry)], now_) == now_;
      walked_[entry.value] = walked_[turned(source_, entry, 2).value] = true;
      return was_walked;
    });
    if (!ring || ring->size() < kLeastRing) return 0;
    std::size_t changed = 0;
    for (const std::uint32_t side : {1U, 3U}) {
      if (const std::optional<Hem> hem = hem_of(*ring, side)) changed += turn(*hem);
    }
    return changed;
  }

  void learn_what_is_usual() {
    std::vector<double> lengths, tapers;
    const std::vector<HalfedgeId>& history = bench_.patchwork.history();
    for (std::size_t k = 0; k < history.size(); k += 1 + history.size() / 2000) {
      if (!bench_.patchwork.is_matched(source_.face(history[k]))) continue;
      const Candidate pair{history[k], bench_.patchwork.image(history[k])};
      lengths.push_back(bench_.misfit.plain_error(pair));
      tapers.push_back(bench_.misfit.taper_error(pair));
    }
    if (lengths.empty()) return;
    usual_ = {std::max(kLeastUsual, nth_smallest(lengths, lengths.size() / 2)),
              std::max(kLeastUsual, nth_smallest(tapers, tapers.size() / 2))};
  }

  /// How badly a pair fits.
  [[nodiscard]] double fit(Candidate pair) const {
    if (source_.size(source_.face(pair.source)) != target_.size(target_.face(pair.target))) return Misfit::kUnmatched;
    if (!with_lengths_) return bench_.misfit.cost(pair);
    const double length = bench_.misfit.plain_error(pair) / (kMostUsual * here_.length);
    const double taper = bench_.misfit.taper_error(pair) / (kMostUsual * here_.taper);
    return kWorst * std::min(1.0, length) + kWorst * std::min(1.0, taper) +
           kCorner * bench_.misfit.disagreeing_corners(pair);
  }
  [[nodiscard]] double fit_now(FaceId face) const {
    if (!bench_.patchwork.is_matched(face)) return Misfit::kUnmatched;
    const HalfedgeId first = source_.first(face);
    return fit({first, bench_.patchwork.image(first)});
  }

  [[nodiscard]] static std::vector<HalfedgeId> beside(const Mesh& mesh, const Ring& ring, std::uint32_t side) {
    std::vector<HalfedgeId> hem;
    for (const HalfedgeId entry : ring) hem.push_back(mesh.twin(turned(mesh, entry, side)));
    if (std::any_of(hem.begin(), hem.end(), [](HalfedgeId h) { return !h.valid(); })) hem.clear();
    return hem;
  }
  /// The hem beyond a ring and what it lies on now, begun at a face that is matched; where nothing of it is, what it
  /// would lie on as the ring does. Nothing if that is no hem.
  [[nodiscard]] std::optional<Hem> hem_of(const Ring& ring, std::uint32_t side) {
    Hem hem{beside(source_, ring, side), {}, beside(source_, ring, 4 - side), {}};
    if (hem.source.empty()) return std::nullopt;
    const auto is_matched = [&](HalfedgeId h) { return bench_.patchwork.is_matched(source_.face(h)); };
    auto begin = std::find_if(hem.source.begin(), hem.source.end(), is_matched);
    hem.is_matched = begin != hem.source.end();
    if (!hem.is_matched) {
      begin =
          std::find_if(hem.source.begin(), hem.source.end(), [&](HalfedgeId h) { return is_matched(source_.twin(h)); });
      if (begin == hem.source.end()) return std::nullopt;
    }
    const HalfedgeId over =
        hem.is_matched ? target_.twin(bench_.patchwork.image(*begin)) : bench_.patchwork.image(source_.twin(*begin));
    if (!over.valid() || target_.size(target_.face(over)) != 4) return std::nullopt;
    ++now_;
    const std::optional<Ring> other = ring_from(target_, turned(target_, over, 4 - side), [&](HalfedgeId entry) {
      return std::exchange(target_seen_[target_.face(entry)], now_) == now_;
    });
    if (!other || other->size() != ring.size()) return std::nullopt;
    const auto first = begin - hem.source.begin();
    std::rotate(hem.source.begin(), hem.source.begin() + first, hem.source.end());
    if (!hem.source_back.empty()) {
      std::rotate(hem.source_back.begin(), hem.source_back.begin() + first, hem.source_back.end());
    }
    hem.target = beside(target_, *other, side);
    hem.target_back = beside(target_, *other, 4 - side);
    if (hem.target.empty()) return std::nullopt;
    return hem;
  }

  /// By how many quads the part lies turned against what is beyond the ring; nothing if nobody knows.
  [[nodiscard]] std::optional<Size> turn_now(const Hem& hem) const {
    if (hem.source_back.empty() || hem.target_back.empty()) return std::nullopt;
    const auto size = static_cast<Size>(hem.source.size());
    std::vector<std::uint32_t> votes(hem.source.size(), 0);
    std::uint32_t asked = 0;
    for (Size i = 0; i < size; i += static_cast<Size>(stride_of(hem))) {
      const HalfedgeId back = hem.source_back[i];
      ++asked;
      if (!bench_.patchwork.is_matched(source_.face(back))) continue;
      const HalfedgeId image = bench_.patchwork.image(back);
      const auto found = std::find(hem.target_back.begin(), hem.target_back.end(), image);
      if (found != hem.target_back.end()) ++votes[(i - (found - hem.target_back.begin()) + size) % size];
    }
    const auto most = std::max_element(votes.begin(), votes.end());
    if (2 * *most < asked) return std::nullopt;
    return most - votes.begin();
  }
  /// Quads by which something is turned, the shorter way round.
  [[nodiscard]] static Size turns(Size by, Size size) {
    const Size rest = ((by % size) + size) % size;
    return std::min(rest, size - rest);
  }

  /// Some faces of a long row say enough.
  [[nodiscard]] static std::size_t stride_of(const Hem& hem) { return 1 + hem.source.size() / 16; }
  /// How badly the row at the hem fits, on the average, turned so far.
  [[nodiscard]] double row_fit(const Hem& hem, std::size_t by) const {
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < hem.source.size(); i += stride_of(hem), ++count) {
      sum += fit({hem.source[i], hem.target[(i + by) % hem.target.size()]});
    }
    return sum / count;
  }

  /// What is usual about the ring: the model may be stretched there more than elsewhere, so that even the best turn
  /// fits badly.
  [[nodiscard]] Errors usual_about(const Hem& hem) const {
    Errors least{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
    double count = 0;
    for (std::size_t by = 0; by < hem.source.size(); ++by) {
      Errors sum{0, 0};
      count = 0;
      for (std::size_t i = 0; i < hem.source.size(); i += stride_of(hem), ++count) {
        const Candidate pair{hem.source[i], hem.target[(i + by) % hem.target.size()]};
        if (source_.size(source_.face(pair.source)) != target_.size(target_.face(pair.target))) continue;
        sum.length += bench_.misfit.plain_error(pair);
        sum.taper += bench_.misfit.taper_error(pair);
      }
      least = {std::min(least.length, sum.length), std::min(least.taper, sum.taper)};
    }
    return {std::max(usual_.length, least.length / count), std::max(usual_.taper, least.taper / count)};
  }

  std::size_t turn(const Hem& hem) {
    here_ = usual_;
    const std::optional<Size> now = turn_now(hem);
    const bool is_torn = !hem.is_matched || now.value_or(1) != 0;
    const double row_now = row_fit(hem, 0);
    if (!is_torn && (!with_lengths_ || row_now < kBad * kWorst * 2 / kMostUsual)) return 0;
    if (with_lengths_) here_ = usual_about(hem);
    const std::vector<std::size_t> candidates = turns_to_try(hem, now, row_fit(hem, 0));
    if (candidates.empty() || !gather_part(hem) || (!hem.is_matched && !is_free())) return 0;
    double least = cost_now(hem, now);
    std::optional<std::size_t> best;
    for (const std::size_t by : candidates) {
      const double cost = cost_turned(hem, by, now);
      if (cost >= least - kLeastGain || (!hem.is_matched && !fills_part())) continue;
      least = cost;
      best = by;
    }
    return best ? lay(hem, *best) : 0;
  }
  /// The likeliest turns first.
  [[nodiscard]] std::vector<std::size_t> turns_to_try(const Hem& hem, std::optional<Size> now, double row_now) {
    std::vector<std::pair<double, std::size_t>> rows;
    spent_ += 16 * hem.source.size();
    const auto size = static_cast<Size>(hem.source.size());
    for (std::size_t by = hem.is_matched ? 1 : 0; by < hem.source.size(); ++by) {
      const double row = row_fit(hem, by);
      const Size then = now ? turns(*now + static_cast<Size>(by), size) : 0;
      if (hem.is_matched && now == Size{0} && row > kFalls * row_now) continue;
      if (hem.is_matched && !with_lengths_ && (row > row_now || then >= turns(now.value_or(0), size))) continue;
      rows.emplace_back(row + 1e-3 * static_cast<double>(then), by);
    }
    std::sort(rows.begin(), rows.end());
    const std::size_t most = with_lengths_ ? kMostTurns : kMostTurnsWithoutLengths;
    std::vector<std::size_t> candidates;
    for (std::size_t k = 0; k < std::min(most, rows.size()); ++k) candidates.push_back(rows[k].second);
    return candidates;
  }
  [[nodiscard]] bool is_free() const {
    return std::none_of(part_.begin(), part_.end(), [&](FaceId face) { return bench_.patchwork.is_matched(face); });
  }
  /// Does the ghost cover the part, with all corners agreeing, and nothing that others have? What is not matched at all
  /// is laid only so.
  [[nodiscard]] bool fills_part() const {
    const std::vector<Candidate>& pairs = bench_.ghost.pairs();
    return pairs.size() == part_.size() && std::all_of(pairs.begin(), pairs.end(), [&](const Candidate& pair) {
             return !bench_.patchwork.is_taken(target_.face(pair.target)) &&
                    bench_.misfit.disagreeing_corners(pair) == 0;
           });
  }

  /// All faces of the source on this side of the ring. @return false if that is most of the mesh, or has two ends.
  bool gather_part(const Hem& hem) {
    part_.clear();
    ring_seen_ = ++now_;
    for (const HalfedgeId h : hem.source) source_seen_[source_.face(source_.twin(h))] = ring_seen_;
    for (const HalfedgeId h : hem.target) target_seen_[target_.face(target_.twin(h))] = ring_seen_;
    ++now_;
    const auto reach = [&](FaceId face) {
      if (source_seen_[face] >= ring_seen_) return;
      source_seen_[face] = now_;
      part_.push_back(face);
    };
    for (const HalfedgeId h : hem.source) reach(source_.face(h));
    for (std::size_t here = 0; here < part_.size() && 2 * part_.size() <= source_.face_count(); ++here) {
      for (const HalfedgeId h : source_.halfedges(part_[here])) {
        if (const HalfedgeId beyond = source_.twin(h); beyond.valid()) reach(source_.face(beyond));
      }
    }
    spent_ += part_.size();
    return 2 * part_.size() <= source_.face_count();
  }
  [[nodiscard]] double cost_of_turn(std::optional<Size> turned_by, const Hem& hem) const {
    const auto size = static_cast<Size>(hem.source.size());
    const double torn = Misfit::kSeam * static_cast<double>(size);
    if (!turned_by) return torn;
    const Size by = turns(*turned_by, size);
    return by == 0 ? 0 : torn + kTurn * static_cast<double>(by);
  }
  [[nodiscard]] double cost_now(const Hem& hem, std::optional<Size> now) const {
    double cost = hem.is_matched ? cost_of_turn(now, hem) : 0;
    for (const FaceId face : part_) cost += fit_now(face);
    return cost;
  }
  /// Leaves the turned part in the ghost.
  [[nodiscard]] double cost_turned(const Hem& hem, std::size_t by, std::optional<Size> now) {
    grow({hem.source.front(), hem.target[by]});
    double cost = cost_of_turn(now ? std::optional<Size>(*now + static_cast<Size>(by)) : std::nullopt, hem);
    cost += Misfit::kUnmatched * static_cast<double>(part_.size() - bench_.ghost.pairs().size());
    for (const Candidate& pair : bench_.ghost.pairs()) {
      cost += fit(pair);
      const FaceId owner = bench_.patchwork.origin(target_.face(pair.target));
      if (owner.valid() && !is_in_part(owner)) cost += std::max(0.0, Misfit::kUnmatched - fit_now(owner));
    }
    return cost;
  }
  [[nodiscard]] bool is_in_part(FaceId face) const { return source_seen_[face] > ring_seen_; }

  /// Over the part only, and not past corners that disagree.
  void grow(Candidate seed) {
    bench_.ghost.restart();
    take(seed);
    for (std::size_t here = 0; here < bench_.ghost.pairs().size(); ++here) {
      const Candidate pair = bench_.ghost.pairs()[here];
      if (bench_.misfit.disagreeing_corners(pair) > 0) continue;
      auto [s, t] = pair;
      do {
        const Candidate beyond{source_.twin(s), target_.twin(t)};
        if (beyond.source.valid() && beyond.target.valid()) take(beyond);
        s = source_.next(s);
        t = target_.next(t);
      } while (s != pair.source);
    }
    spent_ += bench_.ghost.pairs().size();
  }
  void take(Candidate pair) {
    const bool on_ring = target_seen_[target_.face(pair.target)] == ring_seen_;
    if (!on_ring && is_in_part(source_.face(pair.source)) && bench_.ghost.fits(pair)) bench_.ghost.accept(pair);
  }

  std::size_t lay(const Hem& hem, std::size_t by) {
    grow({hem.source.front(), hem.target[by]});
    Patchwork& patchwork = bench_.patchwork;
    std::size_t changed = 0;
    for (const Candidate& pair : bench_.ghost.pairs()) {
      const bool stays = patchwork.is_matched(source_.face(pair.source)) && patchwork.image(pair.source) == pair.target;
      changed += !stays;
    }
    for (const FaceId face : part_) {
      if (patchwork.is_matched(face)) patchwork.lift(face);
    }
    const std::uint32_t region = patchwork.fresh_region();
    for (const Candidate& pair : bench_.ghost.pairs()) {
      if (const FaceId owner = patchwork.origin(target_.face(pair.target)); owner.valid()) patchwork.lift(owner);
      patchwork.lay(pair, region);
    }
    return changed;
  }

  Workbench& bench_;
  const Mesh& source_ = bench_.sides.source.mesh;
  const Mesh& target_ = bench_.sides.target.mesh;
  bool with_lengths_;
  Errors usual_, here_;  // in the whole model, and about the ring
  PerFace<std::uint32_t> source_seen_, target_seen_;
  std::vector<bool> walked_;  // half-edges of rings that were looked at
  std::uint32_t now_ = 0, ring_seen_ = 0;
  std::vector<FaceId> part_;
  std::size_t budget_ = kBudget * source_.face_count(), spent_ = 0;
};

}  // namespace

std::size_t undo_turns(Workbench& bench) {
  const std::size_t changed = Turns(bench).undo();
  bench.ghost.restart();
  return changed;
}

}  // namespace quadmatch::regions
