#include "probe.hpp"

#include <algorithm>
#include <random>

namespace quadmatch::exact {
namespace {

/// Faces of the source whose placements are all tried.
constexpr std::uint32_t kSampledFaces = 8;

PerVertex<VertexCode> codes_of(const Mesh& mesh) {
  const PerFan<VertexCode> of_fans = vertex_codes(mesh);
  PerVertex<VertexCode> codes(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) codes[VertexId(v)] = of_fans[FanId(v)];
  return codes;
}

}  // namespace

Probe::Probe(Partial& partial, Orientation orientation, Incumbent& incumbent, Budget& budget)
    : partial_(partial),
      orientation_(orientation),
      incumbent_(incumbent),
      budget_(budget),
      codes_{codes_of(partial.mesh(kSource)), codes_of(partial.mesh(kTarget))} {}

std::uint32_t Probe::disagreeing_corners(const Pair& pair) const {
  const Mesh& source = partial_.mesh(kSource);
  const Mesh& target = partial_.mesh(kTarget);
  std::uint32_t disagreeing = 0;
  auto [s, t] = pair;
  do {
    disagreeing += codes_[kSource][source.origin(s)] != codes_[kTarget][target.origin(t)] ? 1 : 0;
    s = source.next(s);
    t = target.next(t);
  } while (s != pair.source);
  return disagreeing;
}

/// Wait in line for what lies beyond a pair of half-edges.
void Probe::push(const Pair& inside) {
  const Pair pair = beyond(partial_, inside);
  if (!pair.source.valid() || !pair.target.valid() || !partial_.fits(pair)) return;
  queues_[std::min(disagreeing_corners(pair), kBuckets - 1)].pairs.push_back(pair);
}

void Probe::grow(const Rim& rim) {
  const Partial::Mark start = partial_.mark();
  for (Queue& queue : queues_) {
    queue.pairs.clear();
    queue.next = 0;
  }
  for (const Pair& inside : rim) push(inside);
  Rim sides;
  while (true) {
    const auto waiting = [](const Queue& queue) { return queue.next < queue.pairs.size(); };
    const auto queue = std::find_if(queues_.begin(), queues_.end(), waiting);
    if (queue == queues_.end()) break;
    const Pair pair = queue->pairs[queue->next++];
    if (!partial_.fits(pair)) continue;
    partial_.commit(pair);
    sides.clear();
    extend(sides, partial_, pair);
    for (const Pair& inside : sides) push(inside);
  }
  incumbent_.offer(partial_.pairs(), {}, orientation_);
  budget_.work(partial_.size());
  partial_.undo(start);
}

void Probe::try_placements(std::uint64_t steps) {
  const Mesh& source = partial_.mesh(kSource);
  const Mesh& target = partial_.mesh(kTarget);
  const std::uint32_t most = std::min(source.face_count(), target.face_count());
  std::mt19937 random(1);
  std::vector<Pair> placements;
  for (std::uint32_t k = 0; k < std::min(kSampledFaces, source.face_count()); ++k) {
    const FaceId f(source.face_count() <= kSampledFaces ? k
                                                        : static_cast<std::uint32_t>(random() % source.face_count()));
    for (std::uint32_t t = 0; t < target.halfedge_count(); ++t) {
      const Pair pair{source.first(f), HalfedgeId(t)};
      if (partial_.fits(pair)) placements.push_back(pair);
    }
  }
  std::stable_sort(placements.begin(), placements.end(),
                   [&](const Pair& a, const Pair& b) { return disagreeing_corners(a) < disagreeing_corners(b); });
  const Partial::Mark start = partial_.mark();
  std::uint64_t spent = 0;
  for (const Pair& pair : placements) {
    if (spent > steps || budget_.stopped() || incumbent_.enough || incumbent_.pairs.size() == most) return;
    Rim rim;
    partial_.commit(pair);
    extend(rim, partial_, pair);
    grow(rim);
    partial_.undo(start);
    spent += 16 + most;
  }
}

void Probe::try_regions(const std::vector<std::vector<Pair>>& regions) {
  const Partial::Mark start = partial_.mark();
  for (const std::vector<Pair>& region : regions) {
    Rim rim;
    for (const Pair& pair : region) {
      if (!partial_.fits(pair)) break;
      partial_.commit(pair);
      extend(rim, partial_, pair);
    }
    if (partial_.size() > 0) grow(rim);
    partial_.undo(start);
  }
}

}  // namespace quadmatch::exact
