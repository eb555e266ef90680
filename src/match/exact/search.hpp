#pragma once
/// Every region that holds a partial one and is better than the best so far: found, or shown not to exist.

#include <vector>

#include "development.hpp"
#include "incumbent.hpp"
#include "partial.hpp"
#include "sheets.hpp"
#include "slits.hpp"
#include "witnesses.hpp"

namespace quadmatch::exact {

class Search {
 public:
  Search(Partial& partial, Orientation orientation, Incumbent& incumbent, Budget& budget)
      : partial_(partial),
        orientation_(orientation),
        incumbent_(incumbent),
        budget_(budget),
        development_(partial),
        sheets_(partial),
        faces_at_(partial),
        witnesses_(partial, faces_at_),
        slits_(partial, faces_at_) {}

  /// Search below what is committed now, and leave it as it was.
  /// @param rim    where the partial region can grow.
  /// @param limit  nodes at most.
  /// @return       true if there is no better region left below; false where the limit came first.
  bool run(Rim rim, std::uint64_t limit);

 private:
  /// A choice that was made: the pair was taken in, and is still to be left out.
  struct Choice {
    Partial::Mark mark;
    Rim rim;
    Pair pair;
    std::size_t left_out;  // pairs that had been left out before
  };
  enum class Bound { Closed, Tighter, Open };
  struct SideBound {
    Bound bound = Bound::Open;
    std::uint32_t largest = 0;  // size of a region below, at most
    Pair root = {};             // of the first conflict, if any
  };

  bool examine(Rim& rim, Pair& branch);
  bool take_in_unopposed(Rim& rim);
  bool find_unopposed(const Rim& rim, Pair& nearby) const;
  void offer_development();
  Bound bound_by_reach(const Rim& rim, std::array<std::uint32_t, 2>& reach);
  [[nodiscard]] bool demands_can_be_met() const;
  bool take_in_costly(Rim& rim, const std::array<std::uint32_t, 2>& reach);
  SideBound bound_levels(Rim& rim);
  SideBound bound_level(std::uint32_t level, std::uint32_t out, Rim& rim);
  SideBound bound_side(Side side, Rim& rim, std::uint32_t reach);
  Bound force(Side side, std::uint32_t level, Rim& rim);

  Partial& partial_;
  Orientation orientation_;
  Incumbent& incumbent_;
  Budget& budget_;
  Development development_;
  Sheets sheets_;
  FacesAt faces_at_;
  Witnesses witnesses_;
  Slits slits_;
  std::vector<Pair> left_out_;  // by choice, above the node that is examined
};

}  // namespace quadmatch::exact
