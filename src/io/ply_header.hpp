#pragma once
/// The header of a PLY file: which elements follow, and of which numbers each is made.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/mesh/expected.hpp>

#include "line_scanner.hpp"

namespace quadmatch::io {

struct PlyProperty {
  std::string name;
  ScalarType type = ScalarType::Float32;
  std::optional<ScalarType> count_type;  ///< of a list
};

struct PlyElement {
  std::string name;
  std::uint32_t count = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> comments;
  std::vector<std::string> object_infos;
};

/// Bytes that a number takes in a binary file: 1, 2, 4 or 8.
[[nodiscard]] std::size_t size_of(ScalarType type);
[[nodiscard]] bool is_real(ScalarType type);
/// The name under which we write a type.
[[nodiscard]] const char* ply_name(ScalarType type);

/// Read the header; the scanner then stands at the first byte of the body.
/// @par Errors  Syntax, BadNumber, TooLarge, Truncated, with the line.
[[nodiscard]] Expected<PlyHeader> read_ply_header(LineScanner& scanner, const std::string& name);

}  // namespace quadmatch::io
