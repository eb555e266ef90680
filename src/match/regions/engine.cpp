// Read from top to bottom, this is how regions are matched: equal parts, fire, and the stages that mend it.

#include "engine.hpp"

#include <algorithm>
#include <utility>

#include "assemble.hpp"
#include "equal_parts.hpp"
#include "fire.hpp"
#include "ignition.hpp"
#include "mending.hpp"
#include "placement.hpp"
#include "trial.hpp"

namespace quadmatch::regions {
namespace {

/// Below it a region is almost always garbage.
constexpr double kLeastConfidence = 0.6;
constexpr int kMostRestarts = 3;

/// Grow from all anchors that colours give, in rounds: what is matched makes others unique.
void grow(const Sides& sides, const ColouredSpokes& with_lengths, const ColouredSpokes& without, Fire& fire,
          const Patchwork& patchwork) {
  constexpr int kMostRounds = 4;
  const std::size_t little = sides.source.mesh.face_count() / 500;
  for (int round = 0; round < kMostRounds; ++round) {
    const std::size_t before = patchwork.matched_faces();
    fire.light(find_sparks(sides, with_lengths, without, patchwork, round == 0 ? Caution::High : Caution::Low));
    fire.burn();
    if (patchwork.matched_faces() - before <= little) break;
  }
  fire.burn_disagreeing();
  if (fire.drop_unbelievable(kLeastConfidence) > 0) {
    fire.rekindle();
    fire.burn();
  }
  fire.light(find_sparks(sides, with_lengths, without, patchwork, Caution::Low));
  fire.burn();
  fire.burn_disagreeing();
  fire.drop_unbelievable(kLeastConfidence);
}

/// The stages, one after the other, on one workbench.
class Engine {
 public:
  Engine(const Sides& sides, const MatchOptions& options, const EngineProgress& progress)
      : sides_(sides),
        stages_(options.stages),
        progress_(progress),
        patchwork_(sides.source.mesh, sides.target.mesh),
        misfit_(sides, options.positions),
        ghost_(sides, patchwork_),
        rim_(sides, patchwork_),
        bench_{sides, patchwork_, misfit_, ghost_, rim_},
        with_lengths_(colour_both(sides, true)) {}

  Outcome run(const std::vector<Anchor>& anchors) {
    lay_anchors(anchors);
    EqualParts equal(bench_, with_lengths_);
    if (stages_.equal_parts) equal.lay_single();
    bool laid_whole = false;  // and sound as it stands
    if (patchwork_.matched_faces() < most_faces()) {
      match_unequal(equal);
    } else if (anchors.empty()) {
      laid_whole = !misfit_.may_use_positions() || lies_well(bench_) || is_only_posed();
      if (!laid_whole) mend();
    }
    Outcome outcome{laid_whole ? equal.take_pieces() : split(sides_, patchwork_, rim_), !cancelled_};
    const PieceOfRegion piece_of = piece_of_region(outcome.pieces);
    weigh_pieces(sides_, patchwork_, piece_of, outcome.pieces);
    mark_ties(equal.ties(), piece_of, outcome.pieces);
    mark_doubts(outcome.pieces);
    return outcome;
  }

 private:
  [[nodiscard]] std::uint32_t most_faces() const {
    return std::min(sides_.source.mesh.face_count(), sides_.target.mesh.face_count());
  }
  /// @return true to go on.
  bool report() {
    cancelled_ = cancelled_ || (progress_ && !progress_(patchwork_.matched_faces()));
    return !cancelled_;
  }

  /// Of a model that is laid whole: do lengths differ, but nowhere as if a ring of it had been turned? Then they are no
  /// reason to tear apart what connectivity holds together.
  [[nodiscard]] bool is_only_posed() {
    misfit_.calibrate(patchwork_);
    place(bench_);
    return misfit_.uses_lengths() && !slides_explain(bench_);
  }

  /// The user knows better: grow from each anchor first, and let nothing move it.
  void lay_anchors(const std::vector<Anchor>& anchors) {
    std::vector<Candidate> pins;
    for (const Anchor& anchor : anchors) {
      if (!grow_trial(bench_, anchor, {.most_faces = most_faces(), .cover_disagreeing = false, .any_seed = true}))
        continue;
      pinned_.push_back(patchwork_.region_count());
      keep_trial(bench_);
      pins.push_back(anchor);
    }
    misfit_.pin(std::move(pins));
  }

  /// Everything after the equal parts: fire, and what mends it.
  void match_unequal(EqualParts& equal) {
    {
      Fire fire(sides_, patchwork_);
      for (const std::uint32_t region : pinned_) fire.protect(region);
      grow(sides_, with_lengths_, colour_both(sides_, false), fire, patchwork_);
      fire.settle();
    }
    if (!report()) return;
    if (stages_.equal_parts) equal.lay_repeated();
    mend();
    for (int round = 0; round < kMostRestarts && stages_.restarts && report(); ++round) {
      if (leaves_little() || !start_again()) break;
      mend();
    }
    if (misfit_.is_stretched() && report()) mend();  // by now more is known of how
    if (stages_.rows && misfit_.uses_lengths() && report()) straighten_rows(bench_);
    if (stages_.acceptance) drop_unlikely(bench_);
    if (stages_.doubts && report()) doubts_ = set_doubts_apart(bench_);
  }

