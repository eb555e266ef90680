// Figs 4.1 to 4.5: the false start, and why laziness helps.

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/figures.hpp>
#include <quadmatch/verify/verify.hpp>

#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

struct Outcome {
  std::size_t matched = 0;
  std::size_t right = 0;
};

/// Match M1 with M2, from the seed at "start" or from an anchor that is found.
Outcome run(Algorithm algorithm, bool seed_at_start = true) {
  const shapes::Figure41 figure_1 = shapes::fig_4_1();
  const shapes::Figure42 figure_2 = shapes::fig_4_2();
  const Mesh m1 = test::build(figure_1.soup);
  const Mesh m2 = test::build(figure_2.soup);
  MatchOptions options{.algorithm = algorithm};
  if (seed_at_start) options.anchors = {{figure_1.seed, figure_2.seed}};
  const MatchResult result = match(m1, m2, options);
  CHECK(verify(m1, m2, result.match).sound());
  Outcome outcome{.matched = result.match.matched_faces()};
  for (const FacePair& pair : result.match.regions.front().faces) {
    outcome.right += std::find(figure_2.truth.begin(), figure_2.truth.end(), pair) != figure_2.truth.end();
  }
  return outcome;
}

TEST_CASE("Fig 4.1: the vertex marked start is the anchor that the colours find") {
  const shapes::Figure41 figure_1 = shapes::fig_4_1();
  const Mesh m1 = test::build(figure_1.soup);
  const MatchResult itself = match(m1, m1, {.algorithm = Algorithm::LazyGreedy});
  CHECK(m1.origin(itself.seed.source) == figure_1.start);
  CHECK(m1.origin(itself.seed.target) == figure_1.start);
}

TEST_CASE("Fig 4.3: greedy marches through the squeezed quads and derails over most of the mesh") {
  const Outcome greedy = run(Algorithm::Greedy);
  CHECK(greedy.matched == 136);
  CHECK(greedy.right == 60);
}

TEST_CASE("Fig 4.5: lazy-greedy isolates the mismatch: it loses five quads of 162 and gets none wrong") {
  const Outcome lazy = run(Algorithm::LazyGreedy);
  CHECK(shapes::fig_4_2().truth.size() == 162);
  CHECK(lazy.matched == 157);
  CHECK(lazy.right == 157);
}

TEST_CASE("Figs 4.3 and 4.5: from an anchor of its own finding, lazy-greedy is as right, and greedy derails too") {
  const Outcome lazy = run(Algorithm::LazyGreedy, false);
  CHECK(lazy.matched == 157);
  CHECK(lazy.right == 157);
  CHECK(run(Algorithm::Greedy, false).right < lazy.right);
}

}  // namespace
}  // namespace quadmatch
