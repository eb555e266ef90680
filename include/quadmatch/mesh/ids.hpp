#pragma once
/// Typed 32-bit ids: a vertex, a half-edge and a face cannot be confused, and each prints as `v3`, `h12`, `f7`.

#include <compare>
#include <cstdint>
#include <limits>
#include <string>

namespace quadmatch {

template <class Tag>
struct Id {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t value = kNone;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t number) : value(number) {}

  /// False for the id of nothing, e.g. the twin of a boundary half-edge.
  [[nodiscard]] constexpr bool valid() const { return value != kNone; }
  constexpr auto operator<=>(const Id&) const = default;
};

/// A `v` record of the file, counted from 0.
using VertexId = Id<struct VertexTag>;
/// A directed side of a face, and equally the corner it leaves from. Ids run face by face.
using HalfedgeId = Id<struct HalfedgeTag>;
/// An edge, named by the lowest of its half-edges.
using EdgeId = Id<struct EdgeTag>;
/// An `f` record of the file, counted from 0.
using FaceId = Id<struct FaceTag>;
/// A fan: the faces around a vertex that hang together across edges. A manifold vertex has one fan, of the same number.
using FanId = Id<struct FanTag>;

struct VertexTag {
  static constexpr char letter = 'v';
};
struct HalfedgeTag {
  static constexpr char letter = 'h';
};
struct EdgeTag {
  static constexpr char letter = 'e';
};
struct FaceTag {
  static constexpr char letter = 'f';
};
struct FanTag {
  static constexpr char letter = 'p';
};

template <class Tag>
[[nodiscard]] std::string to_string(Id<Tag> id) {
  return id.valid() ? Tag::letter + std::to_string(id.value) : std::string("none");
}

}  // namespace quadmatch
