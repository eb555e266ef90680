#include "solver.hpp"

#include <algorithm>
#include <utility>

#include <quadmatch/match/matcher.hpp>

namespace quadmatch::exact {
namespace {

/// Growth steps spent on a first region, about; and regions of other algorithms that are grown on.
constexpr std::uint64_t kProbeSteps = 1'000'000;
constexpr std::size_t kRegionsGrownOn = 4;
/// Placements of a block that are grown greedily.
constexpr std::size_t kPlacementsGrown = 2;
/// How much longer to look each time that was not long enough, and how often to cut a block otherwise.
constexpr double kMorePatience = 1.25;
constexpr int kCuts = 2;

std::uint32_t largest_component(const Components& components) {
  return components.face_count.empty() ? 0
                                       : *std::max_element(components.face_count.begin(), components.face_count.end());
}

/// The regions another algorithm finds, as pairs.
void collect_regions(const Mesh& source, const Mesh& target, Algorithm algorithm, Budget& budget,
                     std::vector<std::vector<Pair>>& regions) {
  const auto keep_going = [&](std::size_t, std::size_t) { return budget.work(1); };
  const MatchResult found = match(source, target,
                                  {.algorithm = algorithm,
                                   .orientation = OrientationChoice::Preserving,
                                   .positions = false,
                                   .progress = keep_going});
  for (std::size_t k = 0; k < std::min(kRegionsGrownOn, found.match.regions.size()); ++k) {
    std::vector<Pair>& pairs = regions.emplace_back();
    for (const FacePair& face : found.match.regions[k].faces) {
      pairs.push_back({source.first(face.source), HalfedgeId(target.first(face.target).value + face.rotation)});
    }
  }
}

}  // namespace

Solver::Solver(const Mesh& source, const Mesh& target, Orientation orientation, Incumbent& incumbent, Budget& budget)
    : orientation_(orientation),
      incumbent_(incumbent),
      budget_(budget),
      partial_(source, target),
      probe_(partial_, orientation, incumbent, budget),
      search_(partial_, orientation, incumbent, budget),
      components_{connected_components(source), connected_components(target)} {}

std::uint32_t Solver::bound() const {
  const std::uint32_t trivial =
      std::min(largest_component(components_[kSource]), largest_component(components_[kTarget]));
  if (!side_chosen_) return trivial;
  std::uint32_t most = incumbent_.to_beat;
  for (std::uint32_t c = 0; c < most_losses_.size(); ++c) {
    most = std::max(most, components_[side_].face_count[c] - most_losses_[c]);
  }
  return std::min(most, trivial);
}

void Solver::probe() {
  if (finished()) return;
  std::vector<std::vector<Pair>> regions;
  collect_regions(partial_.mesh(kSource), partial_.mesh(kTarget), Algorithm::LazyGreedy, budget_, regions);
  collect_regions(partial_.mesh(kSource), partial_.mesh(kTarget), Algorithm::Regions, budget_, regions);
  probe_.try_regions(regions);
  if (!finished() && !must_stop()) probe_.try_placements(kProbeSteps);
}

/// The side on which fewer blocks have to be proved.
void Solver::choose_side() {
  std::array<std::uint64_t, 2> blocks{};
  for (const Side side : {kSource, kTarget}) {
    for (const std::uint32_t faces : components_[side].face_count) {
      blocks[side] += faces > incumbent_.to_beat ? faces - incumbent_.to_beat : 0;
    }
  }
  side_ = blocks[kSource] <= blocks[kTarget] ? kSource : kTarget;
  side_chosen_ = true;
  const Components& components = components_[side_];
  most_losses_.assign(components.face_count.size(), 0);
  component_faces_.resize(components.face_count.size());
  for (std::uint32_t f = 0; f < partial_.mesh(side_).face_count(); ++f) {
    component_faces_[components.of_face[FaceId(f)]].push_back(FaceId(f));
  }
}

/// Losses to be shown for the component being proved.
std::uint32_t Solver::losses_needed() const {
  const std::uint32_t faces = components_[side_].face_count[component_];
  return faces > incumbent_.to_beat ? faces - incumbent_.to_beat : 0;
}

void Solver::round() {
  if (!side_chosen_) choose_side();
  matched_ = PerFace<std::uint8_t>(partial_.mesh(side_).face_count(), 0);
  if (incumbent_.orientation == orientation_) {
    for (const Pair& pair : incumbent_.pairs) matched_[partial_.mesh(side_).face(half(pair, side_))] = 1;
  }
  for (component_ = 0; component_ < most_losses_.size(); ++component_) {
    if (must_stop()) return;
    if (most_losses_[component_] >= losses_needed()) continue;
    losses_ = 0;
    partial_.begin_levels(side_, component_faces_[component_], losses_needed() - 1);
    prove(component_faces_[component_], losses_needed() - 1);
  }
}

/// Show that no better region within the chain of levels loses at most `budget` of these faces, the last level. False
/// where that was not to be shown with the patience there is.
bool Solver::prove(const Block& faces, std::uint32_t budget) {
  const std::uint32_t before = losses_;
  for (int cut = 0; cut < kCuts; ++cut) {
    if (must_stop()) return false;
    if (losses_ >= losses_needed()) return true;  // a better region was found meanwhile
    if (budget == 0) return prove_whole(faces);
    std::array<Part, 2> parts = parts_of(faces, budget);
    if (prove_both(parts[0], parts[1])) return true;
    losses_ = before;
  }
  return false;
}

/// One part first; what it must lose then helps with the other.
bool Solver::prove_both(Part& one, Part& two) {
  if (!prove_inner(one)) {
    std::swap(one, two);
    if (!prove_inner(one)) return false;
  }
  partial_.set_demand(one.budget + 1);
  const bool done = prove_inner(two) || prove_inner(two);
  partial_.set_demand(0);
  return done;
}

bool Solver::prove_inner(const Part& part) {
  partial_.push_level(part.faces, part.budget);
  const bool done = prove(part.faces, part.budget);
  partial_.pop_level();
  return done;
}

/// Two parts that share the budget as they share the faces.
std::array<Solver::Part, 2> Solver::parts_of(const Block& faces, std::uint32_t budget) {
  const std::uint32_t half_budget = (budget - 1) / 2;
  std::array<Part, 2> parts;
  parts[0].budget = half_budget;
  parts[1].budget = budget - 1 - half_budget;
  std::array<Block, 2> blocks =
      cut_in_two(partial_.mesh(side_), faces, {parts[0].budget + 1, parts[1].budget + 1}, random_);
  for (std::uint32_t p = 0; p < 2; ++p) {
    parts[p].faces = std::move(blocks[p]);
    for (const FaceId face : parts[p].faces) parts[p].promise += matched_[face] != 0 ? 0 : -1;
    parts[p].promise += parts[p].budget;
  }
  if (parts[1].promise > parts[0].promise) std::swap(parts[0], parts[1]);
  return parts;
}

/// For each face of a block but the first, a half-edge of an earlier face whose twin is in it.
std::vector<HalfedgeId> Solver::ways_through(const Block& block) const {
  const Mesh& mesh = partial_.mesh(side_);
  std::vector<HalfedgeId> ways;
  for (std::size_t k = 1; k < block.size(); ++k) {
    const auto end = block.begin() + static_cast<std::ptrdiff_t>(k);
    for (const HalfedgeId h : mesh.halfedges(block[k])) {
      const HalfedgeId across = mesh.twin(h);
      if (!across.valid() || std::find(block.begin(), end, mesh.face(across)) == end) continue;
      ways.push_back(across);
      break;
    }
  }
  return ways;
}

/// Commit a block, its first half-edge on `there`. False where some face of it does not fit; what was committed stays.
bool Solver::place(const Block& block, const std::vector<HalfedgeId>& ways, HalfedgeId there, Rim* rim) {
  const Mesh& mesh = partial_.mesh(side_);
  const Mesh& mesh_there = partial_.mesh(other(side_));
  Pair pair = pair_of(side_, mesh.first(block.front()), there);
  for (std::size_t k = 0;; ++k) {
    if (!half(pair, other(side_)).valid() || !partial_.fits(pair)) return false;
    partial_.commit(pair);
    if (rim != nullptr) extend(*rim, partial_, pair);
    if (k == ways.size()) return true;
    pair = pair_of(side_, mesh.twin(ways[k]), mesh_there.twin(partial_.image(side_, ways[k])));
  }
}

/// All of a block, those first of which most corners agree.
std::vector<Solver::Placement> Solver::placements(const Block& block, const std::vector<HalfedgeId>& ways) {
  std::vector<Placement> placements;
  const Partial::Mark start = partial_.mark();
  for (std::uint32_t t = 0; t < partial_.mesh(other(side_)).halfedge_count(); ++t) {
    if (place(block, ways, HalfedgeId(t), nullptr)) {
      std::uint32_t disagreeing = 0;
      for (const Pair& pair : partial_.pairs()) disagreeing += probe_.disagreeing_corners(pair);
      placements.push_back({HalfedgeId(t), disagreeing});
    }
    partial_.undo(start);
  }
  budget_.work(partial_.mesh(other(side_)).halfedge_count());
  std::stable_sort(placements.begin(), placements.end(),
                   [](const Placement& a, const Placement& b) { return a.disagreeing < b.disagreeing; });
  return placements;
}

/// Search below every placement of a block of which nothing may be lost.
bool Solver::prove_whole(const Block& block) {
  const Partial::Mark start = partial_.mark();
  const std::vector<HalfedgeId> ways = ways_through(block);
  std::size_t grown = 0;
  for (const Placement& placement : placements(block, ways)) {
    Rim rim;
    place(block, ways, placement.there, &rim);
    if (grown++ < kPlacementsGrown) probe_.grow(rim);
    const bool nothing_better = !must_stop() && search_.run(std::move(rim), static_cast<std::uint64_t>(patience_));
    partial_.undo(start);
    if (!nothing_better) {
      patience_ *= kMorePatience;
      return false;
    }
  }
  most_losses_[component_] = std::max(most_losses_[component_], ++losses_);
  return true;
}

}  // namespace quadmatch::exact
