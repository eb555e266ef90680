#pragma once
/// What a vertex looks like from where it stands (§2.1): valence, boundary, and whether all its faces are quads.

#include <cstdint>

#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch {

/// 4 * valence + 2 if on the boundary + 1 if a face of other than four corners touches it; 0 where no face does.
/// Valences above 16,382 share one code.
struct VertexCode {
  std::uint16_t value = 0;

  [[nodiscard]] std::uint32_t valence() const { return value / 4U; }
  [[nodiscard]] bool on_boundary() const { return (value & 2U) != 0; }
  [[nodiscard]] bool touches_non_quad() const { return (value & 1U) != 0; }
  /// §2.1: valence other than 4 inside, other than 3 on the boundary; and wherever a non-quad touches.
  [[nodiscard]] bool extraordinary() const {
    return value != 0 && value != kRegularInside && value != kRegularOnBoundary;
  }
  bool operator==(const VertexCode&) const = default;

  static constexpr std::uint16_t kRegularInside = 4 * 4;
  static constexpr std::uint16_t kRegularOnBoundary = 4 * 3 + 2;
};

/// The code of every fan. O(#corners).
[[nodiscard]] PerFan<VertexCode> vertex_codes(const Mesh& mesh);

}  // namespace quadmatch
