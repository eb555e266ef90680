#include "ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "formats.hpp"

namespace quadmatch::io {
namespace {

struct TypeNames {
  ScalarType type;
  const char* name;
  const char* modern_name;
  std::size_t size;
};

/// In the order of ScalarType.
constexpr std::array<TypeNames, 8> kTypes = {{{ScalarType::Int8, "char", "int8", 1},
                                              {ScalarType::UInt8, "uchar", "uint8", 1},
                                              {ScalarType::Int16, "short", "int16", 2},
                                              {ScalarType::UInt16, "ushort", "uint16", 2},
                                              {ScalarType::Int32, "int", "int32", 4},
                                              {ScalarType::UInt32, "uint", "uint32", 4},
                                              {ScalarType::Float32, "float", "float32", 4},
                                              {ScalarType::Float64, "double", "float64", 8}}};

std::optional<ScalarType> type_named(std::string_view name) {
  for (const TypeNames& type : kTypes) {
    if (name == type.name || name == type.modern_name) return type.type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(LineScanner& scanner, const std::string& name) : scanner_(scanner), name_(name) {}
  Expected<PlyHeader> read();

 private:
  bool read_line(std::string_view keyword);
  bool read_format();
  bool read_element();
  bool read_property();
  std::optional<ScalarType> take_type();
  bool names_are_unique();
  bool fail(ErrorCode code, std::string message) {
    error_ = {code, std::move(message), name_, scanner_.line()};
    return false;
  }

  LineScanner& scanner_;
  const std::string& name_;
  Error error_;
  PlyHeader header_;
  bool has_format_ = false;
};

Expected<PlyHeader> HeaderReader::read() {
  if (scanner_.take_token() != "ply") {
    fail(ErrorCode::Syntax, "a PLY file begins with the line 'ply'; check the name or export the mesh again");
    return Unexpected(std::move(error_));
  }
  scanner_.next_line();
  for (bool ended = false; !ended; scanner_.next_line()) {
    if (scanner_.at_end()) {
      fail(ErrorCode::Truncated, "the file ends before 'end_header'; export the mesh again");
      return Unexpected(std::move(error_));
    }
    const std::string_view keyword = scanner_.take_token();
    ended = keyword == "end_header";
    if (!ended && !read_line(keyword)) return Unexpected(std::move(error_));
  }
  if (!has_format_) {
    fail(ErrorCode::Syntax, fmt::format("the header has no line 'format'; {}", kMend));
    return Unexpected(std::move(error_));
  }
  if (!names_are_unique()) return Unexpected(std::move(error_));
  return std::move(header_);
}

bool HeaderReader::read_line(std::string_view keyword) {
  if (keyword == "format") return read_format();
  if (keyword == "element") return read_element();
  if (keyword == "property") return read_property();
  if (keyword == "comment") {
    header_.comments.push_back(scanner_.take_rest_of_line());
  } else if (keyword == "obj_info") {
    header_.object_infos.push_back(scanner_.take_rest_of_line());
  } else if (!keyword.empty()) {
    return fail(ErrorCode::Syntax, fmt::format("the header has no lines {}; {}", in_quotes(keyword), kMend));
  }
  return true;
}

bool HeaderReader::read_format() {
  const std::string_view encoding = scanner_.take_token();
  if (encoding == "ascii") {
    header_.encoding = PlyEncoding::Ascii;
  } else if (encoding == "binary_little_endian") {
    header_.encoding = PlyEncoding::LittleEndian;
  } else if (encoding == "binary_big_endian") {
    header_.encoding = PlyEncoding::BigEndian;
  } else {
    return fail(ErrorCode::Syntax, fmt::format("the format {} is not known; export the mesh as ascii, "
                                               "binary_little_endian or binary_big_endian",
                                               in_quotes(encoding)));
  }
  if (const std::string_view version = scanner_.take_token(); version != "1.0") {
    return fail(ErrorCode::Syntax,
                fmt::format("version {} of PLY is not known; export the mesh as version 1.0", in_quotes(version)));
  }
  has_format_ = true;
  return true;
}

bool HeaderReader::read_element() {
  PlyElement element;
  element.name = scanner_.take_token();
  std::int64_t count = 0;
  if (element.name.empty() || !scanner_.take_integer(count) || count < 0) {
    return fail(ErrorCode::BadNumber, fmt::format("an element needs a name and a count from 0; {}", kMend));
  }
  if (std::cmp_greater(count, kMostVertices)) {
    return fail(ErrorCode::TooLarge, fmt::format("{} elements {} are more than 4,294,967,294; split the mesh", count,
                                                 in_quotes(element.name)));
  }
  element.count = static_cast<std::uint32_t>(count);
  header_.elements.push_back(std::move(element));
  return true;
}

std::optional<ScalarType> HeaderReader::take_type() {
  const std::string_view word = scanner_.take_token();
  const std::optional<ScalarType> type = type_named(word);
  if (!type) fail(ErrorCode::Syntax, fmt::format("{} is not a type of numbers; {}", in_quotes(word), kMend));
  return type;
}

bool HeaderReader::read_property() {
  if (header_.elements.empty()) {
    return fail(ErrorCode::Syntax, fmt::format("a property stands before the first element; {}", kMend));
  }
  PlyProperty property;
  scanner_.skip_blanks();
  if (scanner_.peek_token() == "list") {
    static_cast<void>(scanner_.take_token());
    property.count_type = take_type();
    if (!property.count_type) return false;
    if (is_real(*property.count_type)) {
      return fail(ErrorCode::Syntax, fmt::format("a list is counted in whole numbers; {}", kMend));
    }
  }
  const std::optional<ScalarType> type = take_type();
  if (!type) return false;
  property.type = *type;
  property.name = scanner_.take_token();
  if (property.name.empty()) return fail(ErrorCode::Syntax, fmt::format("a property needs a name; {}", kMend));
  header_.elements.back().properties.push_back(std::move(property));
  return true;
}

bool HeaderReader::names_are_unique() {
  const auto repeated = [](std::vector<std::string_view> names) {
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    return twice == names.end() ? std::string() : std::string(*twice);
  };
  std::vector<std::string_view> elements;
  for (const PlyElement& element : header_.elements) {
    elements.emplace_back(element.name);
    if (element.properties.empty() && element.count > 0) {
      return fail(ErrorCode::Syntax, fmt::format("element {} has no properties; {}", in_quotes(element.name), kMend));
    }
    std::vector<std::string_view> properties;
    for (const PlyProperty& property : element.properties) properties.emplace_back(property.name);
    if (const std::string twice = repeated(std::move(properties)); !twice.empty()) {
      return fail(ErrorCode::Syntax, fmt::format("property {} of element {} is declared twice; {}", in_quotes(twice),
                                                 in_quotes(element.name), kMend));
    }
  }
  const std::string twice = repeated(std::move(elements));
  return twice.empty() ||
         fail(ErrorCode::Syntax, fmt::format("element {} is declared twice; {}", in_quotes(twice), kMend));
}

}  // namespace

std::size_t size_of(ScalarType type) { return kTypes[static_cast<std::size_t>(type)].size; }

bool is_real(ScalarType type) { return type == ScalarType::Float32 || type == ScalarType::Float64; }

const char* ply_name(ScalarType type) { return kTypes[static_cast<std::size_t>(type)].name; }

Expected<PlyHeader> read_ply_header(LineScanner& scanner, const std::string& name) {
  return HeaderReader(scanner, name).read();
}

}  // namespace quadmatch::io
