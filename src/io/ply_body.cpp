#include "ply_body.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "formats.hpp"

namespace quadmatch::io {
namespace {

template <class T>
double decode_as(const char* bytes, bool swap) {
  char ordered[sizeof(T)];
  std::memcpy(ordered, bytes, sizeof(T));
  if (swap) std::reverse(ordered, ordered + sizeof(T));
  T value;
  std::memcpy(&value, ordered, sizeof(T));
  return static_cast<double>(value);
}

double decode(const char* bytes, ScalarType type, bool swap) {
  switch (type) {
    case ScalarType::Int8:
      return decode_as<std::int8_t>(bytes, swap);
    case ScalarType::UInt8:
      return decode_as<std::uint8_t>(bytes, swap);
    case ScalarType::Int16:
      return decode_as<std::int16_t>(bytes, swap);
    case ScalarType::UInt16:
      return decode_as<std::uint16_t>(bytes, swap);
    case ScalarType::Int32:
      return decode_as<std::int32_t>(bytes, swap);
    case ScalarType::UInt32:
      return decode_as<std::uint32_t>(bytes, swap);
    case ScalarType::Float32:
      return decode_as<float>(bytes, swap);
    case ScalarType::Float64:
      break;
  }
  return decode_as<double>(bytes, swap);
}

/// Is this a whole number that the type can hold?
bool fits_type(double value, ScalarType type) {
  const int bits = static_cast<int>(8 * size_of(type));
  const bool is_signed = type == ScalarType::Int8 || type == ScalarType::Int16 || type == ScalarType::Int32;
  const double least = is_signed ? -std::ldexp(1.0, bits - 1) : 0;
  const double most = std::ldexp(1.0, is_signed ? bits - 1 : bits) - 1;
  return value >= least && value <= most && value == std::floor(value);
}

/// `nan`, `inf` and their kin as C libraries print them: legal in properties that are not positions.
std::optional<double> not_finite(std::string_view token) {
  const bool negative = !token.empty() && token.front() == '-';
  if (!token.empty() && (negative || token.front() == '+')) token.remove_prefix(1);
  std::string word(token);
  std::transform(word.begin(), word.end(), word.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  if (word == "nan") return std::numeric_limits<double>::quiet_NaN();
  if (word != "inf" && word != "infinity") return std::nullopt;
  return negative ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

class BodyReader {
 public:
  BodyReader(LineScanner& scanner, const PlyHeader& header, const std::string& name)
      : scanner_(scanner),
        text_(header.encoding == PlyEncoding::Ascii),
        swap_((header.encoding == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big)),
        name_(name) {}

  Expected<PlyTable> read(const PlyElement& element);

 private:
  void begin_table(const PlyElement& element);
  bool read_row();
  bool read_property(Property& column);
  bool take_value(ScalarType type, double& value);
  bool take_text_value(ScalarType type, double& value);
  bool take_text_real(ScalarType type, double& value);
  bool fail(ErrorCode code, std::string message) {
    error_ = {code, std::move(message), name_, text_ ? scanner_.line() : 0};
    return false;
  }
  bool fail_number() {
    return fail(ErrorCode::BadNumber,
                fmt::format("{} does not fit its type in the header; {}", in_quotes(scanner_.peek_token()), kMend));
  }
  /// "vertex 5 of 8"
  [[nodiscard]] std::string whereabouts() const {
    return fmt::format("{} {} of {}", table_.name, row_ + 1, table_.count);
  }

  LineScanner& scanner_;
  const bool text_;
  const bool swap_;
  const std::string& name_;
  Error error_;
  PlyTable table_;
  std::uint32_t row_ = 0;
};

void BodyReader::begin_table(const PlyElement& element) {
  table_ = {.name = element.name, .count = element.count, .columns = {}, .start = {}};
  if (text_) table_.start = scanner_;
  // No row is smaller than this, so the bytes left bound what is worth reserving.
  std::size_t row_size = 0;
  for (const PlyProperty& property : element.properties) {
    row_size += text_ ? 2 : size_of(property.count_type.value_or(property.type));
  }
  const std::size_t rows =
      std::min<std::size_t>(element.count, scanner_.remaining() / std::max<std::size_t>(row_size, 1) + 1);
  for (const PlyProperty& property : element.properties) {
    Property column{.name = property.name, .type = property.type, .count_type = property.count_type};
    if (column.count_type) column.list_starts.reserve(rows + 1);
    if (column.count_type) column.list_starts.push_back(0);
    column.values.reserve(rows);
    table_.columns.push_back(std::move(column));
  }
}

Expected<PlyTable> BodyReader::read(const PlyElement& element) {
  begin_table(element);
  for (row_ = 0; row_ < table_.count; ++row_) {
    if (!read_row()) return Unexpected(std::move(error_));
  }
  return std::move(table_);
}

bool BodyReader::read_row() {
  while (text_ && !scanner_.at_end() && scanner_.data_ends()) scanner_.next_line();
  if (scanner_.at_end()) {
    return fail(ErrorCode::Truncated, fmt::format("the file ends before {}; export the mesh again", whereabouts()));
  }
  for (Property& column : table_.columns) {
    if (!read_property(column)) return false;
  }
  if (!text_) return true;
  if (!scanner_.data_ends()) {
    return fail(ErrorCode::Syntax,
                fmt::format("{} has more numbers than the header and its list counts allow; {}", whereabouts(), kMend));
  }
  scanner_.next_line();
  return true;
}

bool BodyReader::read_property(Property& column) {
  double value = 0;
  if (!column.count_type) {
    if (!take_value(column.type, value)) return false;
    column.values.push_back(value);
    return true;
  }
  if (!take_value(*column.count_type, value)) return false;
  if (value < 0) {
    return fail(ErrorCode::BadNumber, fmt::format("{} has a list of {} values; {}", whereabouts(), value, kMend));
  }
  const std::uint64_t count = static_cast<std::uint64_t>(value);
  if (column.values.size() + count > std::numeric_limits<std::uint32_t>::max()) {
    return fail(ErrorCode::TooLarge, fmt::format("property '{}' has more than 4,294,967,295 values; split the mesh",
                                                 in_quotes(column.name)));
  }
  for (std::uint64_t i = 0; i < count; ++i) {
    if (!take_value(column.type, value)) return false;
    column.values.push_back(value);
  }
  column.list_starts.push_back(static_cast<std::uint32_t>(column.values.size()));
  return true;
}

bool BodyReader::take_value(ScalarType type, double& value) {
  if (text_) return take_text_value(type, value);
  const std::size_t size = size_of(type);
  if (scanner_.remaining() < size) {
    return fail(ErrorCode::Truncated, fmt::format("the file ends within {}; export the mesh again", whereabouts()));
  }
  value = decode(scanner_.here(), type, swap_);
  scanner_.skip_bytes(size);
  return true;
}

bool BodyReader::take_text_value(ScalarType type, double& value) {
  if (scanner_.data_ends()) {
    return fail(ErrorCode::Syntax, fmt::format("{} has fewer numbers than the header and its list counts ask for; {}",
                                               whereabouts(), kMend));
  }
  if (is_real(type)) return take_text_real(type, value);
  // Some exporters write whole numbers as 255.0: what counts is the value.
  const LineScanner before = scanner_;
  if (!scanner_.take_real(value)) return fail_number();
  if (fits_type(value, type)) return true;
  scanner_ = before;
  return fail_number();
}

bool BodyReader::take_text_real(ScalarType type, double& value) {
  float single = 0;
  const bool is_single = type == ScalarType::Float32;
  if (is_single ? scanner_.take_real(single) : scanner_.take_real(value)) {
    if (is_single) value = static_cast<double>(single);
    return true;
  }
  const std::optional<double> special = not_finite(scanner_.peek_token());
  if (!special) return fail_number();
  value = *special;
  static_cast<void>(scanner_.take_token());
  return true;
}

}  // namespace

std::uint64_t PlyTable::line_of_row(std::uint32_t row) const {
  if (!start) return 0;
  LineScanner scanner = *start;
  for (std::uint64_t rows = 0;; scanner.next_line()) {
    if (scanner.data_ends()) continue;
    if (rows++ == row) return scanner.line();
  }
}

std::optional<Property> PlyTable::take(std::string_view column) {
  const auto found =
      std::find_if(columns.begin(), columns.end(), [column](const Property& p) { return p.name == column; });
  if (found == columns.end()) return std::nullopt;
  Property taken = std::move(*found);
  columns.erase(found);
  return taken;
}

Expected<PlyBody> read_ply_body(LineScanner& scanner, const PlyHeader& header, const std::string& name) {
  PlyBody body;
  BodyReader reader(scanner, header, name);
  for (const PlyElement& element : header.elements) {
    Expected<PlyTable> table = reader.read(element);
    if (!table) return Unexpected(std::move(table).error());
    body.tables.push_back(std::move(*table));
  }
  const bool text = header.encoding == PlyEncoding::Ascii;
  while (text && !scanner.at_end() && scanner.data_ends()) scanner.next_line();
  body.data_left = !scanner.at_end();
  return body;
}

}  // namespace quadmatch::io
