#include "slits.hpp"

#include <algorithm>

#include <quadmatch/mesh/check.hpp>

namespace quadmatch::exact {
namespace {

/// Spheres with holes, each edge of two faces at most, and vertices that are not pinched.
bool is_simple(const Mesh& mesh) {
  const CheckReport report = check(mesh, 0);
  return mesh.seams().empty() && std::all_of(report.components.begin(), report.components.end(), [](const auto& part) {
           return part.manifold && part.orientable && part.genus == 0U;
         });
}

}  // namespace

Slits::Slits(Partial& partial, const FacesAt& faces_at)
    : partial_(partial),
      faces_at_(faces_at),
      allowed_(is_simple(partial.mesh(kSource)) && is_simple(partial.mesh(kTarget))),
      labelled_(std::max(partial.mesh(kSource).face_count(), partial.mesh(kTarget).face_count()), 0),
      shallow_stamp_(labelled_.size(), 0),
      inner_(std::max(partial.mesh(kSource).vertex_count(), partial.mesh(kTarget).vertex_count()), 0) {}

/// Note which faces are labelled, and which of their vertices have no other than those and M around them.
void Slits::mark(const std::vector<Pair>& labels) {
  side_ = partial_.level_side();
  const Mesh& mesh = partial_.mesh(side_);
  ++stamp_;
  disc_.clear();
  for (const Pair& pair : labels) {
    disc_.push_back(mesh.face(half(pair, side_)));
    labelled_[disc_.back()] = stamp_;
  }
  const auto in_disc = [&](FaceId face) {
    return labelled_[face] == stamp_ || partial_.standing(side_, face) == Standing::In;
  };
  for (const FaceId face : disc_) {
    for (const HalfedgeId h : mesh.halfedges(face)) {
      const VertexId v = mesh.origin(h);
      const auto around = faces_at_.of(side_, v);
      inner_[v] = !mesh.is_boundary(mesh.fan(h)) && std::all_of(around.begin(), around.end(), in_disc) ? 1 : 0;
    }
  }
}

bool Slits::is_within(FaceId face, std::uint32_t level) const {
  if (labelled_[face] != stamp_ || !partial_.is_open(side_, face)) return false;
  if (level == 0) return true;
  const std::uint32_t last = partial_.level(side_, face);
  return last != Partial::kNoLevel && last >= level;
}

/// May a slit end in this face, or go on where it is not counted?
bool Slits::is_at_end(FaceId face, std::uint32_t level) const {
  for (const HalfedgeId h : partial_.mesh(side_).halfedges(face)) {
    const VertexId v = partial_.mesh(side_).origin(h);
    if (inner_[v] == 0) return true;
    for (const FaceId beside : faces_at_.of(side_, v)) {
      if (partial_.is_open(side_, beside) && !is_within(beside, level)) return true;
    }
  }
  return false;
}

/// The faces within a level from which a slit of fewer than `depth` faces reaches an end.
void Slits::find_shallow(std::uint32_t level, std::uint32_t depth) {
  ++shallow_;
  queue_.clear();
  if (depth <= 1) return;
  for (const FaceId face : disc_) {
    if (!is_within(face, level) || !is_at_end(face, level)) continue;
    shallow_stamp_[face] = shallow_;
    queue_.push_back(face);
  }
  std::size_t next = 0;
  for (std::uint32_t reached = 2; reached < depth; ++reached) {
    for (const std::size_t end = queue_.size(); next < end; ++next) {
      for (const HalfedgeId h : partial_.mesh(side_).halfedges(queue_[next])) {
        for (const FaceId beside : faces_at_.of(side_, partial_.mesh(side_).origin(h))) {
          if (shallow_stamp_[beside] == shallow_ || !is_within(beside, level)) continue;
          shallow_stamp_[beside] = shallow_;
          queue_.push_back(beside);
        }
      }
    }
  }
}

/// A slit through a face d faces away from the next end has 2 d - 1 faces or more.
bool Slits::take_in_level(std::uint32_t level, std::uint32_t spare, Rim& rim) {
  find_shallow(level, (spare + 3) / 2);
  const std::uint32_t before = partial_.size();
  for (std::size_t k = 0; k < rim.size(); ++k) {
    const Pair pair = beyond(partial_, rim[k]);
    const HalfedgeId here = half(pair, side_);
    if (!here.valid()) continue;
    const FaceId face = partial_.mesh(side_).face(here);
    if (!is_within(face, level) || shallow_stamp_[face] == shallow_) continue;
    if (!half(pair, other(side_)).valid() || !partial_.fits(pair)) continue;
    partial_.commit(pair);
    extend(rim, partial_, pair);
  }
  return partial_.size() > before;
}

bool Slits::take_in(const std::vector<Pair>& labels, Rim& rim, std::uint32_t spare) {
  mark(labels);
  const std::vector<Level>& levels = partial_.levels();
  std::uint32_t out = 0;
  bool taken = false;
  for (auto level = static_cast<std::uint32_t>(levels.size()); level-- > 1;) {
    out += levels[level].out;
    if (out <= levels[level].budget) taken = take_in_level(level, levels[level].budget - out, rim) || taken;
  }
  return take_in_level(0, spare, rim) || taken;
}

}  // namespace quadmatch::exact
