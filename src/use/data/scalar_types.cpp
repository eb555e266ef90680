#include "scalar_types.hpp"

#include <array>

namespace quadmatch::use {
namespace {

struct Range {
  ScalarType type;
  const char* name;
  int negative_bits, positive_bits;  ///< whole numbers from -2^negative_bits to 2^positive_bits
  bool whole;
};

/// From the smallest.
constexpr std::array<Range, 8> kTypes{{{ScalarType::Int8, "char", 7, 7, true},
                                       {ScalarType::UInt8, "uchar", 0, 8, true},
                                       {ScalarType::Int16, "short", 15, 15, true},
                                       {ScalarType::UInt16, "ushort", 0, 16, true},
                                       {ScalarType::Int32, "int", 31, 31, true},
                                       {ScalarType::UInt32, "uint", 0, 32, true},
                                       {ScalarType::Float32, "float", 24, 24, false},
                                       {ScalarType::Float64, "double", 53, 53, false}}};

const Range& range_of(ScalarType type) {
  for (const Range& range : kTypes) {
    if (range.type == type) return range;
  }
  return kTypes.back();
}

bool holds(const Range& wide, const Range& narrow) {
  return wide.negative_bits >= narrow.negative_bits && wide.positive_bits >= narrow.positive_bits &&
         (narrow.whole || !wide.whole);
}

}  // namespace

bool is_whole(ScalarType type) { return range_of(type).whole; }

const char* name_of(ScalarType type) { return range_of(type).name; }

ScalarType holding_both(ScalarType one, ScalarType other) {
  for (const Range& range : kTypes) {
    if (holds(range, range_of(one)) && holds(range, range_of(other))) return range.type;
  }
  return ScalarType::Float64;
}

}  // namespace quadmatch::use
