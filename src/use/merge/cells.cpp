#include "cells.hpp"

#include <quadmatch/mesh/disjoint_sets.hpp>
#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch::use {
namespace {

using Corners = PerHalfedge<HalfedgeId>;

/// For each corner of a side that of the base it lies on.
Corners laid_on_base(const Mesh& base, const Mesh& side, const Match& match) {
  Corners base_of(side.halfedge_count());
  for (const Region& region : match.regions) {
    if (region.orientation != Orientation::Preserving) continue;
    for (const FacePair& pair : region.faces) {
      const std::uint32_t size = base.size(pair.source);
      for (std::uint32_t i = 0; i < size; ++i) {
        const std::uint32_t image = image_corner(region.orientation, pair.rotation, i, size);
        base_of[HalfedgeId(side.first(pair.target).value + image)] = HalfedgeId(base.first(pair.source).value + i);
      }
    }
  }
  return base_of;
}

Corners turned_round(const Corners& images, std::size_t count) {
  Corners origins(count);
  for (std::uint32_t h = 0; h < images.size(); ++h) {
    if (images[HalfedgeId(h)].valid()) origins[images[HalfedgeId(h)]] = HalfedgeId(h);
  }
  return origins;
}

/// The corners of THEIRS that lie on those of OURS: through the base, and then, from face to face, where both are new.
class BothSides {
 public:
  BothSides(const Mesh& ours, const Mesh& theirs, const Corners& base_of_ours, const Corners& base_of_theirs,
            const Corners& theirs_of_base)
      : ours_(ours),
        theirs_(theirs),
        base_of_ours_(base_of_ours),
        base_of_theirs_(base_of_theirs),
        theirs_of_(ours.halfedge_count()),
        taken_(theirs.halfedge_count(), 0) {
    for (std::uint32_t h = 0; h < ours.halfedge_count(); ++h) {
      const HalfedgeId in_base = base_of_ours[HalfedgeId(h)];
      if (in_base.valid()) theirs_of_[HalfedgeId(h)] = theirs_of_base[in_base];
    }
  }

  Corners run() {
    for (std::uint32_t h = 0; h < theirs_of_.size(); ++h) {
      if (base_of_ours_[HalfedgeId(h)].valid() && theirs_of_[HalfedgeId(h)].valid()) step_across(HalfedgeId(h));
    }
    for (std::size_t k = 0; k < reached_.size(); ++k) step_across(reached_[k]);
    give_up_parts();
    return std::move(theirs_of_);
  }

 private:
  [[nodiscard]] bool is_new(HalfedgeId in_ours, HalfedgeId in_theirs) const {
    return in_ours.valid() && in_theirs.valid() && !base_of_ours_[in_ours].valid() &&
           !base_of_theirs_[in_theirs].valid() && !theirs_of_[in_ours].valid() && taken_[in_theirs] == 0;
  }

  /// From a corner that both have to the face beyond the edge behind it.
  void step_across(HalfedgeId corner) {
    HalfedgeId here = ours_.twin(corner), there = theirs_.twin(theirs_of_[corner]);
    if (!is_new(here, there) || ours_.size(ours_.face(here)) != theirs_.size(theirs_.face(there))) return;
    for (std::uint32_t k = ours_.size(ours_.face(here)); k > 0; --k) {
      theirs_of_[here] = there;
      taken_[there] = 1;
      reached_.push_back(here);
      here = ours_.next(here);
      there = theirs_.next(there);
    }
  }

  /// New faces that hang together are the same as a whole or not at all: walls and loops can begin alike.
  void give_up_parts() {
    if (reached_.empty()) return;
    DisjointSets sets(ours_.face_count() + theirs_.face_count());
    const auto name = [&](FaceId in_theirs) { return ours_.face_count() + in_theirs.value; };
    join_new(ours_, base_of_ours_, 0, sets);
    join_new(theirs_, base_of_theirs_, ours_.face_count(), sets);
    for (const HalfedgeId h : reached_) sets.join(ours_.face(h).value, name(theirs_.face(theirs_of_[h])));
    std::vector<std::uint8_t> in_part(ours_.face_count() + theirs_.face_count(), 0);
    for (std::uint32_t f = 0; f < ours_.face_count(); ++f) {
      const HalfedgeId h = ours_.first(FaceId(f));
      if (!base_of_ours_[h].valid() && !theirs_of_[h].valid()) in_part[sets.find(f)] = 1;
    }
    for (std::uint32_t f = 0; f < theirs_.face_count(); ++f) {
      const HalfedgeId h = theirs_.first(FaceId(f));
      if (!base_of_theirs_[h].valid() && taken_[h] == 0) in_part[sets.find(name(FaceId(f)))] = 1;
    }
    for (const HalfedgeId h : reached_) {
      if (in_part[sets.find(ours_.face(h).value)] != 0) theirs_of_[h] = HalfedgeId();
    }
  }

