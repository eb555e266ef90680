#pragma once
/// Decimal numbers as mesh files write them, exactly rounded and fast.

#include <bit>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace quadmatch::io {

[[nodiscard]] inline bool is_digit(char c) { return static_cast<unsigned char>(c - '0') < 10; }

/// The digits a text begins with, eight at most, and their value.
struct Digits {
  std::uint32_t count;
  std::uint32_t value;
};

/// Read up to eight digits in one word, without a branch for each.
/// @pre  eight bytes may be read.
[[nodiscard]] inline Digits leading_digits(const char* text) {
  static_assert(std::endian::native == std::endian::little, "the first digit must be the lowest byte");
  std::uint64_t word = 0;
  std::memcpy(&word, text, sizeof word);
  word ^= 0x3030303030303030;  // digits become 0 ... 9, and no other byte does
  const std::uint64_t others = (word | (word + 0x7676767676767676)) & 0x8080808080808080;
  const std::uint32_t count = static_cast<std::uint32_t>(std::countr_zero(others)) / 8;
  if (count == 0) return {0, 0};
  word <<= 64 - 8 * count;  // zeros in front, so that there are always eight
  word = 10 * word + (word >> 8);
  const std::uint64_t thousands = (word & 0x000000ff000000ff) * 0x000f424000000064;
  const std::uint64_t ones = ((word >> 16) & 0x000000ff000000ff) * 0x0000271000000001;
  return {count, static_cast<std::uint32_t>((thousands + ones) >> 32)};
}

inline constexpr std::uint64_t kWholePowers[] = {1,       10,        100,        1'000,      10'000,
                                                 100'000, 1'000'000, 10'000'000, 100'000'000};

/// Append decimal digits to a number; beyond 19 digits it wraps around.
/// @return  one past the digits, `text` if there are none.
/// @pre     eight bytes may be read at every digit and behind the last.
[[nodiscard]] inline const char* parse_digits(const char* text, std::uint64_t& value) {
  Digits digits;
  do {
    digits = leading_digits(text);
    value = value * kWholePowers[digits.count] + digits.value;
    text += digits.count;
  } while (digits.count == 8);
  return text;
}

/// What Clinger (1990) needs for an exact result in one step: a quotient of two numbers that are represented exactly
/// is rounded once, and so correctly.
template <class Real>
struct ExactRange;
template <>
struct ExactRange<double> {
  static constexpr std::ptrdiff_t kMostDigits = 15;
  static constexpr double kSigns[] = {1, -1};
  static constexpr double kPowers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8};
};
template <>
struct ExactRange<float> {
  static constexpr std::ptrdiff_t kMostDigits = 7;
  static constexpr float kSigns[] = {1, -1};
  static constexpr float kPowers[] = {1e0F, 1e1F, 1e2F, 1e3F, 1e4F, 1e5F, 1e6F, 1e7F, 1e8F};
};

/// As `parse_real`, in full: any number of digits, and an exponent.
template <class Real>
[[nodiscard]] const char* parse_any_real(const char* text, Real& value);

extern template const char* parse_any_real<float>(const char*, float&);
extern template const char* parse_any_real<double>(const char*, double&);

/// Parse the decimal number that begins at `text`: sign, digits with or without a point, exponent. No `nan`, no `inf`.
///
/// @return  one past the number; nullptr if there is none or it is too large for Real. Too small ones become zero.
/// @pre     a character that belongs to no number follows somewhere, and eight bytes behind it may be read.
template <class Real>
[[nodiscard]] const char* parse_real(const char* text, Real& value) {
  using Range = ExactRange<Real>;
  const bool negative = *text == '-';
  const char* here = text + (negative || *text == '+' ? 1 : 0);  // no branch: signs are hard to predict

  const char* const digits = here;
  std::uint64_t mantissa = 0;
  while (is_digit(*here)) mantissa = 10 * mantissa + static_cast<std::uint64_t>(*here++ - '0');
  std::ptrdiff_t count = here - digits;
  Digits fraction{0, 0};
  if (*here == '.') {
    fraction = leading_digits(here + 1);
    mantissa = mantissa * kWholePowers[fraction.count] + fraction.value;
    count += fraction.count;
    here += 1 + fraction.count;
  }
  const bool ends = !is_digit(*here) && *here != 'e' && *here != 'E';
  if (FLT_EVAL_METHOD != 0 || !ends || count == 0 || count > Range::kMostDigits) return parse_any_real(text, value);
  const Real whole = static_cast<Real>(static_cast<std::int64_t>(mantissa));  // signed: one instruction
  value = Range::kSigns[negative ? 1 : 0] * (whole / Range::kPowers[fraction.count]);
  return here;
}

/// Parse a whole number with an optional sign. Values beyond +-10^18 stay there.
/// @return  one past the number, nullptr if there is none.
[[nodiscard]] inline const char* parse_integer(const char* text, std::int64_t& value) {
  constexpr std::int64_t kMost = 1'000'000'000'000'000'000;
  const bool negative = *text == '-';
  if (*text == '-' || *text == '+') ++text;
  std::uint64_t digits = 0;
  const char* const stop = parse_digits(text, digits);
  if (stop == text) return nullptr;
  value = stop - text > 18 ? kMost : static_cast<std::int64_t>(digits);
  if (negative) value = -value;
  return stop;
}

}  // namespace quadmatch::io
