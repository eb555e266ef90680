#include <quadmatch/analysis/group_order.hpp>

#include <cmath>

#include <fmt/format.h>

namespace quadmatch {
namespace {

/// product * factor^exponent, unless that is too large for 64 bits. @pre factor > 1
bool multiply_within_64_bits(std::uint64_t& product, std::uint64_t factor, std::uint64_t exponent) {
  for (; exponent > 0; --exponent) {
    if (__builtin_mul_overflow(product, factor, &product)) return false;
  }
  return true;
}

std::string power(const std::string& base, std::uint64_t exponent) {
  return exponent == 1 ? base : fmt::format("{}^{}", base, exponent);
}

}  // namespace

void GroupOrder::multiply(std::uint64_t factor, std::uint64_t exponent) {
  if (factor > 1 && exponent > 0) powers_[factor] += exponent;
}

void GroupOrder::multiply_by_factorial(std::uint64_t number) {
  if (number == 2) multiply(2);
  if (number > 2) ++factorials_[number];
}

void GroupOrder::multiply(const GroupOrder& other, std::uint64_t exponent) {
  if (exponent == 0) return;
  for (const auto& [base, times] : other.powers_) powers_[base] += times * exponent;
  for (const auto& [number, times] : other.factorials_) factorials_[number] += times * exponent;
}

std::optional<std::uint64_t> GroupOrder::value() const {
  std::uint64_t product = 1;
  for (const auto& [base, exponent] : powers_) {
    if (!multiply_within_64_bits(product, base, exponent)) return std::nullopt;
  }
  for (const auto& [number, exponent] : factorials_) {
    for (std::uint64_t factor = 2; factor <= number; ++factor) {
      if (!multiply_within_64_bits(product, factor, exponent)) return std::nullopt;
    }
  }
  return product;
}

double GroupOrder::log10() const {
  double sum = 0;
  for (const auto& [base, exponent] : powers_) {
    sum += static_cast<double>(exponent) * std::log10(static_cast<double>(base));
  }
  for (const auto& [number, exponent] : factorials_) {
    // Term by term: std::lgamma would set a global variable.
    for (std::uint64_t factor = 2; factor <= number; ++factor) {
      sum += static_cast<double>(exponent) * std::log10(static_cast<double>(factor));
    }
  }
  return sum;
}

std::string GroupOrder::describe() const {
  if (const std::optional<std::uint64_t> number = value()) return fmt::format("{}", *number);
  std::string text;
  const auto add = [&text](const std::string& factor) { text += (text.empty() ? "" : " * ") + factor; };
  for (auto entry = powers_.rbegin(); entry != powers_.rend(); ++entry) {
    add(power(fmt::format("{}", entry->first), entry->second));
  }
  for (auto entry = factorials_.rbegin(); entry != factorials_.rend(); ++entry) {
    add(power(fmt::format("{}!", entry->first), entry->second));
  }
  return text;
}

}  // namespace quadmatch
