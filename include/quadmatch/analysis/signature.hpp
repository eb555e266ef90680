#pragma once
/// A short signature of a mesh's connectivity: how much two meshes share shows in how much their signatures do.

#include <cstdint>
#include <vector>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// The lowest of a mesh's elements, in an order that is random but the same for all meshes (Broder's bottom-k MinHash).
///
/// An element is something that the mesh has, such as "four spokes whose surroundings look like this". Elements of a
/// large mesh and of an edited copy are for the most part the same, and so is a sample of the lowest of them.
struct Signature {
  /// How many elements the mesh has.
  std::uint32_t elements = 0;
  /// Names of the lowest of them, min(elements, most) numbers of 32 bits, from the lowest on. Two different elements
  /// have one name once in 4,294,967,296 times.
  std::vector<std::uint32_t> values = {};

  bool operator==(const Signature&) const = default;
};

/// The signature of a mesh. It depends on neither numbering nor positions, and a mirror image has the same.
///
/// Elements are the colours of spokes (see colour_spokes) after one, two and three rounds, with arc lengths and
/// without. The first survive edits nearby, the last tell models apart; without arc lengths they survive inserted edge
/// loops, with them they tell regular models apart. A colour that occurs often counts several times, by the powers of
/// two it reaches. A mesh without extraordinary vertices has its size as its only elements.
///
/// @param most  how many values are kept; the signature of fewer is the beginning of that of more.
/// @par Source  ours; Broder, On the resemblance and containment of documents (1997).
/// @par Cost    O(E + S log S) for E edges and S spokes.
[[nodiscard]] Signature signature_of(const Mesh& mesh, std::uint32_t most);

}  // namespace quadmatch
