#include "partial.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

namespace quadmatch::exact {
namespace {

/// The faces that pass a vertex more than once: only dirty files have such.
PerFace<std::uint8_t> faces_that_repeat(const Mesh& mesh) {
  PerFace<std::uint8_t> repeats(mesh.face_count(), 0);
  std::vector<VertexId> corners;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    corners.clear();
    for (const HalfedgeId h : mesh.halfedges(FaceId(f))) corners.push_back(mesh.origin(h));
    std::sort(corners.begin(), corners.end());
    repeats[FaceId(f)] = std::adjacent_find(corners.begin(), corners.end()) != corners.end() ? 1 : 0;
  }
  return repeats;
}

}  // namespace

Partial::Partial(const Mesh& source, const Mesh& target) : meshes_{&source, &target}, open_{} {
  for (const Side side : {kSource, kTarget}) {
    const Mesh& mesh = *meshes_[side];
    standing_[side] = PerFace<Standing>(mesh.face_count(), Standing::Open);
    image_of_first_[side] = PerFace<HalfedgeId>(mesh.face_count());
    partner_[side] = PerVertex<VertexId>(mesh.vertex_count());
    repeats_[side] = faces_that_repeat(mesh);
    open_[side] = mesh.face_count();
  }
  level_of_ = PerFace<std::uint32_t>(source.face_count(), kNoLevel);
}

HalfedgeId Partial::image(Side side, HalfedgeId h) const {
  const Mesh& mesh = *meshes_[side];
  return turned(other(side), image_of_first_[side][mesh.face(h)], mesh.corner(h));
}

bool Partial::fits(const Pair& pair) const {
  const FaceId f = meshes_[kSource]->face(pair.source), g = meshes_[kTarget]->face(pair.target);
  return is_open(kSource, f) && is_open(kTarget, g) && agrees(pair);
}

bool Partial::agrees(const Pair& pair) const {
  const FaceId f = meshes_[kSource]->face(pair.source), g = meshes_[kTarget]->face(pair.target);
  const std::uint32_t size = meshes_[kSource]->size(f);
  if (size != meshes_[kTarget]->size(g) || !corners_agree(pair, size) || !neighbours_agree(pair, size)) return false;
  return (repeats_[kSource][f] == 0 && repeats_[kTarget][g] == 0) || repeat_alike(pair, size);
}

/// Condition 2 of DESIGN: the vertex map stays a function and one-to-one.
bool Partial::corners_agree(const Pair& pair, std::uint32_t size) const {
  auto [s, t] = pair;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const VertexId w = meshes_[kTarget]->origin(t);
    const VertexId image = partner_[kSource][meshes_[kSource]->origin(s)];
    if (image.valid() ? image != w : partner_[kTarget][w].valid()) return false;
    s = meshes_[kSource]->next(s);
    t = meshes_[kTarget]->next(t);
  }
  return true;
}

/// Condition 3: adjacent to what is in across corresponding edges, and across no others.
bool Partial::neighbours_agree(const Pair& pair, std::uint32_t size) const {
  auto [s, t] = pair;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const HalfedgeId b = meshes_[kSource]->twin(s), c = meshes_[kTarget]->twin(t);
    if (b.valid() && standing_[kSource][meshes_[kSource]->face(b)] == Standing::In) {
      if (image(kSource, b) != c) return false;
    } else if (c.valid() && standing_[kTarget][meshes_[kTarget]->face(c)] == Standing::In) {
      return false;
    }
    s = meshes_[kSource]->next(s);
    t = meshes_[kTarget]->next(t);
  }
  return true;
}

/// A face that passes a vertex twice lies only on one that does so at the same corners.
bool Partial::repeat_alike(const Pair& pair, std::uint32_t size) const {
  for (std::uint32_t i = 1; i < size; ++i) {
    for (std::uint32_t k = 0; k < i; ++k) {
      const auto at = [&](Side side, std::uint32_t corner) {
        return meshes_[side]->origin(turned(side, half(pair, side), corner));
      };
      if ((at(kSource, i) == at(kSource, k)) != (at(kTarget, i) == at(kTarget, k))) return false;
    }
  }
  return true;
}

