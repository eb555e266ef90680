#pragma once
/// The body of a PLY file: one table of numbers for each element, from text or bytes of either order.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <quadmatch/io/mesh_file.hpp>
#include <quadmatch/mesh/expected.hpp>

#include "line_scanner.hpp"
#include "ply_header.hpp"

namespace quadmatch::io {

/// All elements of one kind, column by column.
struct PlyTable {
  std::string name;
  std::uint32_t count = 0;
  std::vector<Property> columns;
  /// In a text file, the scanner before the first row, from which `line_of_row` finds the others.
  std::optional<LineScanner> start;

  /// The line of a row, for messages; 0 in a binary file. Counts from the first row on.
  [[nodiscard]] std::uint64_t line_of_row(std::uint32_t row) const;
  /// Take the column of this name out of the table.
  [[nodiscard]] std::optional<Property> take(std::string_view column);
};

struct PlyBody {
  std::vector<PlyTable> tables;  ///< in the order of the file
  bool data_left = false;        ///< whether more follows than the header declares
};

/// Read the body of a file. Memory is bounded by the bytes that are there, whatever the header promises.
/// @par Errors  Truncated, Syntax, BadNumber, TooLarge; with the line, or in a binary file with the element's number.
[[nodiscard]] Expected<PlyBody> read_ply_body(LineScanner& scanner, const PlyHeader& header, const std::string& name);

}  // namespace quadmatch::io
