// Depth first: take the pair at the root of the first conflict in, or leave both its faces out. Each node propagates,
// bounds both sides by what can be reached less a packing of conflict sets, and forces what the bound leaves no room to
// lose. docs/design/011-exact.md has the arguments.

#include "search.hpp"

#include <algorithm>
#include <utility>

#include "propagation.hpp"

namespace quadmatch::exact {

bool Search::run(Rim rim, std::uint64_t limit) {
  const Partial::Mark start = partial_.mark();
  std::vector<Choice> choices;
  bool finished = true;
  for (std::uint64_t node = 0;; ++node) {
    if (node >= limit || !budget_.node() || incumbent_.enough) {
      finished = false;
      break;
    }
    Pair branch;
    if (examine(rim, branch)) {
      choices.push_back({partial_.mark(), rim, branch, left_out_.size()});
      partial_.commit(branch);
      extend(rim, partial_, branch);
      continue;
    }
    if (choices.empty()) break;
    partial_.undo(choices.back().mark);
    rim = std::move(choices.back().rim);
    const Pair left_out = choices.back().pair;
    left_out_.resize(choices.back().left_out);
    left_out_.push_back(left_out);
    choices.pop_back();
    partial_.exclude(kSource, partial_.mesh(kSource).face(left_out.source));
    partial_.exclude(kTarget, partial_.mesh(kTarget).face(left_out.target));
  }
  partial_.undo(start);
  left_out_.clear();
  return finished;
}

/// True if there is a choice to be made here; false if nothing better can be below, or all of it has been offered.
bool Search::examine(Rim& rim, Pair& branch) {
  while (true) {
    propagate(partial_, rim);
    incumbent_.offer(partial_.pairs(), {}, orientation_);
    if (rim.empty()) return false;
    if (take_in_unopposed(rim)) continue;
    Pair nearby;
    if (find_unopposed(rim, nearby)) return false;
    std::array<std::uint32_t, 2> reach{};
    if (bound_by_reach(rim, reach) == Bound::Closed || !demands_can_be_met()) return false;
    if (slits_.allowed() && take_in_costly(rim, reach)) continue;

    const Side levelled = partial_.level_side();
    development_.begin_packing(levelled);
    const SideBound inner = bound_levels(rim);
    if (inner.bound == Bound::Closed) return false;
    if (inner.bound == Bound::Tighter) continue;
    const SideBound near = bound_side(levelled, rim, reach[levelled]);
    if (near.bound == Bound::Closed) return false;
    if (near.bound == Bound::Tighter) continue;
    development_.begin_packing(other(levelled));
    const SideBound far = bound_side(other(levelled), rim, reach[other(levelled)]);
    if (far.bound == Bound::Closed) return false;
    if (far.bound == Bound::Tighter) continue;
    if (sheets_.exclude_unreached(partial_, rim)) continue;
    branch = nearby;
    if (branch.source.valid()) return true;
    branch = inner.root;
    if (!branch.source.valid()) branch = near.root.source.valid() && near.largest <= far.largest ? near.root : far.root;
    return true;
  }
}

/// Nothing can clash with these, so whatever region holds the partial one may as well hold them. True if there are any.
bool Search::take_in_unopposed(Rim& rim) {
  const std::size_t entries = rim.size();
  const std::uint32_t before = partial_.size();
  for (std::size_t k = 0; k < entries; ++k) {
    const Pair pair = beyond(partial_, rim[k]);
    if (!pair.source.valid() || !pair.target.valid() || !partial_.fits(pair)) continue;
    if (witnesses_.against(pair) != Witnesses::Answer::Impossible) continue;
    partial_.commit(pair);
    extend(rim, partial_, pair);
  }
  return partial_.size() > before;
}

/// Was a pair left out with which nothing can clash? Then all regions here could be larger. If not, the next choice is
/// best made near one with which nothing clashes yet.
bool Search::find_unopposed(const Rim& rim, Pair& nearby) const {
  for (const Pair& pair : left_out_) {
    const Witnesses::Answer answer = witnesses_.against(pair);
    if (answer == Witnesses::Answer::Impossible) return true;
    if (answer == Witnesses::Answer::Possible && !nearby.source.valid()) nearby = witnesses_.nearby(pair, rim);
  }
  return false;
}

/// Open faces that no path of open faces joins to the rim are out. Unlike a label this holds whatever else is decided.
Search::Bound Search::bound_by_reach(const Rim& rim, std::array<std::uint32_t, 2>& reach) {
  for (const Side side : {kSource, kTarget}) {
    reach[side] = development_.count_reach(side, rim);
    if (partial_.size() + reach[side] <= incumbent_.to_beat) return Bound::Closed;
    if (reach[side] == partial_.open_faces(side)) continue;
    for (std::uint32_t f = 0; f < partial_.mesh(side).face_count(); ++f) {
      if (partial_.is_open(side, FaceId(f)) && !development_.is_reached(FaceId(f))) partial_.exclude(side, FaceId(f));
    }
  }
  return Bound::Open;
}

/// Is enough open in every ring to lose what it must?
bool Search::demands_can_be_met() const {
  const std::vector<Level>& levels = partial_.levels();
  return std::all_of(levels.begin(), levels.end(), [](const Level& level) { return level.unpaid() <= level.open; });
}

/// Leaving these out would lose more than a better region can.
bool Search::take_in_costly(Rim& rim, const std::array<std::uint32_t, 2>& reach) {
  const std::uint32_t most = partial_.size() + std::min(reach[kSource], reach[kTarget]);
  development_.spread(partial_.level_side(), rim);
  return slits_.take_in(development_.labels(), rim, most - incumbent_.to_beat - 1);
}

/// From the innermost level outwards: may what it loses stay within its budget?
Search::SideBound Search::bound_levels(Rim& rim) {
  SideBound bound;
  std::uint32_t out = 0, open = 0;
  for (auto level = static_cast<std::uint32_t>(partial_.levels().size()); level-- > 1;) {
    out += partial_.levels()[level].out;
    open += partial_.levels()[level].open;
    if (out > partial_.levels()[level].budget) return {.bound = Bound::Closed};
    if (open == 0) continue;
    const SideBound here = bound_level(level, out, rim);
    if (here.bound != Bound::Open) return here;
    if (!bound.root.source.valid()) bound.root = here.root;
  }
  return bound;
}

Search::SideBound Search::bound_level(std::uint32_t level, std::uint32_t out, Rim& rim) {
  const std::uint32_t left = partial_.levels()[level].budget - out;
  const Packing packing = development_.pack(level, rim, left + 1);
  if (packing.losses > left) return {.bound = Bound::Closed};
  const Bound forced = packing.losses == left ? force(partial_.level_side(), level, rim) : Bound::Open;
  return {.bound = forced, .root = packing.root};
}

/// All that can be reached, less what is lost of it.
Search::SideBound Search::bound_side(Side side, Rim& rim, std::uint32_t reach) {
  const std::uint32_t most = partial_.size() + reach;
  const Packing packing = development_.pack(0, rim, most - incumbent_.to_beat);
  if (packing.free_of_conflict) {
    offer_development();
    return {.bound = Bound::Closed, .largest = most};
  }
  const std::uint32_t largest = most - std::min(most, packing.losses);
  if (largest <= incumbent_.to_beat) return {.bound = Bound::Closed, .largest = largest};
  const Bound forced = largest == incumbent_.to_beat + 1 ? force(side, 0, rim) : Bound::Open;
  return {.bound = forced, .largest = largest, .root = packing.root};
}

/// Nothing that can be reached clashes: the partial region and its development are a region, the largest here.
void Search::offer_development() { incumbent_.offer(partial_.pairs(), development_.labels(), orientation_); }

/// A better region loses what the last packing counted and nothing else: take in the faces beyond the rim that it did
/// not count. Closed where one does not fit those before it.
Search::Bound Search::force(Side side, std::uint32_t level, Rim& rim) {
  const std::size_t entries = rim.size();
  const std::uint32_t before = partial_.size();
  for (std::size_t k = 0; k < entries; ++k) {
    const Pair pair = beyond(partial_, rim[k]);
    const HalfedgeId here = half(pair, side);
    if (!here.valid()) continue;
    const FaceId face = partial_.mesh(side).face(here);
    if (!partial_.is_open(side, face) || development_.may_be_lost(face)) continue;
    if (level > 0 && (partial_.level(side, face) == Partial::kNoLevel || partial_.level(side, face) < level)) continue;
    if (!half(pair, other(side)).valid() || !partial_.fits(pair)) return Bound::Closed;
    partial_.commit(pair);
    extend(rim, partial_, pair);
  }
  return partial_.size() > before ? Bound::Tighter : Bound::Open;
}

}  // namespace quadmatch::exact
