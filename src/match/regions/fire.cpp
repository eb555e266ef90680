#include "fire.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace quadmatch::regions {
namespace {

constexpr std::uint32_t kLeaf = 0xffffffff;
/// Farther faces share one bucket: the order among them no longer matters, and the queue stays short.
constexpr std::uint32_t kFarthest = 1 << 16;

/// All corners at a vertex, of every fan.
template <class Visit>
bool every_corner(const Mesh& mesh, HalfedgeId at, Visit visit) {
  for (const HalfedgeId h : mesh.outgoing(mesh.fan(at))) {
    if (!visit(h)) return false;
  }
  return true;
}

}  // namespace

void Account::add(const Account& other) {
  faces += other.faces;
  agreeing += other.agreeing;
  source_extraordinary += other.source_extraordinary;
  target_extraordinary += other.target_extraordinary;
  disagreeing += other.disagreeing;
}

double Account::confidence() const {
  const std::uint32_t touched = std::min(source_extraordinary, target_extraordinary);
  return touched == 0 ? 1.0 : static_cast<double>(agreeing) / touched;
}

bool believable(const Account& account, double least_confidence) {
  if (account.disagreeing == 0) return true;
  if (account.agreeing == 0 || account.confidence() < least_confidence) return false;
  return account.agreeing > 2 || account.disagreeing < 3;
}

Fire::Fire(const Sides& sides, Patchwork& patchwork)
    : source_(sides.source.mesh),
      target_(sides.target.mesh),
      patchwork_(patchwork),
      source_vertices_(source_.vertex_count()),
      target_vertices_(target_.vertex_count()),
      distance_(source_.face_count()),
      parent_(patchwork.region_count()),
      accounts_(patchwork.region_count()) {
  std::iota(parent_.begin(), parent_.end(), 0U);
  for (std::uint32_t v = 0; v < source_.vertex_count(); ++v) {
    source_vertices_[VertexId(v)].code = sides.source.code(VertexId(v));
  }
  for (std::uint32_t v = 0; v < target_.vertex_count(); ++v) {
    target_vertices_[VertexId(v)].code = sides.target.code(VertexId(v));
  }
  if (patchwork.matched_faces() == 0) return;
  recount();
  rekindle();
}

std::uint32_t Fire::find(std::uint32_t region) {
  while (parent_[region] != region) region = parent_[region] = parent_[parent_[region]];
  return region;
}

void Fire::push(Candidate candidate, std::uint32_t distance) {
  distance = std::min(distance, kFarthest);
  if (distance >= buckets_.size()) buckets_.resize(distance + 1);
  buckets_[distance].candidates.push_back(candidate);
  current_ = std::min(current_, distance);
}

void Fire::light(std::vector<Spark> sparks) {
  sparks_ = std::move(sparks);
  next_spark_ = 0;
}

/// Start a region from every spark whose time has come.
void Fire::light_due(std::uint32_t distance) {
  while (next_spark_ < sparks_.size() && sparks_[next_spark_].handicap <= distance) {
    const Candidate place = sparks_[next_spark_++].place;
    if (!is_free(place) || source_.size(source_.face(place.source)) != target_.size(target_.face(place.target))) {
      continue;
    }
    const std::uint32_t region = patchwork_.fresh_region();
    parent_.push_back(region);
    accounts_.emplace_back();
    accept(place, region, 0, false);
  }
}

void Fire::burn() {
  for (;;) {
    while (current_ < buckets_.size() && buckets_[current_].candidates.empty()) ++current_;
    const bool waiting = next_spark_ < sparks_.size();
    if (current_ >= buckets_.size()) {
      if (!waiting) return;
      light_due(sparks_[next_spark_].handicap);
      continue;
    }
    if (waiting && sparks_[next_spark_].handicap <= current_) {
      light_due(current_);
      continue;
    }
    Bucket& bucket = buckets_[current_];
    prefetch(bucket);
    const Candidate candidate = bucket.candidates[bucket.head++];
    const std::uint32_t distance = current_;
    if (bucket.head == bucket.candidates.size()) {
      bucket.candidates.clear();
      bucket.head = 0;
    }
    consider(candidate, distance);
  }
}

