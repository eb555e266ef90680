#include "growth.hpp"

namespace quadmatch {

Growth::Growth(const Mesh& source, const PerFan<VertexCode>& source_codes, const Mesh& target,
               const PerFan<VertexCode>& target_codes)
    : source_(source),
      target_(target),
      matched_(source.face_count(), false),
      taken_(target.face_count(), false),
      folded_(has_folded_face(source) || has_folded_face(target)),
      image_of_first_(source.face_count()),
      source_vertices_(unpaired(source, source_codes)),
      target_vertices_(unpaired(target, target_codes)) {}

bool Growth::has_folded_face(const Mesh& mesh) {
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    const HalfedgeRange halfedges = mesh.halfedges(FaceId(f));
    for (const HalfedgeId h : halfedges) {
      for (const HalfedgeId before : halfedges) {
        if (before < h && mesh.origin(before) == mesh.origin(h)) return true;
      }
    }
  }
  return false;
}

PerVertex<Growth::VertexState> Growth::unpaired(const Mesh& mesh, const PerFan<VertexCode>& codes) {
  PerVertex<VertexState> vertices(mesh.vertex_count());
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) vertices[VertexId(v)].code = codes[FanId(v)];
  return vertices;
}

HalfedgeId Growth::image(HalfedgeId h) const {
  const HalfedgeId first = image_of_first_[source_.face(h)];
  const std::uint32_t corner = source_.corner(h);
  if (target_.all_quads()) return HalfedgeId((first.value & ~3U) | ((first.value + corner) & 3U));
  const FaceId face = target_.face(first);
  const std::uint32_t start = target_.first(face).value;
  const std::uint32_t size = target_.size(face);
  return HalfedgeId(start + (first.value - start + corner) % size);
}

bool Growth::fits(Candidate candidate) const {
  const FaceId q = source_.face(candidate.source);
  const FaceId r = target_.face(candidate.target);
  if (is_matched(q) || is_taken(r)) return false;
  const std::uint32_t size = source_.size(q);
  return size == target_.size(r) && corners_agree(candidate, size) && (!folded_ || revisits_agree(candidate, size)) &&
         neighbours_agree(candidate, size);
}

/// A degenerate face visits a vertex twice; then its partner must do so at the same corners.
bool Growth::revisits_agree(Candidate candidate, std::uint32_t size) const {
  auto [s, t] = candidate;
  for (std::uint32_t corner = 1; corner < size; ++corner) {
    s = source_.next(s);
    t = target_.next(t);
    auto [before_s, before_t] = candidate;
    for (std::uint32_t before = 0; before < corner; ++before) {
      const bool again = source_.origin(before_s) == source_.origin(s);
      if (again != (target_.origin(before_t) == target_.origin(t))) return false;
      before_s = source_.next(before_s);
      before_t = target_.next(before_t);
    }
  }
  return true;
}

/// The vertex map stays a function and one-to-one.
bool Growth::corners_agree(Candidate candidate, std::uint32_t size) const {
  auto [s, t] = candidate;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const VertexId image = source_vertices_[source_.origin(s)].partner;
    const VertexId w = target_.origin(t);
    if (image.valid() ? image != w : target_vertices_[w].partner.valid()) return false;
    s = source_.next(s);
    t = target_.next(t);
  }
  return true;
}

/// Differs: §3 maps faces only; here corresponding edges must carry the adjacency, so that vertex data can follow.
/// §3: "q1 and q2 are adjacent in S1 if and only if mu(q1) and mu(q2) are adjacent", across corresponding edges. On a
/// simple mesh the vertex map implies it; where two edges join the same vertices, or a seam lies between, it does not.
bool Growth::neighbours_agree(Candidate candidate, std::uint32_t size) const {
  auto [s, t] = candidate;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const HalfedgeId beyond = source_.twin(s);
    const HalfedgeId beyond_target = target_.twin(t);
    if (beyond.valid() && is_matched(source_.face(beyond))) {
      if (image(beyond) != beyond_target) return false;
    } else if (beyond_target.valid() && is_taken(target_.face(beyond_target))) {
      return false;
    }
    s = source_.next(s);
    t = target_.next(t);
  }
  return true;
}