void Partial::decide(Side side, FaceId face, Standing standing) {
  assert(is_open(side, face));
  standing_[side][face] = standing;
  --open_[side];
  if (const std::uint32_t number = level(side, face); number != kNoLevel) {
    --levels_[number].open;
    levels_[number].out += standing == Standing::Out ? 1 : 0;
  }
}

void Partial::reopen(Side side, FaceId face) {
  if (const std::uint32_t number = level(side, face); number != kNoLevel) {
    ++levels_[number].open;
    levels_[number].out -= standing_[side][face] == Standing::Out ? 1 : 0;
  }
  standing_[side][face] = Standing::Open;
  ++open_[side];
}

void Partial::commit(const Pair& pair) {
  assert(fits(pair));
  const FaceId f = meshes_[kSource]->face(pair.source), g = meshes_[kTarget]->face(pair.target);
  auto [s, t] = pair;
  for (std::uint32_t corner = meshes_[kSource]->size(f); corner > 0; --corner) {
    const VertexId v = meshes_[kSource]->origin(s), w = meshes_[kTarget]->origin(t);
    if (!partner_[kSource][v].valid()) {
      partner_[kSource][v] = w;
      partner_[kTarget][w] = v;
      trail_.push_back({Step::Vertex, v.value});
    }
    if (s == meshes_[kSource]->first(f)) image_of_first_[kSource][f] = t;
    if (t == meshes_[kTarget]->first(g)) image_of_first_[kTarget][g] = s;
    s = meshes_[kSource]->next(s);
    t = meshes_[kTarget]->next(t);
  }
  decide(kSource, f, Standing::In);
  decide(kTarget, g, Standing::In);
  pairs_.push_back(pair);
  trail_.push_back({Step::Committed, f.value});
}

void Partial::exclude(Side side, FaceId face) {
  decide(side, face, Standing::Out);
  trail_.push_back({side == kSource ? Step::OutOfSource : Step::OutOfTarget, face.value});
}

void Partial::undo(Mark mark) {
  for (; trail_.size() > mark; trail_.pop_back()) {
    const auto [step, id] = trail_.back();
    switch (step) {
      case Step::Committed:
        reopen(kSource, FaceId(id));
        reopen(kTarget, meshes_[kTarget]->face(image_of_first_[kSource][FaceId(id)]));
        pairs_.pop_back();
        break;
      case Step::Vertex:
        partner_[kTarget][partner_[kSource][VertexId(id)]] = VertexId();
        partner_[kSource][VertexId(id)] = VertexId();
        break;
      case Step::OutOfSource:
        reopen(kSource, FaceId(id));
        break;
      case Step::OutOfTarget:
        reopen(kTarget, FaceId(id));
        break;
    }
  }
}

void Partial::begin_levels(Side side, std::vector<FaceId> faces, std::uint32_t budget) {
  assert(trail_.empty());
  level_side_ = side;
  level_of_ = PerFace<std::uint32_t>(mesh(side).face_count(), kNoLevel);
  levels_.clear();
  for (const FaceId face : faces) level_of_[face] = 0;
  const auto open = static_cast<std::uint32_t>(faces.size());
  levels_.push_back({.budget = budget, .open = open, .faces = std::move(faces)});
}

void Partial::push_level(std::vector<FaceId> faces, std::uint32_t budget) {
  assert(trail_.empty());
  const auto number = static_cast<std::uint32_t>(levels_.size());
  for (const FaceId face : faces) level_of_[face] = number;
  const auto open = static_cast<std::uint32_t>(faces.size());
  levels_.back().open -= open;
  levels_.push_back({.budget = budget, .open = open, .faces = std::move(faces)});
}

void Partial::pop_level() {
  assert(trail_.empty());
  const auto outer = static_cast<std::uint32_t>(levels_.size() - 2);
  for (const FaceId face : levels_.back().faces) level_of_[face] = outer;
  levels_[outer].open += static_cast<std::uint32_t>(levels_.back().faces.size());
  levels_.pop_back();
}

void extend(Rim& rim, const Partial& partial, const Pair& pair) {
  const Mesh& source = partial.mesh(kSource);
  const Mesh& target = partial.mesh(kTarget);
  auto [s, t] = pair;
  do {
    rim.push_back({s, t});
    s = source.next(s);
    t = target.next(t);
  } while (s != pair.source);
}

}  // namespace quadmatch::exact
