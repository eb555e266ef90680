#include "development.hpp"

#include <algorithm>

namespace quadmatch::exact {
namespace {

std::size_t most(const Partial& partial, std::uint32_t (Mesh::*count)() const) {
  return std::max((partial.mesh(kSource).*count)(), (partial.mesh(kTarget).*count)());
}

}  // namespace

Development::Development(const Partial& partial)
    : partial_(partial),
      labels_(most(partial, &Mesh::face_count)),
      taken_(labels_.size()),
      image_(most(partial, &Mesh::vertex_count)),
      origin_(image_.size()),
      packed_(labels_.size(), 0),
      reach_stamp_(labels_.size(), 0) {}

std::uint32_t Development::count_reach(Side side, const Rim& rim) {
  const Mesh& mesh = partial_.mesh(side);
  ++reach_;
  to_visit_.clear();
  const auto visit = [&](HalfedgeId h) {
    if (!h.valid()) return;
    const FaceId face = mesh.face(h);
    if (!partial_.is_open(side, face) || reach_stamp_[face] == reach_) return;
    reach_stamp_[face] = reach_;
    to_visit_.push_back(face);
  };
  for (const Pair& pair : rim) visit(mesh.twin(half(pair, side)));
  for (std::size_t next = 0; next < to_visit_.size(); ++next) {
    for (const HalfedgeId h : mesh.halfedges(to_visit_[next])) visit(mesh.twin(h));
  }
  return static_cast<std::uint32_t>(to_visit_.size());
}

HalfedgeId Development::label_of(HalfedgeId here) const {
  const Mesh& mesh = partial_.mesh(side_);
  return partial_.turned(other(side_), labels_[mesh.face(here)].image, mesh.corner(here));
}

/// The labelled face that a pair clashes with; not valid where there is none.
FaceId Development::opponent(const Pair& pair) const {
  const HalfedgeId here = half(pair, side_), there = half(pair, other(side_));
  const Mesh& mesh = partial_.mesh(side_);
  const Owned& taken = taken_[partial_.mesh(other(side_)).face(there)];
  if (taken.stamp == stamp_) return taken.owner;
  const std::uint32_t size = mesh.size(mesh.face(here));
  const FaceId at_corner = corner_opponent(here, there, size);
  return at_corner.valid() ? at_corner : edge_opponent(here, there, size);
}

FaceId Development::corner_opponent(HalfedgeId here, HalfedgeId there, std::uint32_t size) const {
  const Mesh& mesh = partial_.mesh(side_);
  const Mesh& mesh_there = partial_.mesh(other(side_));
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const Owned& image = image_[mesh.origin(here)];
    const VertexId w = mesh_there.origin(there);
    if (image.stamp == stamp_) {
      if (image.value != w.value) return image.owner;
    } else if (origin_[w].stamp == stamp_) {
      return origin_[w].owner;
    }
    here = mesh.next(here);
    there = mesh_there.next(there);
  }
  return {};
}

FaceId Development::edge_opponent(HalfedgeId here, HalfedgeId there, std::uint32_t size) const {
  const Mesh& mesh = partial_.mesh(side_);
  const Mesh& mesh_there = partial_.mesh(other(side_));
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const HalfedgeId b = mesh.twin(here), c = mesh_there.twin(there);
    if (b.valid() && is_labelled(mesh.face(b))) {
      if (label_of(b) != c) return mesh.face(b);
    } else if (c.valid() && taken_[mesh_there.face(c)].stamp == stamp_) {
      return taken_[mesh_there.face(c)].owner;
    }
    here = mesh.next(here);
    there = mesh_there.next(there);
  }
  return {};
}

void Development::put_label(const Pair& pair, FaceId parent) {
  const Mesh& mesh = partial_.mesh(side_);
  const HalfedgeId here = half(pair, side_), there = half(pair, other(side_));
  const FaceId face = mesh.face(here);
  const std::uint32_t size = mesh.size(face), corner = mesh.corner(here);
  labels_[face] = {stamp_, partial_.turned(other(side_), there, corner == 0 ? 0 : size - corner), parent};
  taken_[partial_.mesh(other(side_)).face(there)] = {stamp_, 0, face};
  claim_corners(pair);
  queue_.push_back(pair);
}

