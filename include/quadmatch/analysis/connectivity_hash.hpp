#pragma once
/// A name for what a mesh is, however it is numbered: two meshes have the same hash if they are the same, and only
/// then.

#include <array>
#include <compare>
#include <cstdint>
#include <string>

#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch {

/// A SHA-1 digest of 160 bits. Nobody has met two different texts with the same one by chance; they can be made on
/// purpose, at great cost, so this is a name and no proof against forgery.
struct Digest {
  std::array<std::uint8_t, 20> bytes = {};

  /// 40 lower-case hexadecimal digits.
  [[nodiscard]] std::string hex() const;
  auto operator<=>(const Digest&) const = default;
};

/// The hashes of a mesh and of its mirror image.
struct ConnectivityHash {
  /// The same for two meshes exactly if an isomorphism preserves orientation (see find_isomorphism).
  Digest oriented;
  /// That of the mirror image; the same as `oriented` where the mesh is its own mirror image.
  Digest mirrored;

  /// The lesser of the two: the same for two meshes exactly if there is an isomorphism that preserves or reverses
  /// orientation.
  [[nodiscard]] const Digest& unoriented() const { return oriented < mirrored ? oriented : mirrored; }
  bool operator==(const ConnectivityHash&) const = default;
};

/// Hash the connectivity of a mesh: faces, which corners share a vertex, how many vertices are unused; no positions.
/// The same on every machine. What is digested is the canonical form (docs/design/012-isomorphism.md), under a heading
/// that bears a version; another version of quadmatch that changes the form changes the version.
///
/// @par Cost  as of count_automorphisms, and the digest: O(#corners).
[[nodiscard]] ConnectivityHash connectivity_hash(const Mesh& mesh);

}  // namespace quadmatch