  static void join_new(const Mesh& mesh, const Corners& base_of, std::uint32_t first, DisjointSets& sets) {
    for (std::uint32_t k = 0; k < mesh.halfedge_count(); ++k) {
      const HalfedgeId h(k), beyond = mesh.twin(h);
      if (!beyond.valid() || base_of[h].valid() || base_of[beyond].valid()) continue;
      sets.join(first + mesh.face(h).value, first + mesh.face(beyond).value);
    }
  }

  const Mesh& ours_;
  const Mesh& theirs_;
  const Corners& base_of_ours_;
  const Corners& base_of_theirs_;
  Corners theirs_of_;
  PerHalfedge<std::uint8_t> taken_;
  std::vector<HalfedgeId> reached_;
};

/// Cells one after the other.
class Writer {
 public:
  explicit Writer(const ThreeMeshes& meshes) : meshes_(meshes) {}

  /// @param first  the first corner of the cell's face in each mesh; at least one is there.
  void add(const InThree<HalfedgeId>& first) {
    InThree<HalfedgeId> corner = first;
    InThree<FaceId> faces;
    std::uint32_t size = 0;
    for (const Side side : kSides) {
      if (!corner[side].valid()) continue;
      faces[side] = mesh_of(meshes_, side).face(corner[side]);
      size = mesh_of(meshes_, side).size(faces[side]);
    }
    cells_.faces.push_back(faces);
    cells_.first_corner.push_back(static_cast<std::uint32_t>(cells_.corners.size()));
    if (!faces[Side::Base].valid() && faces[Side::Ours].valid() && faces[Side::Theirs].valid()) ++cells_.same_added;
    for (std::uint32_t k = 0; k < size; ++k) {
      cells_.corners.push_back(corner);
      for (const Side side : kSides) {
        if (corner[side].valid()) corner[side] = mesh_of(meshes_, side).next(corner[side]);
      }
    }
  }

  Cells finish() {
    cells_.first_corner.push_back(static_cast<std::uint32_t>(cells_.corners.size()));
    return std::move(cells_);
  }

 private:
  const ThreeMeshes& meshes_;
  Cells cells_;
};

}  // namespace

Cells lay_cells(const ThreeMeshes& meshes, const Match& to_ours, const Match& to_theirs) {
  const Mesh &base = *meshes[0], &ours = *meshes[1], &theirs = *meshes[2];
  const Corners base_of_ours = laid_on_base(base, ours, to_ours);
  const Corners base_of_theirs = laid_on_base(base, theirs, to_theirs);
  const Corners theirs_of_base = turned_round(base_of_theirs, base.halfedge_count());
  const Corners theirs_of_ours = BothSides(ours, theirs, base_of_ours, base_of_theirs, theirs_of_base).run();
  const Corners ours_of_theirs = turned_round(theirs_of_ours, theirs.halfedge_count());
  const Corners ours_of_base = turned_round(base_of_ours, base.halfedge_count());

  Writer cells(meshes);
  for (std::uint32_t f = 0; f < ours.face_count(); ++f) {
    const HalfedgeId h = ours.first(FaceId(f));
    cells.add({base_of_ours[h], h, theirs_of_ours[h]});
  }
  for (std::uint32_t f = 0; f < theirs.face_count(); ++f) {
    const HalfedgeId h = theirs.first(FaceId(f));
    if (!ours_of_theirs[h].valid()) cells.add({base_of_theirs[h], HalfedgeId(), h});
  }
  for (std::uint32_t f = 0; f < base.face_count(); ++f) {
    const HalfedgeId h = base.first(FaceId(f));
    if (!ours_of_base[h].valid() && !theirs_of_base[h].valid()) cells.add({h, HalfedgeId(), HalfedgeId()});
  }
  return cells.finish();
}

}  // namespace quadmatch::use
