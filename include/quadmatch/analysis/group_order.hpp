#pragma once
/// The number of symmetries: a whole number that may have thousands of digits, exact because it is kept as a product.

#include <cstdint>
#include <map>
#include <optional>
#include <string>

namespace quadmatch {

/// A product of powers and factorials, 1 to begin with. Ten thousand cubes have 24^10000 * 10000! symmetries: each
/// cube turns by itself, and all of them change places.
class GroupOrder {
 public:
  /// Times factor^exponent. @pre factor > 0
  void multiply(std::uint64_t factor, std::uint64_t exponent = 1);
  /// Times number!.
  void multiply_by_factorial(std::uint64_t number);
  /// Times other^exponent. O(#factors).
  void multiply(const GroupOrder& other, std::uint64_t exponent = 1);

  /// The number itself, where it fits.
  [[nodiscard]] std::optional<std::uint64_t> value() const;
  /// Exact to the precision of a double.
  [[nodiscard]] double log10() const;
  /// "24", or the product where it does not fit into 64 bits: "24^10000 * 10000!", from the largest base, then the
  /// factorials.
  [[nodiscard]] std::string describe() const;

 private:
  std::map<std::uint64_t, std::uint64_t> powers_;      // exponents by base, bases from 2 on
  std::map<std::uint64_t, std::uint64_t> factorials_;  // exponents by number, numbers from 3 on
};

}  // namespace quadmatch
