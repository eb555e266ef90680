// The fast way to a number gives the same bits as the exact one.

#include <doctest/doctest.h>

#include <charconv>
#include <cmath>
#include <random>
#include <string>

#include "number.hpp"

using namespace quadmatch::io;

namespace {

template <class Real>
Real exact(const std::string& text) {
  Real value = -1;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

/// Text as a scanner sees it: with room behind it.
std::string padded(const std::string& text) { return text + std::string(32, '\n'); }

template <class Real>
Real ours(const std::string& text) {
  const std::string roomy = padded(text);
  Real value = -1;
  const char* const stop = parse_real(roomy.data(), value);
  REQUIRE(stop == roomy.data() + text.size());
  return value;
}

template <class Real>
void compare_with_exact(const std::string& text) {
  CAPTURE(text);
  CHECK(ours<Real>(text) == exact<Real>(text));
}

}  // namespace

TEST_CASE("random decimals of every length are read to the nearest double and float (seed 7)") {
  std::mt19937 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::string text = random() % 2 == 0 ? "-" : "";
    const auto add_digits = [&](std::size_t most) {
      for (std::size_t k = random() % most; k > 0; --k) text += static_cast<char>('0' + random() % 10);
    };
    text += static_cast<char>('0' + random() % 10);
    add_digits(12);
    if (random() % 4 != 0) {
      text += '.';
      add_digits(24);
    }
    if (random() % 4 == 0) text += "e" + std::to_string(static_cast<int>(random() % 48) - 24);
    compare_with_exact<double>(text);
    compare_with_exact<float>(text);
  }
}

TEST_CASE("doubles printed in their shortest form come back to the bit (seed 8)") {
  std::mt19937_64 random(8);
  for (int i = 0; i < 20000; ++i) {
    const double value = std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 400) - 264);
    char digits[32];
    const std::string text(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
    CHECK(ours<double>(text) == value);
  }
}

TEST_CASE("the borders of the exact range are read exactly") {
  for (const char* const text :
       {"9007199254740992", "9007199254740993", "9007199254740991e22", "9007199254740991e-22", "1e23", "1e-23",
        "16777216", "16777217", "16777219e10", "0.1", "4.9406564584124654e-324", "1.7976931348623157e308",
        "0.000000000000000000000000000001", "99999999999999999999", "18446744073709551616"}) {
    compare_with_exact<double>(text);
  }
  CHECK(std::signbit(ours<double>("-0")));
  CHECK(ours<double>("1e-999") == 0);
  CHECK(ours<double>("0." + std::string(400, '0') + "1") == 0);
}

TEST_CASE("what is too large or no number is refused") {
  double value = 0;
  for (const char* const text : {"1e309", "-1e309", "nan", "inf", "e5", ".", "+", "-", "", "-.e1", "1e+"}) {
    CAPTURE(text);
    CHECK(parse_real(padded(text).data(), value) == nullptr);
  }
  const std::string huge = padded(std::string(400, '9'));
  CHECK(parse_real(huge.data(), value) == nullptr);
}

TEST_CASE("whole numbers of every length are read, and the longest held at ten to the eighteenth") {
  for (const std::int64_t number :
       {0LL, 7LL, -7LL, 12345678LL, 123456789LL, -1234567890123456LL, 12345678901234567LL}) {
    std::int64_t value = -1;
    const std::string text = padded(std::to_string(number));
    REQUIRE(parse_integer(text.data(), value) != nullptr);
    CHECK(value == number);
  }
  std::int64_t value = 0;
  CHECK(parse_integer(padded("99999999999999999999999").data(), value) != nullptr);
  CHECK(value == 1'000'000'000'000'000'000);
  CHECK(parse_integer(padded("x").data(), value) == nullptr);
}
