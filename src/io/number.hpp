#pragma once
/// Decimal numbers as mesh files write them, exactly rounded and fast.

#include <bit>
#include <cfloat>
#include <cstdint>
#include <cstring>
#include <type_traits>

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

/// Parse digits of any length with the standard library. @return false if the value is beyond the range of Real.
template <class Real>
[[nodiscard]] bool parse_long_real(const char* begin, const char* end, Real& value);

extern template bool parse_long_real<float>(const char*, const char*, float&);
extern template bool parse_long_real<double>(const char*, const char*, double&);

/// What the fast way of Clinger (1990) needs: a product or quotient of two exactly representable numbers is rounded
/// once, and so correctly.
template <class Real>
struct ExactRange;
template <>
struct ExactRange<double> {
  static constexpr std::uint64_t kMostMantissa = std::uint64_t{1} << 53U;
  static constexpr int kMostExponent = 22;
  static constexpr double kPowers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                       1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
};
template <>
struct ExactRange<float> {
  static constexpr std::uint64_t kMostMantissa = std::uint64_t{1} << 24U;
  static constexpr int kMostExponent = 10;
  static constexpr float kPowers[] = {1e0F, 1e1F, 1e2F, 1e3F, 1e4F, 1e5F, 1e6F, 1e7F, 1e8F, 1e9F, 1e10F};
};

/// Parse the decimal number that begins at `text`: sign, digits with or without a point, exponent. No `nan`, no `inf`.
///
/// @return  one past the number; nullptr if there is none or it is too large for Real. Too small ones become zero.
/// @pre     a character that belongs to no number follows somewhere.
template <class Real>
[[nodiscard]] const char* parse_real(const char* text, Real& value) {
  using Range = ExactRange<Real>;
  const char* here = text;
  const bool negative = *here == '-';
  here += *here == '-' || *here == '+' ? 1 : 0;  // no branch: signs are hard to predict
  const char* const unsigned_text = here;

  // The mantissa wraps around beyond 19 digits, and is then not used.
  std::uint64_t mantissa = 0;
  const char* const digits = here;
  while (is_digit(*here)) mantissa = 10 * mantissa + static_cast<std::uint64_t>(*here++ - '0');
  std::int64_t digit_count = here - digits;
  std::int64_t exponent = 0;
  if (*here == '.') {
    const char* const fraction = ++here;
    here = parse_digits(here, mantissa);
    exponent = fraction - here;
    digit_count -= exponent;
  }
  if (digit_count == 0) return nullptr;
  if (*here == 'e' || *here == 'E') {
    const char* power = here + 1;
    const bool shrinks = *power == '-';
    if (*power == '-' || *power == '+') ++power;
    if (!is_digit(*power)) return nullptr;
    std::int64_t written = 0;
    for (; is_digit(*power); ++power) written = written < 100000 ? 10 * written + (*power - '0') : written;
    exponent += shrinks ? -written : written;
    here = power;
  }

  if (FLT_EVAL_METHOD == 0 && digit_count <= 19 && mantissa <= Range::kMostMantissa &&
      exponent >= -Range::kMostExponent && exponent <= Range::kMostExponent) {
    const Real exact = static_cast<Real>(mantissa);
    value = exponent < 0 ? exact / Range::kPowers[-exponent] : exact * Range::kPowers[exponent];
  } else if (!parse_long_real(unsigned_text, here, value)) {
    return nullptr;
  }
  if (negative) value = -value;
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