/// Label the face of a pair, or say what it clashes with. False on a clash.
bool Development::reach(const Pair& pair, FaceId parent) {
  const HalfedgeId here = half(pair, side_), there = half(pair, other(side_));
  const FaceId face = partial_.mesh(side_).face(here);
  if (!partial_.is_open(side_, face) || is_packed(face) || !is_within(face)) return true;
  if (is_labelled(face)) {
    if (label_of(here) == there) return true;
    clash_opponent_ = face;
  } else if (!there.valid() || !partial_.fits(pair)) {
    clash_opponent_ = FaceId();
  } else {
    clash_opponent_ = opponent(pair);
    if (!clash_opponent_.valid()) {
      put_label(pair, parent);
      return true;
    }
  }
  clash_parent_ = parent;
  clash_face_ = face;
  return false;
}

/// Breadth first, so that the first clash has short paths. False where there is one; called again after its faces are
/// packed, it goes on from there.
bool Development::develop(const Rim& rim) {
  const Mesh& mesh = partial_.mesh(side_);
  const Mesh& mesh_there = partial_.mesh(other(side_));
  for (const Pair& inside : rim) {
    const Pair pair = beyond(partial_, inside);
    if (half(pair, side_).valid() && !reach(pair, FaceId())) return false;
  }
  for (; !cut_off_.empty(); cut_off_.pop_back()) {
    for (const HalfedgeId here : mesh.halfedges(cut_off_.back())) {
      const HalfedgeId across = mesh.twin(here);
      if (!across.valid() || !is_labelled(mesh.face(across))) continue;
      if (!reach(pair_of(side_, here, mesh_there.twin(label_of(across))), mesh.face(across))) return false;
    }
  }
  for (; next_ < queue_.size(); ++next_) {
    if (!reach_around(queue_[next_])) return false;
  }
  return true;
}

/// Reach what lies beside a labelled face. False on a clash, unless clashes are to be passed over.
bool Development::reach_around(Pair pair, bool pass_over) {
  const Mesh& mesh = partial_.mesh(side_);
  const FaceId face = mesh.face(half(pair, side_));
  for (std::uint32_t corner = mesh.size(face); corner > 0; --corner) {
    const Pair across = beyond(partial_, pair);
    if (half(across, side_).valid() && !reach(across, face) && !pass_over) return false;
    pair = {partial_.mesh(kSource).next(pair.source), partial_.mesh(kTarget).next(pair.target)};
  }
  return true;
}

void Development::spread(Side side, const Rim& rim) {
  begin_packing(side);
  level_ = 0;
  for (const Pair& inside : rim) {
    const Pair pair = beyond(partial_, inside);
    if (half(pair, side_).valid()) reach(pair, FaceId());
  }
  for (std::size_t k = 0; k < queue_.size(); ++k) reach_around(queue_[k], true);
}

/// Take the labels of packed faces away, and of all whose path to the rim went through them; those may have another.
void Development::prune() {
  std::size_t kept = 0, kept_before_next = 0;
  const Mesh& mesh = partial_.mesh(side_);
  for (std::size_t k = 0; k < queue_.size(); ++k) {
    const FaceId face = mesh.face(half(queue_[k], side_));
    const FaceId parent = labels_[face].parent;
    if (!is_packed(face) && (!parent.valid() || is_labelled(parent))) {
      kept_before_next += k < next_ ? 1 : 0;
      queue_[kept++] = queue_[k];
      continue;
    }
    take_label(queue_[k]);
    if (!is_packed(face)) cut_off_.push_back(face);
  }
  queue_.resize(kept);
  next_ = kept_before_next;
  for (const Pair& pair : queue_) claim_corners(pair);
}

