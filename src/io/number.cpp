// The long way to a number: any length, exactly rounded.

#include "number.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>
#include <type_traits>

namespace quadmatch::io {
namespace {

/// The parts of a number without its sign.
struct Decimal {
  const char* begin;
  const char* end;
  bool tiny;  ///< if it is out of range, then below
};

const char* skip_digits(const char* here) {
  while (is_digit(*here)) ++here;
  return here;
}

/// Find the end of a number. @return false if there is none at `begin`.
bool scan_decimal(const char* begin, Decimal& decimal) {
  const char* here = skip_digits(begin);
  std::ptrdiff_t count = here - begin;
  if (*here == '.') {
    const char* const fraction = here + 1;
    here = skip_digits(fraction);
    count += here - fraction;
  }
  if (count == 0) return false;
  decimal = {begin, here, *begin == '0' || *begin == '.'};
  if (*here != 'e' && *here != 'E') return true;
  const char* power = here + 1;
  decimal.tiny = *power == '-';
  if (*power == '-' || *power == '+') ++power;
  decimal.end = skip_digits(power);
  return decimal.end != power;
}

/// The standard library's value. @return false if it is too large for Real.
template <class Real>
bool convert(const Decimal& decimal, Real& value) {
#ifdef __cpp_lib_to_chars
  if (std::from_chars(decimal.begin, decimal.end, value).ec == std::errc()) return true;
  if (decimal.tiny) value = 0;
  return decimal.tiny;
#else
  // A standard library without from_chars for reals, as on WebAssembly, where strto* know no locale but "C".
  const std::string text(decimal.begin, decimal.end);
  if constexpr (std::is_same_v<Real, float>) {
    value = std::strtof(text.c_str(), nullptr);
  } else {
    value = std::strtod(text.c_str(), nullptr);
  }
  return std::isfinite(value);
#endif
}

}  // namespace

template <class Real>
const char* parse_any_real(const char* text, Real& value) {
  const bool negative = *text == '-';
  Decimal decimal{};
  if (!scan_decimal(text + (negative || *text == '+' ? 1 : 0), decimal)) return nullptr;
  if (!convert(decimal, value)) return nullptr;
  if (negative) value = -value;
  return decimal.end;
}

template const char* parse_any_real<float>(const char*, float&);
template const char* parse_any_real<double>(const char*, double&);

}  // namespace quadmatch::io