std::uint32_t Growth::disagreeing_corners(Candidate candidate) const {
  std::uint32_t disagreeing = 0;
  HalfedgeId s = source_.next(source_.next(candidate.source));
  HalfedgeId t = target_.next(target_.next(candidate.target));
  while (s != candidate.source) {
    disagreeing += source_vertices_[source_.origin(s)].code != target_vertices_[target_.origin(t)].code;
    s = source_.next(s);
    t = target_.next(t);
  }
  return disagreeing;
}

void Growth::prefetch_vertices(Candidate candidate) const {
  // The two ends of the edge are matched and near; what is far is beyond.
  HalfedgeId s = source_.next(source_.next(candidate.source));
  HalfedgeId t = target_.next(target_.next(candidate.target));
  while (s != candidate.source) {
    __builtin_prefetch(&source_vertices_[source_.origin(s)]);
    __builtin_prefetch(&target_vertices_[target_.origin(t)]);
    s = source_.next(s);
    t = target_.next(t);
  }
}

void Growth::accept(Candidate candidate) {
  const FaceId q = source_.face(candidate.source);
  const FaceId r = target_.face(candidate.target);
  matched_[q.value] = true;
  taken_[r.value] = true;
  order_.push_back(candidate);
  auto [s, t] = candidate;
  for (std::uint32_t corner = source_.size(q); corner > 0; --corner) {
    source_vertices_[source_.origin(s)].partner = target_.origin(t);
    target_vertices_[target_.origin(t)].partner = source_.origin(s);
    if (s == source_.first(q)) image_of_first_[q] = t;
    s = source_.next(s);
    t = target_.next(t);
  }
}

void Growth::clear() {
  for (const Candidate& pair : order_) {
    const FaceId q = source_.face(pair.source);
    const FaceId r = target_.face(pair.target);
    matched_[q.value] = false;
    taken_[r.value] = false;
    image_of_first_[q] = HalfedgeId();
    for (const HalfedgeId h : source_.halfedges(q)) source_vertices_[source_.origin(h)].partner = VertexId();
    for (const HalfedgeId h : target_.halfedges(r)) target_vertices_[target_.origin(h)].partner = VertexId();
  }
  order_.clear();
  waves_.clear();
}

std::size_t Growth::extraordinary_corners() const {
  std::size_t corners = 0;
  for (const Candidate& pair : order_) {
    for (const HalfedgeId h : source_.halfedges(source_.face(pair.source))) {
      corners += source_vertices_[source_.origin(h)].code.extraordinary();
    }
  }
  return corners;
}

Region Growth::region(Orientation orientation, bool with_waves) const {
  Region region;
  region.orientation = orientation;
  region.faces.reserve(order_.size());
  for (const Candidate& pair : order_) {
    const FaceId q = source_.face(pair.source);
    const HalfedgeId first = image_of_first_[q];
    const std::uint32_t corner = target_.corner(first);
    const FaceId r = target_.face(first);
    // In the mirror corner k is corner n - 1 - k of the face as it was given (Mesh::mirrored).
    const bool preserving = orientation == Orientation::Preserving;
    region.faces.push_back({q, r, preserving ? corner : target_.size(r) - 1 - corner});
  }
  if (with_waves) region.waves = waves_;
  return region;
}

std::vector<VertexPair> Growth::vertex_pairs() const {
  std::vector<VertexPair> pairs;
  for (std::uint32_t v = 0; v < source_.vertex_count(); ++v) {
    const VertexId image = source_vertices_[VertexId(v)].partner;
    if (image.valid()) pairs.push_back({VertexId(v), image});
  }
  return pairs;
}

}  // namespace quadmatch
