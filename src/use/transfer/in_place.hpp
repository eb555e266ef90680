#pragma once
/// Which faces positions place where connectivity leaves a choice.

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {

/// Tells whether a face did not move: each corner lies where its partner lies, and no other vertex of the source lies
/// there. Any other partner would be another place.
class InPlace {
 public:
  /// @par Cost  O(#V log #V)
  InPlace(const Mesh& source, const Mesh& target);

  /// Never true where one of the meshes has no positions.
  [[nodiscard]] bool holds(const FacePair& pair, Orientation orientation) const;

 private:
  const Mesh& source_;
  const Mesh& target_;
  PerVertex<std::uint8_t> shares_its_place_;  // of the source; empty without positions
};

}  // namespace quadmatch::use
