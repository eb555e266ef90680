#include "mirror_map.hpp"

namespace quadmatch::use {

MirrorMap::MirrorMap(const Mesh& mesh, const PerFan<VertexCode>& codes)
    : mesh_(mesh), codes_(codes), image_(mesh.halfedge_count()), vertex_(mesh.vertex_count()) {}

bool MirrorMap::join(VertexId v, VertexId w) {
  if (vertex_[v].valid() || vertex_[w].valid()) return vertex_[v] == w && vertex_[w] == v;
  vertex_[v] = w;
  vertex_[w] = v;
  joined_.push_back(v);
  return true;
}

/// Pair the corners, or none of them.
bool MirrorMap::join_corners(Germ germ, Fit fit) {
  joined_.clear();
  HalfedgeId here = germ.from, there = germ.to;
  for (std::uint32_t k = 0; k < mesh_.size(mesh_.face(germ.from)); ++k) {
    const bool alike = fit != Fit::Looks || codes_[mesh_.fan(here)] == codes_[mesh_.fan(mesh_.next(there))];
    const bool joined = join(mesh_.origin(here), mesh_.tip(there));
    if ((!alike || !joined) && fit != Fit::Free) {
      for (const VertexId v : joined_) {
        const VertexId w = vertex_[v];
        vertex_[v] = vertex_[w] = VertexId();
      }
      return false;
    }
    here = mesh_.next(here);
    there = mesh_.prev(there);
  }
  return true;
}

bool MirrorMap::lay(Germ germ, Fit fit) {
  const FaceId face = mesh_.face(germ.from), partner = mesh_.face(germ.to);
  if (mesh_.size(face) != mesh_.size(partner) || image_[germ.from].valid() || image_[germ.to].valid()) return false;
  if (!join_corners(germ, fit)) return false;
  HalfedgeId here = germ.from, there = germ.to;
  for (std::uint32_t k = 0; k < mesh_.size(face); ++k) {
    image_[here] = there;
    image_[there] = here;
    here = mesh_.next(here);
    there = mesh_.prev(there);
  }
  laid_.push_back(germ);
  faces_ += face == partner ? 1 : 2;
  return true;
}

void MirrorMap::grow(Fit fit, std::uint32_t most) {
  for (; looked_beyond_ < laid_.size() && faces_ < most; ++looked_beyond_) {
    // The sides of the partner are the images of these.
    for (const HalfedgeId h : mesh_.halfedges(mesh_.face(laid_[looked_beyond_].from))) {
      const HalfedgeId beside = mesh_.twin(h), opposite = mesh_.twin(image_[h]);
      if (beside.valid() != opposite.valid()) ++conflicts_;
      if (!beside.valid() || !opposite.valid() || image_[beside] == opposite) continue;
      if (!lay({beside, opposite}, fit)) ++conflicts_;
    }
  }
}

void MirrorMap::cover_rim() {
  const std::size_t inside = laid_.size();
  for (std::size_t k = 0; k < inside; ++k) {
    for (const HalfedgeId h : mesh_.halfedges(mesh_.face(laid_[k].from))) {
      const HalfedgeId beside = mesh_.twin(h), opposite = mesh_.twin(image_[h]);
      if (beside.valid() && opposite.valid()) lay({beside, opposite}, Fit::Vertices);
    }
  }
}

void MirrorMap::clear() {
  for (const Germ& germ : laid_) {
    for (const FaceId face : {mesh_.face(germ.from), mesh_.face(germ.to)}) {
      for (const HalfedgeId h : mesh_.halfedges(face)) {
        image_[h] = HalfedgeId();
        vertex_[mesh_.origin(h)] = VertexId();
      }
    }
  }
  laid_.clear();
  looked_beyond_ = 0;
  faces_ = conflicts_ = 0;
}

}  // namespace quadmatch::use
