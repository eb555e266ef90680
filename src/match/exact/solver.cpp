#include "solver.hpp"

#include <algorithm>
#include <utility>

#include <quadmatch/match/matcher.hpp>

namespace quadmatch::exact {
namespace {

/// Growth steps spent on a first region, about; and regions of other algorithms that are grown on.
constexpr std::uint64_t kProbeSteps = 1'000'000;
constexpr std::size_t kRegionsGrownOn = 4;
/// Cuts to choose the best of, unless counting placements alone would take long.
constexpr int kCuts = 4;
constexpr std::uint64_t kPlacementsToCount = 1'000'000;
/// In the first round, placements of a block that are grown greedily.
constexpr std::size_t kPlacementsGrown = 4;

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
  for (std::uint32_t c = 0; c < proved_.size(); ++c) {
    most = std::max(most, components_[side_].face_count[c] - proved_[c]);
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
  proved_.assign(components.face_count.size(), 0);
  component_faces_.resize(components.face_count.size());
  for (std::uint32_t f = 0; f < partial_.mesh(side_).face_count(); ++f) {
    component_faces_[components.of_face[FaceId(f)]].push_back(FaceId(f));
  }
  free_ = PerFace<std::uint8_t>(partial_.mesh(side_).face_count(), 1);
}

std::uint32_t Solver::missing_blocks(std::uint32_t component) const {
  const std::uint32_t done = proved_[component] + incumbent_.to_beat;
  const std::uint32_t faces = components_[side_].face_count[component];
  return faces > done ? faces - done : 0;
}

Solver::PlacedBlock Solver::with_ways(Block faces, std::uint32_t component) const {
  const Mesh& mesh = partial_.mesh(side_);
  PlacedBlock block{std::move(faces), {}, component, 0};
  for (std::size_t k = 1; k < block.faces.size(); ++k) {
    const auto end = block.faces.begin() + static_cast<std::ptrdiff_t>(k);
    for (const HalfedgeId h : mesh.halfedges(block.faces[k])) {
      const HalfedgeId across = mesh.twin(h);
      if (!across.valid() || std::find(block.faces.begin(), end, mesh.face(across)) == end) continue;
      block.ways.push_back(across);
      break;
    }
  }
  return block;
}

std::vector<Solver::PlacedBlock> Solver::cut_into_blocks() {
  std::vector<PlacedBlock> blocks;
  for (std::uint32_t c = 0; c < proved_.size(); ++c) {
    const std::uint32_t missing = missing_blocks(c);
    if (missing == 0) continue;
    for (Block& faces : part_into_blocks(partial_.mesh(side_), component_faces_[c], free_, missing, random_)) {
      blocks.push_back(with_ways(std::move(faces), c));
    }
  }
  return blocks;
}

std::vector<Solver::PlacedBlock> Solver::best_of_several_cuts() {
  std::vector<PlacedBlock> best = cut_into_blocks();
  const std::uint64_t to_try = best.size() * partial_.mesh(other(side_)).halfedge_count();
  if (to_try > kPlacementsToCount) return best;
  std::uint64_t fewest = count_placements(best);
  for (int cut = 1; cut < kCuts && !must_stop(); ++cut) {
    std::vector<PlacedBlock> blocks = cut_into_blocks();
    const std::uint64_t count = count_placements(blocks);
    if (count >= fewest) continue;
    fewest = count;
    best = std::move(blocks);
  }
  return best;
}

std::uint64_t Solver::count_placements(const std::vector<PlacedBlock>& blocks) {
  std::uint64_t count = 0;
  const Partial::Mark start = partial_.mark();
  for (const PlacedBlock& block : blocks) {
    for (std::uint32_t t = 0; t < partial_.mesh(other(side_)).halfedge_count(); ++t) {
      count += place(block, HalfedgeId(t), nullptr) ? 1 : 0;
      partial_.undo(start);
    }
    if (!budget_.work(partial_.mesh(other(side_)).halfedge_count())) break;
  }
  return count;
}

/// Commit a block, its first half-edge on `there`. False where some face of it does not fit; what was committed stays.
bool Solver::place(const PlacedBlock& block, HalfedgeId there, Rim* rim) {
  const Mesh& mesh = partial_.mesh(side_);
  const Mesh& mesh_there = partial_.mesh(other(side_));
  Pair pair = pair_of(side_, mesh.first(block.faces.front()), there);
  for (std::size_t k = 0;; ++k) {
    if (!half(pair, other(side_)).valid() || !partial_.fits(pair)) return false;
    partial_.commit(pair);
    if (rim != nullptr) extend(*rim, partial_, pair);
    if (k == block.ways.size()) return true;
    const HalfedgeId way = block.ways[k];
    pair = pair_of(side_, mesh.twin(way), mesh_there.twin(partial_.image(side_, way)));
  }
}

/// All of a block, those first of which most corners agree.
std::vector<Solver::Placement> Solver::placements(const PlacedBlock& block) {
  std::vector<Placement> placements;
  const Partial::Mark start = partial_.mark();
  for (std::uint32_t t = 0; t < partial_.mesh(other(side_)).halfedge_count(); ++t) {
    if (place(block, HalfedgeId(t), nullptr)) {
      std::uint32_t disagreeing = 0;
      for (const Pair& pair : partial_.pairs()) disagreeing += probe_.disagreeing_corners(pair);
      placements.push_back({HalfedgeId(t), disagreeing});
    }
    partial_.undo(start);
  }
  std::stable_sort(placements.begin(), placements.end(),
                   [](const Placement& a, const Placement& b) { return a.disagreeing < b.disagreeing; });
  return placements;
}

/// Search below every placement. True if no better region holds the block.
bool Solver::prove(const PlacedBlock& block) {
  const Partial::Mark start = partial_.mark();
  std::size_t grown = rounds_ == 0 ? 0 : kPlacementsGrown;
  for (const Placement& placement : placements(block)) {
    Rim rim;
    place(block, placement.there, &rim);
    if (grown++ < kPlacementsGrown) probe_.grow(rim);
    const bool nothing_better = !must_stop() && search_.run(std::move(rim), patience_);
    partial_.undo(start);
    if (!nothing_better) return false;
  }
  return true;
}

/// Those that the incumbent holds whole or nearly so first, and of these the largest: they have the fewest placements.
void Solver::order(std::vector<PlacedBlock>& blocks) const {
  PerFace<std::uint8_t> matched(partial_.mesh(side_).face_count(), 0);
  if (incumbent_.orientation == orientation_) {
    for (const Pair& pair : incumbent_.pairs) matched[partial_.mesh(side_).face(half(pair, side_))] = 1;
  }
  for (PlacedBlock& block : blocks) {
    block.lost = static_cast<std::uint32_t>(
        std::count_if(block.faces.begin(), block.faces.end(), [&](FaceId face) { return matched[face] == 0; }));
  }
  std::stable_sort(blocks.begin(), blocks.end(), [](const PlacedBlock& a, const PlacedBlock& b) {
    return a.lost != b.lost ? a.lost < b.lost : a.faces.size() > b.faces.size();
  });
}

void Solver::round() {
  if (!side_chosen_) choose_side();
  std::vector<PlacedBlock> blocks = best_of_several_cuts();
  order(blocks);
  for (PlacedBlock& block : blocks) {
    if (must_stop()) return;
    if (missing_blocks(block.component) == 0 || !prove(block)) continue;
    ++proved_[block.component];
    for (const FaceId face : block.faces) free_[face] = 0;
    partial_.add_loss_set(side_, std::move(block.faces));
  }
  ++rounds_;
  patience_ += patience_ / 2;
}

}  // namespace quadmatch::exact
