#include <quadmatch/analysis/group_order.hpp>

#include <doctest/doctest.h>

namespace quadmatch {
namespace {

TEST_CASE("group order: one to begin with, a number as long as it fits, then a product") {
  GroupOrder order;
  CHECK(order.value() == 1);
  CHECK(order.describe() == "1");
  CHECK(order.log10() == 0);
  order.multiply(24, 2);
  order.multiply(1, 1000);
  order.multiply_by_factorial(3);
  CHECK(order.value() == 3456);
  CHECK(order.describe() == "3456");
  CHECK(order.log10() == doctest::Approx(3.538573734));
  order.multiply(order, 9);
  CHECK_FALSE(order.value().has_value());
  CHECK(order.describe() == "24^20 * 3!^10");
  CHECK(order.log10() == doctest::Approx(35.38573734));
}

TEST_CASE("group order: 2^63 and 20! fit into 64 bits, 2^64 and 21! do not") {
  GroupOrder power, factorial;
  power.multiply(2, 63);
  factorial.multiply_by_factorial(20);
  CHECK(power.value() == std::uint64_t{1} << 63);
  CHECK(factorial.value() == 2432902008176640000U);
  power.multiply(2);
  CHECK_FALSE(power.value().has_value());
  factorial = {};
  factorial.multiply_by_factorial(21);
  CHECK_FALSE(factorial.value().has_value());
  CHECK(factorial.describe() == "21!");
}

}  // namespace
}  // namespace quadmatch
