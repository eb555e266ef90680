#pragma once
/// The ordinary lines of large OBJ files, read in few steps: numbers divided by spaces, indices that count forwards.
/// Each function reads a whole line or, whatever is odd or wrong about it, none: the careful reader has the words for
/// it.

#include <cstdint>

#include "number.hpp"

namespace quadmatch::io {

/// @return  the beginning of the next line if this one ends here, nullptr if not.
[[nodiscard]] inline const char* end_plain_line(const char* here) {
  while (*here == ' ') ++here;
  if (*here == '\r') ++here;
  return *here == '\n' ? here + 1 : nullptr;
}

/// So many numbers and nothing else.
/// @param here  behind the keyword.
/// @return      the beginning of the next line, nullptr if this is no such line.
[[nodiscard]] inline const char* read_plain_reals(const char* here, double* values, std::uint32_t count) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (*here != ' ') return nullptr;
    while (*here == ' ') ++here;
    here = parse_real(here, values[i]);
    if (here == nullptr) return nullptr;
  }
  return end_plain_line(here);
}

/// An index of one to eight digits, counted from 0: what the file calls 0 becomes 2^32 - 1.
/// @return  one past it, nullptr if there is none.
[[nodiscard]] inline const char* read_plain_index(const char* here, std::uint32_t& index) {
  const Digits digits = leading_digits(here);
  index = digits.value - 1;
  return digits.count == 0 || is_digit(here[digits.count]) ? nullptr : here + digits.count;
}

/// The corners of a face, as the columns v, vt and vn of the file, from 0.
struct PlainFace {
  static constexpr std::uint32_t kMostCorners = 8;
  static constexpr std::uint32_t kNoIndex = 0xffffffff;

  std::uint32_t size = 0;
  bool has_texture = false;
  bool has_normals = false;
  std::uint32_t vertex[kMostCorners];
  std::uint32_t texture[kMostCorners];
  std::uint32_t normal[kMostCorners];
};

/// How many elements stand above a face, which are all that it may name in an ordinary line.
struct PlainLimits {
  std::uint32_t vertices, texture, normals;
};

/// A face of three to eight corners v, v/vt, v//vn or v/vt/vn.
/// @param here  behind the keyword.
/// @return      the beginning of the next line, nullptr if this is no such line.
[[nodiscard]] inline const char* read_plain_face(const char* here, const PlainLimits& limits, PlainFace& face) {
  std::uint32_t size = 0;
  bool has_texture = false, has_normals = false;
  while (*here == ' ') {
    while (*here == ' ') ++here;
    if (*here == '\n' || *here == '\r') break;
    if (size == PlainFace::kMostCorners) return nullptr;
    std::uint32_t vertex = 0, texture = PlainFace::kNoIndex, normal = PlainFace::kNoIndex;
    here = read_plain_index(here, vertex);
    if (here == nullptr || vertex >= limits.vertices) return nullptr;
    if (*here == '/') {
      if (*++here != '/') {
        here = read_plain_index(here, texture);
        if (here == nullptr || texture >= limits.texture) return nullptr;
        has_texture = true;
      }
      if (*here == '/') {
        here = read_plain_index(here + 1, normal);
        if (here == nullptr || normal >= limits.normals) return nullptr;
        has_normals = true;
      }
    }
    face.vertex[size] = vertex;
    face.texture[size] = texture;
    face.normal[size] = normal;
    ++size;
  }
  face.size = size;
  face.has_texture = has_texture;
  face.has_normals = has_normals;
  return size < 3 ? nullptr : end_plain_line(here);
}

}  // namespace quadmatch::io
