// Both ways round, probed first and then searched round by round in turn, against one incumbent.

#include <quadmatch/match/exact.hpp>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include <quadmatch/analysis/vertex_code.hpp>

#include "../growth.hpp"
#include "../regions/assemble.hpp"
#include "incumbent.hpp"
#include "solver.hpp"

namespace quadmatch {
namespace {

using exact::Budget;
using exact::Incumbent;
using exact::Pair;
using exact::Solver;

using Solvers = std::vector<std::unique_ptr<Solver>>;

/// What all ways round together leave possible.
std::uint32_t bound_of(const Solvers& solvers) {
  std::uint32_t bound = 0;
  for (const auto& solver : solvers) bound = std::max(bound, solver->bound());
  return bound;
}

void solve(const Solvers& solvers, const Budget& budget, const Incumbent& incumbent) {
  const auto must_stop = [&] { return budget.stopped() || incumbent.enough; };
  for (const auto& solver : solvers) {
    if (!must_stop()) solver->probe();
  }
  while (!must_stop() && bound_of(solvers) > incumbent.to_beat) {
    for (const auto& solver : solvers) {
      if (!must_stop() && !solver->finished()) solver->round();
    }
  }
}

/// The pairs of the incumbent as a match, with rotations for the target as it was given.
Match match_of(const Mesh& source, const Mesh& target, const Incumbent& incumbent) {
  Match match;
  if (incumbent.pairs.empty()) return match;
  Region region;
  region.orientation = incumbent.orientation;
  for (const Pair& pair : incumbent.pairs) {
    const FaceId f = source.face(pair.source), g = target.face(pair.target);
    const std::uint32_t size = source.size(f);
    const std::uint32_t laid = (target.corner(pair.target) + size - source.corner(pair.source)) % size;
    // In the mirror corner k is corner n - 1 - k of the face as it was given (Mesh::mirrored).
    const bool preserving = region.orientation == Orientation::Preserving;
    region.faces.push_back({f, g, preserving ? laid : size - 1 - laid});
  }
  match.regions.push_back(std::move(region));
  match.vertices = regions::combined_vertices(source, target, match.regions);
  match.regions.front().evidence = weigh(match.vertices, vertex_codes(source), vertex_codes(target));
  return match;
}

Decision decide(const Incumbent& incumbent, std::uint32_t bound) {
  if (incumbent.at_least == 0) return Decision::NotAsked;
  if (incumbent.pairs.size() >= incumbent.at_least) return Decision::Yes;
  return bound < incumbent.at_least ? Decision::No : Decision::Unknown;
}

}  // namespace

LargestRegion largest_region(const Mesh& source, const Mesh& target, const ExactOptions& options) {
  Incumbent incumbent;
  incumbent.at_least = options.at_least;
  incumbent.to_beat = options.at_least == 0 ? 0 : options.at_least - 1;

  Solvers solvers;
  std::optional<Budget> budget;
  exact::KeepGoing keep_going;
  if (options.progress) {
    keep_going = [&] {
      return options.progress({static_cast<std::uint32_t>(incumbent.pairs.size()), bound_of(solvers), budget->nodes()});
    };
  }
  budget.emplace(options.node_limit, std::move(keep_going));
  std::optional<Mesh> mirror;
  if (options.orientation != OrientationChoice::Reversing) {
    solvers.push_back(std::make_unique<Solver>(source, target, Orientation::Preserving, incumbent, *budget));
  }
  if (options.orientation != OrientationChoice::Preserving) {
    mirror.emplace(target.mirrored());
    solvers.push_back(std::make_unique<Solver>(source, *mirror, Orientation::Reversing, incumbent, *budget));
  }
  solve(solvers, *budget, incumbent);

  LargestRegion result{match_of(source, target, incumbent), {}};
  const auto size = static_cast<std::uint32_t>(incumbent.pairs.size());
  result.optimality.bound = std::max(bound_of(solvers), size);
  result.optimality.proved = result.optimality.bound == size;
  result.optimality.nodes = budget->nodes();
  result.optimality.at_least = options.at_least;
  result.optimality.decision = decide(incumbent, result.optimality.bound);
  result.match.complete = result.optimality.proved || result.optimality.decision == Decision::Yes ||
                          result.optimality.decision == Decision::No;
  return result;
}

}  // namespace quadmatch
