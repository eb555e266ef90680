// Depth first: take the pair at the root of the first conflict in, or leave both its faces out. Each node propagates,
// bounds both sides by what can be reached less a packing of conflict sets, and forces what the bound leaves no room to
// lose. docs/design/011-exact.md has the arguments.

#include "search.hpp"

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
      choices.push_back({partial_.mark(), rim, branch});
      partial_.commit(branch);
      extend(rim, partial_, branch);
      continue;
    }
    if (choices.empty()) break;
    partial_.undo(choices.back().mark);
    rim = std::move(choices.back().rim);
    const Pair left_out = choices.back().pair;
    choices.pop_back();
    partial_.exclude(kSource, partial_.mesh(kSource).face(left_out.source));
    partial_.exclude(kTarget, partial_.mesh(kTarget).face(left_out.target));
  }
  partial_.undo(start);
  return finished;
}

/// True if there is a choice to be made here; false if nothing better can be below, or all of it has been offered.
bool Search::examine(Rim& rim, Pair& branch) {
  while (true) {
    if (!propagate(partial_, rim)) return false;
    incumbent_.offer(partial_.pairs(), {}, orientation_);
    if (rim.empty()) return false;
    std::array<std::uint32_t, 2> reach{};
    if (const Bound bound = bound_by_reach(rim, reach); bound == Bound::Closed) return false;

    const Side first = reach[kSource] <= reach[kTarget] ? kSource : kTarget;
    const SideBound near = bound_side(first, rim, reach[first]);
    if (near.bound == Bound::Closed) return false;
    if (near.bound == Bound::Tighter) continue;
    const SideBound far = bound_side(other(first), rim, reach[other(first)]);
    if (far.bound == Bound::Closed) return false;
    if (far.bound == Bound::Tighter) continue;
    if (sheets_.exclude_unreached(partial_, rim)) continue;
    branch = near.largest <= far.largest ? near.root : far.root;
    return true;
  }
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

Search::SideBound Search::bound_side(Side side, Rim& rim, std::uint32_t reach) {
  const std::uint32_t most = partial_.size() + reach;
  const Packing packing = development_.pack(side, rim, most - incumbent_.to_beat);
  if (packing.free_of_conflict) {
    offer_development();
    return {Bound::Closed, most, {}};
  }
  const std::uint32_t largest = most - packing.sets;
  if (largest <= incumbent_.to_beat) return {Bound::Closed, largest, {}};
  if (largest == incumbent_.to_beat + 1) {
    // A better region loses one face of each set and nothing else.
    const std::uint32_t before = partial_.size();
    if (!force_unpacked(side, rim)) return {Bound::Closed, largest, {}};
    if (partial_.size() > before) return {Bound::Tighter, largest, {}};
  }
  return {Bound::Open, largest, packing.root};
}

/// Nothing that can be reached clashes: the partial region and its development are a region, the largest here.
void Search::offer_development() { incumbent_.offer(partial_.pairs(), development_.labels(), orientation_); }

/// Take in the faces beyond the rim that are in no packed set. False where one does not fit those before it.
bool Search::force_unpacked(Side side, Rim& rim) {
  const std::size_t entries = rim.size();
  for (std::size_t k = 0; k < entries; ++k) {
    const Pair pair = beyond(partial_, rim[k]);
    const HalfedgeId here = half(pair, side);
    if (!here.valid()) continue;
    const FaceId face = partial_.mesh(side).face(here);
    if (!partial_.is_open(side, face) || development_.is_packed(face)) continue;
    if (!half(pair, other(side)).valid() || !partial_.fits(pair)) return false;
    partial_.commit(pair);
    extend(rim, partial_, pair);
  }
  return true;
}

}  // namespace quadmatch::exact
