#include "regions/binary_cut.hpp"

#include <doctest/doctest.h>
#include <quadmatch/shapes/random.hpp>

namespace quadmatch::regions {
namespace {

struct Problem {
  std::uint32_t count;
  std::vector<double> no, yes;
  struct Link {
    std::uint32_t i, j;
    double no_no, no_yes, yes_no, yes_yes;
  };
  std::vector<Link> links;

  [[nodiscard]] double cost(std::uint32_t answers) const {
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i) sum += (answers >> i & 1U) != 0 ? yes[i] : no[i];
    for (const Link& link : links) {
      const bool first = (answers >> link.i & 1U) != 0, second = (answers >> link.j & 1U) != 0;
      sum += first ? (second ? link.yes_yes : link.yes_no) : (second ? link.no_yes : link.no_no);
    }
    return sum;
  }
};

Problem random_problem(shapes::Random& random) {
  const auto number = [&](std::uint32_t most) { return static_cast<double>(random.below(most)) / 8; };
  Problem problem{.count = 1 + random.below(9), .no = {}, .yes = {}, .links = {}};
  for (std::uint32_t i = 0; i < problem.count; ++i) {
    problem.no.push_back(number(16));
    problem.yes.push_back(number(16));
  }
  for (std::uint32_t k = 0; k < 2 * problem.count && problem.count > 1; ++k) {
    Problem::Link link{random.below(problem.count), random.below(problem.count), 0, number(16), number(16), 0};
    if (link.i == link.j) continue;
    // Equal answers together never cost more than different ones.
    link.no_no = (link.no_yes + link.yes_no) * number(8);
    link.yes_yes = (link.no_yes + link.yes_no - link.no_no) * number(8);
    problem.links.push_back(link);
  }
  return problem;
}

TEST_CASE("a minimum cut gives the cheapest of all answers, on a thousand small problems") {
  shapes::Random random(5);
  for (int round = 0; round < 1000; ++round) {
    CAPTURE(round);
    const Problem problem = random_problem(random);
    BinaryCut cut(problem.count);
    for (std::uint32_t i = 0; i < problem.count; ++i) cut.add_cost(i, problem.no[i], problem.yes[i]);
    for (const auto& [i, j, no_no, no_yes, yes_no, yes_yes] : problem.links) {
      cut.add_pair_cost(i, j, no_no, no_yes, yes_no, yes_yes);
    }
    const std::vector<bool> found = cut.solve();
    std::uint32_t answers = 0;
    for (std::uint32_t i = 0; i < problem.count; ++i) answers |= found[i] ? 1U << i : 0U;
    double least = problem.cost(0);
    for (std::uint32_t other = 1; other < 1U << problem.count; ++other) least = std::min(least, problem.cost(other));
    CHECK(problem.cost(answers) == doctest::Approx(least));
    CHECK(cut.gain(found) == doctest::Approx(problem.cost(0) - least));
  }
}

TEST_CASE("where all answers cost the same, the cut says no to all") {
  BinaryCut cut(3);
  cut.add_pair_cost(0, 1, 0, 1, 1, 0);
  cut.add_pair_cost(1, 2, 0, 1, 1, 0);
  CHECK(cut.solve() == std::vector<bool>{false, false, false});
}

}  // namespace
}  // namespace quadmatch::regions