void Fire::prefetch(const Bucket& bucket) const {
  constexpr std::size_t kFacesAhead = 24, kVerticesAhead = 12;
  const std::size_t head = bucket.head;
  if (head + kFacesAhead < bucket.candidates.size()) {
    const Candidate ahead = bucket.candidates[head + kFacesAhead];
    source_.prefetch(ahead.source);
    target_.prefetch(ahead.target);
  }
  if (head + kVerticesAhead < bucket.candidates.size()) {
    const Candidate ahead = bucket.candidates[head + kVerticesAhead];
    HalfedgeId s = turned(source_, ahead.source, 2), t = turned(target_, ahead.target, 2);
    for (int corner = 0; corner < 2; ++corner) {
      __builtin_prefetch(&source_vertices_[source_.origin(s)]);
      __builtin_prefetch(&target_vertices_[target_.origin(t)]);
      s = source_.next(s);
      t = target_.next(t);
    }
  }
}

std::uint32_t Fire::root_beside(Candidate candidate) {
  return find(patchwork_.region(source_.face(source_.twin(candidate.source))));
}

void Fire::consider(Candidate candidate, std::uint32_t distance) {
  if (!is_free(candidate)) return;
  const std::uint32_t root = root_beside(candidate);
  const Fit fit = fit_of(candidate, root);
  if (!fit.fits) return;
  if (fit.disagreeing > 0) {
    deferred_.push_back({candidate, distance, fit.disagreeing});
  } else {
    accept(candidate, root, distance, false);
  }
}

void Fire::burn_disagreeing() {
  std::stable_sort(deferred_.begin(), deferred_.end(), [](const Deferred& a, const Deferred& b) {
    return a.disagreeing != b.disagreeing ? a.disagreeing < b.disagreeing : a.distance < b.distance;
  });
  for (const auto& [candidate, distance, disagreeing] : deferred_) {
    if (!is_free(candidate)) continue;
    const std::uint32_t root = root_beside(candidate);
    if (fit_of(candidate, root).fits) accept(candidate, root, distance, true);
  }
  deferred_.clear();
}

Fire::Fit Fire::fit_of(Candidate candidate, std::uint32_t root) {
  if (source_.size(source_.face(candidate.source)) != target_.size(target_.face(candidate.target))) return {};
  std::uint32_t disagreeing = 0;
  auto [s, t] = candidate;
  do {
    const VertexId v = source_.origin(s), w = target_.origin(t);
    if (!corner_fits(v, w, s, t, root) || !edge_fits(s, t, root)) return {};
    disagreeing += source_vertices_[v].code != target_vertices_[w].code;
    s = source_.next(s);
    t = target_.next(t);
  } while (s != candidate.source);
  return {true, disagreeing};
}

/// May v lie on w within this region? The first partners answer at once where nothing is contested; else the faces
/// about both vertices do, exactly.
bool Fire::corner_fits(VertexId v, VertexId w, HalfedgeId s, HalfedgeId t, std::uint32_t root) {
  const VertexState& left = source_vertices_[v];
  const VertexState& right = target_vertices_[w];
  if (!left.contested && !right.contested) {
    if (left.partner == w || is_new(left, right)) return true;
  }
  return every_corner(source_, s,
                      [&](HalfedgeId h) {
                        return !belongs(source_.face(h), root) || target_.origin(patchwork_.image(h)) == w;
                      }) &&
         every_corner(target_, t, [&](HalfedgeId h) {
           const FaceId origin = patchwork_.origin(target_.face(h));
           return !origin.valid() || !belongs(origin, root) || source_.origin(patchwork_.preimage(h)) == v;
         });
}

/// Faces of the region across this edge must be each other's images.
bool Fire::edge_fits(HalfedgeId s, HalfedgeId t, std::uint32_t root) {
  const HalfedgeId beside = source_.twin(s);
  const HalfedgeId beside_target = target_.twin(t);
  if (beside.valid() && belongs(source_.face(beside), root)) return patchwork_.image(beside) == beside_target;
  if (!beside_target.valid()) return true;
  const FaceId origin = patchwork_.origin(target_.face(beside_target));
  return !origin.valid() || !belongs(origin, root);
}

void Fire::accept(Candidate candidate, std::uint32_t root, std::uint32_t distance, bool leaf) {
  const FaceId face = source_.face(candidate.source);
  patchwork_.lay(candidate, root);
  if (note_vertices(candidate, root)) distance = 0;
  distance_[face] = leaf ? kLeaf : distance;
  auto [s, t] = candidate;
  do {
    const Candidate beyond{source_.twin(s), target_.twin(t)};
    if (beyond.source.valid()) {
      if (patchwork_.is_matched(source_.face(beyond.source))) {
        unite(candidate, root, beyond);
      } else if (!leaf && beyond.target.valid() && !patchwork_.is_taken(target_.face(beyond.target))) {
        push(beyond, distance + 1);
      }
    }
    s = source_.next(s);
    t = target_.next(t);
  } while (s != candidate.source);
}

