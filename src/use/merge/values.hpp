#pragma once
/// Values of elements, merged three-way: the one of the side that changed it.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/use/merge.hpp>

#include "cells.hpp"

namespace quadmatch::use {

/// An element of the result: its number in each of the meshes, or kNowhere. At least one side has it.
struct Origin {
  std::array<std::uint32_t, 3> in;

  static constexpr std::uint32_t kNowhere = 0xffffffffU;

  [[nodiscard]] std::uint32_t operator[](Side side) const { return in[static_cast<std::size_t>(side)]; }
  [[nodiscard]] bool has(Side side) const { return (*this)[side] != kNowhere; }
};

/// @param only  as if no other than this side had it.
template <class Id>
[[nodiscard]] Origin origin_of(const InThree<Id>& in, bool only, Side side) {
  Origin origin{{in.in[0].value, in.in[1].value, in.in[2].value}};
  for (const Side another : kSides) {
    if (only && another != side) origin.in[static_cast<std::size_t>(another)] = Origin::kNowhere;
  }
  return origin;
}

/// The elements of the result in its order, by domain.
struct Origins {
  std::vector<Origin> vertices, faces, corners;

  [[nodiscard]] const std::vector<Origin>& of(Domain domain) const {
    return domain == Domain::Vertex ? vertices : domain == Domain::Face ? faces : corners;
  }
};

/// Of which side each element of the result has its value.
struct Picks {
  std::vector<Side> sides;
  std::uint32_t ours_changed = 0, theirs_changed = 0;  ///< elements of the base whose value is another there
  MergedAttribute report;
  ValueConflict conflict;

  [[nodiscard]] bool any(Side side) const { return std::find(sides.begin(), sides.end(), side) != sides.end(); }
};

/// @param same  whether element a of one mesh has the value of element b of another: (Side, a, Side, b).
template <class Same>
[[nodiscard]] Picks pick(const std::string& name, Domain domain, const std::vector<Origin>& origins, Side preferred,
                         const Same& same) {
  constexpr std::size_t kMostTold = 10;
  Picks picks;
  picks.report = {name, domain};
  picks.conflict = {name, domain};
  picks.sides.reserve(origins.size());
  for (std::uint32_t k = 0; k < origins.size(); ++k) {
    const Origin& at = origins[k];
    const auto changed = [&](Side side) {
      return at.has(Side::Base) && at.has(side) && !same(Side::Base, at[Side::Base], side, at[side]);
    };
    const bool ours = changed(Side::Ours), theirs = changed(Side::Theirs);
    picks.ours_changed += ours ? 1 : 0;
    picks.theirs_changed += theirs ? 1 : 0;
    Side side = Side::Ours;
    if (!at.has(Side::Ours)) {
      side = Side::Theirs;
    } else if (at.has(Side::Theirs) && !same(Side::Ours, at[Side::Ours], Side::Theirs, at[Side::Theirs])) {
      const bool both = !at.has(Side::Base) || (ours && theirs);
      side = both ? preferred : theirs ? Side::Theirs : Side::Ours;
      if (both && picks.conflict.count++ < kMostTold) picks.conflict.first.push_back(k);
    }
    picks.sides.push_back(side);
    if (side == Side::Ours ? ours : theirs) ++(side == Side::Ours ? picks.report.from_ours : picks.report.from_theirs);
  }
  return picks;
}

using ThreeFiles = std::array<const MeshFile*, 3>;

[[nodiscard]] inline const MeshFile& file_of(const ThreeFiles& files, Side side) {
  return *files[static_cast<std::size_t>(side)];
}

/// What came of a kind of data, beside the data: whether a side changed any, and what is to be told.
struct ValueTally {
  bool ours_changed = false, theirs_changed = false;
  std::vector<MergedAttribute> attributes;
  std::vector<ValueConflict> conflicts;

  void enter(const Picks& picks);
  void enter_remark(const std::string& name, Domain domain, std::string remark);
};

/// Properties of the result: those of OURS in their order, then those that THEIRS added. One that a side dropped is
/// dropped, with a remark. An element whose side has no such property gets 0 or an empty list.
/// @param passed_over  properties that are data of corners (texture_lists.hpp).
[[nodiscard]] std::vector<Property> merge_properties(const ThreeFiles& files,
                                                     const std::array<const Property*, 3>& passed_over,
                                                     const Origins& origins, Side preferred, ValueTally& tally);

struct MergedPool {
  IndexedAttribute attribute;
  std::array<std::vector<std::uint32_t>, 3> places;  ///< where each entry of a side's pool is now, or kNoIndex
};

/// Data of corners. The pool has the entries of OURS in its order and then those of THEIRS. What shares an entry in
/// THEIRS shares one here, of OURS where both say the same at some corner.
/// @param pools  of the three, each null where the file has none; one of the sides has one.
[[nodiscard]] MergedPool merge_pools(const std::string& name, const std::array<const IndexedAttribute*, 3>& pools,
                                     const std::vector<Origin>& corners, Side preferred, ValueTally& tally);

}  // namespace quadmatch::use
