// The slow way to a number: any length, exactly rounded.

#include "number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <system_error>

namespace quadmatch::io {

template <class Real>
bool parse_long_real(const char* begin, const char* end, Real& value) {
#ifdef __cpp_lib_to_chars
  const std::from_chars_result result = std::from_chars(begin, end, value);
  if (result.ec == std::errc()) return true;
  // Out of range: too small if the exponent says so or, without one, if nothing but zeros stands before the point.
  const char* const power = std::find_if(begin, end, [](char c) { return c == 'e' || c == 'E'; });
  const bool tiny = power != end ? power[1] == '-' : *begin == '0' || *begin == '.';
  if (tiny) value = 0;
  return tiny;
#else
  // A standard library without from_chars for reals, as on WebAssembly, where strtod knows no locale but "C".
  value = static_cast<Real>(std::strtod(std::string(begin, end).c_str(), nullptr));
  return std::isfinite(value);
#endif
}

template bool parse_long_real<float>(const char*, const char*, float&);
template bool parse_long_real<double>(const char*, const char*, double&);

}  // namespace quadmatch::io