/// Count a face of a region, and give its vertices their partners. @return whether it is evidence: an extraordinary
/// vertex agrees.
bool Fire::note_vertices(Candidate candidate, std::uint32_t root) {
  Account met{.faces = 1};
  bool evidence = false;
  auto [s, t] = candidate;
  do {
    const VertexId v = source_.origin(s), w = target_.origin(t);
    VertexState& left = source_vertices_[v];
    VertexState& right = target_vertices_[w];
    // Without branches: which vertices are new nobody can guess. All bits are set where there is no partner.
    const bool tells = left.code.extraordinary(), agrees = left.code == right.code;
    const bool is_first = is_new(left, right);
    evidence |= tells & agrees;
    met.source_extraordinary += is_first & tells;
    met.target_extraordinary += is_first & right.code.extraordinary();
    met.agreeing += is_first & tells & agrees;
    met.disagreeing += is_first & !agrees;
    const std::uint32_t kept = is_first ? 0 : VertexId::kNone;
    left.partner.value &= w.value | kept;
    right.partner.value &= v.value | kept;
    const bool is_contested = left.partner != w;
    left.contested |= is_contested;
    right.contested |= is_contested;
    s = source_.next(s);
    t = target_.next(t);
  } while (s != candidate.source);
  accounts_[root].add(met);
  return evidence;
}

/// Make one region of a face's and that of a matched face beyond an edge, if they agree.
void Fire::unite(Candidate candidate, std::uint32_t region, Candidate beyond) {
  const std::uint32_t other = find(patchwork_.region(source_.face(beyond.source))), root = find(region);
  if (other == root || patchwork_.image(beyond.source) != beyond.target || !fit_of(candidate, other).fits) return;
  parent_[std::max(root, other)] = std::min(root, other);
  accounts_[std::min(root, other)].add(accounts_[std::max(root, other)]);
}

void Fire::push_neighbours(Candidate candidate, std::uint32_t distance) {
  auto [s, t] = candidate;
  do {
    const Candidate beyond{source_.twin(s), target_.twin(t)};
    if (beyond.source.valid() && beyond.target.valid() && is_free(beyond)) push(beyond, distance);
    s = source_.next(s);
    t = target_.next(t);
  } while (s != candidate.source);
}

std::size_t Fire::drop_unbelievable(double least_confidence) {
  std::vector<bool> dropped(parent_.size(), false);
  for (std::uint32_t region = 0; region < parent_.size(); ++region) {
    if (parent_[region] != region || accounts_[region].faces == 0) continue;
    dropped[region] = !believable(accounts_[region], least_confidence);
  }
  for (const std::uint32_t region : protected_) dropped[find(region)] = false;
  const bool any = std::find(dropped.begin(), dropped.end(), true) != dropped.end();
  if (!any) return 0;
  const std::size_t before = patchwork_.matched_faces();
  for (const HalfedgeId entry : patchwork_.history()) {
    const FaceId face = source_.face(entry);
    if (dropped[find(patchwork_.region(face))]) patchwork_.lift(face);
  }
  patchwork_.tidy_history();
  recount();
  return before - patchwork_.matched_faces();
}

/// Forget all vertices, and note them again from what is matched now.
void Fire::recount() {
  for (std::uint32_t v = 0; v < source_.vertex_count(); ++v) {
    source_vertices_[VertexId(v)].partner = VertexId();
    source_vertices_[VertexId(v)].contested = false;
  }
  for (std::uint32_t v = 0; v < target_.vertex_count(); ++v) {
    target_vertices_[VertexId(v)].partner = VertexId();
    target_vertices_[VertexId(v)].contested = false;
  }
  std::fill(accounts_.begin(), accounts_.end(), Account());
  for (const HalfedgeId entry : patchwork_.history()) {
    const std::uint32_t root = find(patchwork_.region(source_.face(entry)));
    note_vertices({entry, patchwork_.image(entry)}, root);
  }
}

void Fire::rekindle() {
  for (const HalfedgeId entry : patchwork_.history()) {
    const std::uint32_t distance = distance_[source_.face(entry)];
    if (distance != kLeaf) push_neighbours({entry, patchwork_.image(entry)}, distance + 1);
  }
}

std::vector<Account> Fire::settle() {
  for (const HalfedgeId entry : patchwork_.history()) {
    const FaceId face = source_.face(entry);
    patchwork_.set_region(face, find(patchwork_.region(face)));
  }
  return accounts_;
}

}  // namespace quadmatch::regions