void Development::take_label(const Pair& pair) {
  const Mesh& mesh = partial_.mesh(side_);
  const Mesh& mesh_there = partial_.mesh(other(side_));
  const FaceId face = mesh.face(half(pair, side_)), face_there = mesh_there.face(half(pair, other(side_)));
  labels_[face].stamp = 0;
  taken_[face_there].stamp = 0;
  for (const HalfedgeId h : mesh.halfedges(face)) {
    if (image_[mesh.origin(h)].owner == face) image_[mesh.origin(h)].stamp = 0;
  }
  for (const HalfedgeId h : mesh_there.halfedges(face_there)) {
    if (origin_[mesh_there.origin(h)].owner == face) origin_[mesh_there.origin(h)].stamp = 0;
  }
}

/// The vertices of a labelled face that no other speaks for.
void Development::claim_corners(const Pair& pair) {
  const Mesh& mesh = partial_.mesh(side_);
  const Mesh& mesh_there = partial_.mesh(other(side_));
  HalfedgeId here = half(pair, side_), there = half(pair, other(side_));
  const FaceId face = mesh.face(here);
  for (std::uint32_t corner = mesh.size(face); corner > 0; --corner) {
    const VertexId v = mesh.origin(here), w = mesh_there.origin(there);
    if (image_[v].stamp != stamp_) image_[v] = {stamp_, w.value, face};
    if (origin_[w].stamp != stamp_) origin_[w] = {stamp_, v.value, face};
    here = mesh.next(here);
    there = mesh_there.next(there);
  }
}

bool Development::is_within(FaceId face) const {
  if (level_ == 0) return true;
  const std::uint32_t level = partial_.level(side_, face);
  return level != Partial::kNoLevel && level >= level_;
}

void Development::pack_face(FaceId face) {
  packed_[face] = packing_;
  const std::uint32_t level = partial_.level(side_, face);
  if (level != Partial::kNoLevel && std::find(touched_.begin(), touched_.end(), level) == touched_.end()) {
    touched_.push_back(level);
  }
}

/// The faces from here back to the rim, or to where another path of the same clash joins.
void Development::pack_path(FaceId face) {
  for (; face.valid() && !is_packed(face); face = labels_[face].parent) pack_face(face);
}

void Development::pack_clash() {
  touched_.clear();
  pack_path(clash_parent_);
  pack_path(clash_opponent_);
  pack_face(clash_face_);
  for (const std::uint32_t level : touched_) ++touches_[level];
  ++sets_;
  prune();
}

/// What the ring of a level must lose, should that be more than the sets which touch it: then they are not counted.
std::uint32_t Development::unpaid_beyond_sets(std::uint32_t level) const {
  if (level < level_) return 0;
  const std::uint32_t unpaid = partial_.levels()[level].unpaid();
  return unpaid > touches_[level] ? unpaid - touches_[level] : 0;
}

std::uint32_t Development::losses() const {
  std::uint32_t losses = sets_;
  if (side_ != partial_.level_side()) return losses;
  for (std::uint32_t level = level_; level < partial_.levels().size(); ++level) losses += unpaid_beyond_sets(level);
  return losses;
}

Pair Development::root_of_clash(const Rim& rim) const {
  FaceId root = clash_parent_.valid() ? clash_parent_ : clash_face_;
  while (is_labelled(root) && labels_[root].parent.valid()) root = labels_[root].parent;
  for (const Pair& inside : rim) {
    const Pair pair = beyond(partial_, inside);
    const HalfedgeId here = half(pair, side_);
    if (here.valid() && partial_.mesh(side_).face(here) == root) return pair;
  }
  return {};
}

void Development::begin_packing(Side side) {
  side_ = side;
  sets_ = 0;
  ++packing_;
  ++stamp_;
  queue_.clear();
  cut_off_.clear();
  touches_.assign(partial_.levels().size(), 0);
}

Packing Development::pack(std::uint32_t level, const Rim& rim, std::uint32_t enough) {
  level_ = level;
  next_ = 0;  // what was outside may be within now
  Packing packing;
  bool first = true;
  while (losses() < enough) {
    if (develop(rim)) {
      packing.free_of_conflict = sets_ == 0;
      break;
    }
    if (first) packing.root = root_of_clash(rim);
    first = false;
    pack_clash();
  }
  packing.losses = losses();
  return packing;
}

}  // namespace quadmatch::exact
