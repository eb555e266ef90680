#pragma once
/// Vertices that two shapes in the making share because they lie at the same point of a lattice.

#include <array>
#include <map>

#include "soup_builder.hpp"

namespace quadmatch::shapes {

class Lattice {
 public:
  using Index = std::array<int, 3>;

  /// The vertex at a lattice point, made at the first asking; `position` says where it lies.
  template <class Position>
  VertexId at(SoupBuilder& builder, const Index& index, Position position) {
    const auto [entry, is_new] = vertices_.try_emplace(index);
    if (is_new) entry->second = builder.vertex(position(index));
    return entry->second;
  }

 private:
  std::map<Index, VertexId> vertices_;
};

}  // namespace quadmatch::shapes
