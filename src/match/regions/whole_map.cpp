#include "whole_map.hpp"

#include <quadmatch/mesh/large_pages.hpp>

namespace quadmatch::regions {

WholeMap::WholeMap(const Sides& sides)
    : source_(sides.source.mesh),
      target_(sides.target.mesh),
      image_of_first_(source_.face_count()),
      taken_(target_.face_count(), false) {
  if (source_.split_vertices().empty() && target_.split_vertices().empty()) return;
  source_partner_ = PerVertex<Partner>(source_.vertex_count());
  target_partner_ = PerVertex<Partner>(target_.vertex_count());
}

void WholeMap::forget() {
  for (const auto& [s, t] : pairs_) {
    image_of_first_[source_.face(s)] = HalfedgeId();
    taken_[target_.face(t).value] = false;
  }
  pairs_.clear();
  waves_.clear();
  ++number_;
}

bool WholeMap::grow(Candidate seed, std::uint32_t faces) {
  forget();
  reserve_on_large_pages(pairs_, faces);
  if (!reach(seed)) return false;
  for (std::size_t here = 0; here < pairs_.size(); ++here) {
    if (waves_.empty() || here == waves_.back()) waves_.push_back(static_cast<std::uint32_t>(pairs_.size()));
    if (!reach_neighbours(pairs_[here])) return false;
  }
  return pairs_.size() == faces && maps_vertices_one_to_one();
}

/// Map a face. @pre it is not mapped.
bool WholeMap::reach(Candidate pair) {
  const FaceId face = source_.face(pair.source), other = target_.face(pair.target);
  const std::uint32_t size = source_.size(face);
  if (size != target_.size(other) || taken_[other.value]) return false;
  // What lies beyond is asked for when this face's turn comes, a whole wave later.
  source_.prefetch_twins(pair.source);
  target_.prefetch_twins(pair.target);
  image_of_first_[face] = turned(target_, pair.target, size - source_.corner(pair.source));
  taken_[other.value] = true;
  pairs_.push_back(pair);
  return true;
}

/// Every neighbour lies on the neighbour across the corresponding edge, or there is none on either side.
bool WholeMap::reach_neighbours(Candidate pair) {
  auto [s, t] = pair;
  do {
    const Candidate beyond{source_.twin(s), target_.twin(t)};
    if (beyond.source.valid() != beyond.target.valid()) return false;
    if (beyond.source.valid()) {
      const HalfedgeId first = image_of_first_[source_.face(beyond.source)];
      if (first.valid() ? turned(target_, first, source_.corner(beyond.source)) != beyond.target : !reach(beyond)) {
        return false;
      }
    }
    s = source_.next(s);
    t = target_.next(t);
  } while (s != pair.source);
  return true;
}

/// A vertex of several fans is one vertex all the same, on both sides.
bool WholeMap::maps_vertices_one_to_one() {
  if (source_partner_.size() == 0) return true;
  for (const Candidate& pair : pairs_) {
    auto [s, t] = pair;
    do {
      const VertexId v = source_.origin(s), w = target_.origin(t);
      Partner& image = source_partner_[v];
      Partner& origin = target_partner_[w];
      if (image.map == number_ ? image.vertex != w : origin.map == number_) return false;
      image = {number_, w};
      origin = {number_, v};
      s = source_.next(s);
      t = target_.next(t);
    } while (s != pair.source);
  }
  return true;
}

}  // namespace quadmatch::regions