  /// Make the costs small: move what lies badly, match what was left over.
  void mend() {
    misfit_.calibrate(patchwork_);
    move();
    if (stages_.ties && pinned_.empty()) place(bench_);  // a user who anchors settles ties
    if (misfit_.is_placed() && settle_ties(bench_) > 0) {
      misfit_.calibrate(patchwork_);
      move();
    }
    for (int round = 0; round < 2 && stages_.slides && report(); ++round) {
      if (undo_slides(bench_) == 0) break;
      move();
    }
    if (may_turn() && report() && undo_turns(bench_) > 0) {
      misfit_.calibrate(patchwork_);
      move();
    }
    drop_misfits(bench_);
    if (stages_.ventures && !misfit_.uses_lengths()) venture_on(bench_);
    if (stages_.slivers) match_slivers(bench_);
    const int island_rounds = misfit_.uses_lengths() ? 2 : 6;  // without lengths each reaches less far
    for (int round = 0; round < island_rounds && stages_.islands && report(); ++round) {
      if (match_islands(bench_) == 0) break;
      if (stages_.slivers) match_slivers(bench_);
    }
    if (stages_.slivers && !misfit_.uses_lengths()) match_slivers(bench_, true);
    move();
    drop_misfits(bench_);
    if (stages_.slivers) match_slivers(bench_, true);
  }
  /// May parts be turned as a whole? Where the source is placed and not stretched positions have settled that, and so
  /// has a user who anchors.
  [[nodiscard]] bool may_turn() const {
    return stages_.turns && pinned_.empty() && (!misfit_.is_placed() || misfit_.is_stretched());
  }
  void move() {
    if (stages_.seams && report()) move_seams(bench_, seams_);
  }

  /// Is at most a little left free in one of the meshes?
  [[nodiscard]] bool leaves_little() const { return 1000 * patchwork_.matched_faces() >= 985ULL * most_faces(); }

  bool start_again() {
    const std::size_t before = patchwork_.matched_faces();
    restart(bench_);
    match_lookalikes(bench_);
    if (patchwork_.matched_faces() > before) return true;
    if (before > 0) return false;
    for (const double sigma : {0.1, 0.2}) {  // there is nothing to learn lengths from, and nothing to lose
      misfit_.assume(sigma);
      if (restart(bench_) > 0) return true;
    }
    return false;
  }

  [[nodiscard]] PieceOfRegion piece_of_region(const std::vector<Piece>& pieces) const {
    PieceOfRegion piece_of(patchwork_.region_count(), kNoPiece);
    for (std::uint32_t number = 0; number < pieces.size(); ++number) {
      piece_of[patchwork_.region(sides_.source.mesh.face(pieces[number].pairs.front().source))] = number;
    }
    return piece_of;
  }

  /// Tell the pieces that were laid whole in one of several ways.
  void mark_ties(const std::vector<Tie>& ties, const PieceOfRegion& piece_of, std::vector<Piece>& pieces) const {
    for (const Tie& tie : ties) {
      if (!patchwork_.is_matched(tie.face)) continue;
      Piece& piece = pieces[piece_of[patchwork_.region(tie.face)]];
      piece.ways = tie.ways;
      piece.ambiguous = !tie.by_positions;
    }
  }

  /// Tell the pieces that might as well lie elsewhere.
  void mark_doubts(std::vector<Piece>& pieces) const {
    std::vector<bool> is_doubtful(patchwork_.region_count(), false);
    for (const std::uint32_t region : doubts_) is_doubtful[region] = true;
    for (Piece& piece : pieces) {
      if (!is_doubtful[piece.region]) continue;
      piece.ways = std::max(piece.ways, 2U);
      piece.ambiguous = true;
    }
  }

  const Sides& sides_;
  const Stages& stages_;
  const EngineProgress& progress_;
  Patchwork patchwork_;
  Misfit misfit_;
  Ghost ghost_;
  Rim rim_;
  Workbench bench_;
  ColouredSpokes with_lengths_;
  std::vector<std::uint32_t> pinned_;
  std::vector<std::uint32_t> doubts_;  // regions, before the last split
  SeamsAtRest seams_;
  bool cancelled_ = false;
};

}  // namespace

Outcome match_regions(const Sides& sides, const MatchOptions& options, const std::vector<Anchor>& anchors,
                      const EngineProgress& progress) {
  return Engine(sides, options, progress).run(anchors);
}

}  // namespace quadmatch::regions
