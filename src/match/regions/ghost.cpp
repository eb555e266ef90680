#include "ghost.hpp"

namespace quadmatch::regions {

Ghost::Ghost(const Sides& sides, const Patchwork& patchwork)
    : source_(sides.source.mesh), target_(sides.target.mesh), patchwork_(patchwork) {}

void Ghost::restart(std::uint32_t base) {
  if (pair_of_.size() == 0) make_room();
  for (const Candidate& pair : pairs_) {
    const FaceId face = source_.face(pair.source), other = target_.face(pair.target);
    pair_of_[face] = pair_on_[other] = kNone;
    for (const HalfedgeId h : source_.halfedges(face)) source_partner_[source_.origin(h)] = VertexId();
    for (const HalfedgeId h : target_.halfedges(other)) target_partner_[target_.origin(h)] = VertexId();
  }
  pairs_.clear();
  base_ = base;
}

void Ghost::make_room() {
  pair_of_ = PerFace<std::uint32_t>(source_.face_count(), kNone);
  pair_on_ = PerFace<std::uint32_t>(target_.face_count(), kNone);
  source_partner_ = PerVertex<VertexId>(source_.vertex_count());
  target_partner_ = PerVertex<VertexId>(target_.vertex_count());
}

HalfedgeId Ghost::image(HalfedgeId h) const {
  const FaceId face = source_.face(h);
  if (pair_of_[face] == kNone) return patchwork_.image(h);
  const Candidate& pair = pairs_[pair_of_[face]];
  const std::uint32_t size = source_.size(face);
  return turned(target_, pair.target, source_.corner(h) + size - source_.corner(pair.source));
}

VertexId Ghost::partner_of_source(HalfedgeId s) const {
  const VertexId partner = source_partner_[source_.origin(s)];
  if (partner.valid() || base_ == Patchwork::kNoRegion) return partner;
  for (const HalfedgeId h : source_.outgoing(source_.fan(s))) {
    if (in_base(source_.face(h))) return target_.origin(patchwork_.image(h));
  }
  return {};
}

VertexId Ghost::partner_of_target(HalfedgeId t) const {
  const VertexId partner = target_partner_[target_.origin(t)];
  if (partner.valid() || base_ == Patchwork::kNoRegion) return partner;
  for (const HalfedgeId h : target_.outgoing(target_.fan(t))) {
    const FaceId origin = patchwork_.origin(target_.face(h));
    if (origin.valid() && in_base(origin)) return source_.origin(patchwork_.preimage(h));
  }
  return {};
}

bool Ghost::fits(Candidate pair) const {
  const FaceId face = source_.face(pair.source), other = target_.face(pair.target);
  if (covers(face) || covers_target(other) || source_.size(face) != target_.size(other)) return false;
  auto [s, t] = pair;
  do {
    const VertexId partner = partner_of_source(s);
    if (partner.valid() ? partner != target_.origin(t) : partner_of_target(t).valid()) return false;
    const HalfedgeId beside = source_.twin(s), beside_target = target_.twin(t);
    if (beside.valid() && covers(source_.face(beside))) {
      if (image(beside) != beside_target) return false;
    } else if (beside_target.valid() && covers_target(target_.face(beside_target))) {
      return false;
    }
    s = source_.next(s);
    t = target_.next(t);
  } while (s != pair.source);
  return true;
}

void Ghost::accept(Candidate pair) {
  const auto number = static_cast<std::uint32_t>(pairs_.size());
  pair_of_[source_.face(pair.source)] = number;
  pair_on_[target_.face(pair.target)] = number;
  pairs_.push_back(pair);
  auto [s, t] = pair;
  do {
    source_partner_[source_.origin(s)] = target_.origin(t);
    target_partner_[target_.origin(t)] = source_.origin(s);
    s = source_.next(s);
    t = target_.next(t);
  } while (s != pair.source);
}

}  // namespace quadmatch::regions
