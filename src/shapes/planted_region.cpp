#include "planted_region.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace quadmatch::shapes {
namespace {

VertexId vertex_at(const Mesh& mesh, FaceId face, std::uint32_t corner) {
  return mesh.origin(HalfedgeId(mesh.first(face).value + corner));
}

/// The image of each corner of a pair of faces, in order.
std::vector<VertexPair> corners_of(const Mesh& source, const Mesh& target, const FacePair& pair) {
  const std::uint32_t size = source.size(pair.source);
  std::vector<VertexPair> corners;
  for (std::uint32_t k = 0; k < size; ++k) {
    const std::uint32_t image = image_corner(Orientation::Preserving, pair.rotation, k, size);
    corners.push_back({vertex_at(source, pair.source, k), vertex_at(target, pair.target, image)});
  }
  return corners;
}

/// Pairs by their source face; not valid where there is none.
std::vector<FacePair> by_source(const Mesh& source, const std::vector<FacePair>& pairs) {
  std::vector<FacePair> table(source.face_count());
  for (const FacePair& pair : pairs) table[pair.source.value] = pair;
  return table;
}

/// Are two true pairs, whose source faces are adjacent across `h`, adjacent in the target as well, there?
bool adjacent_in_target(const Mesh& source, const Mesh& target, const FacePair& pair, const FacePair& other,
                        HalfedgeId h) {
  const std::uint32_t size = source.size(pair.source);
  const std::uint32_t corner = image_corner(Orientation::Preserving, pair.rotation, source.corner(h), size);
  const HalfedgeId twin = target.twin(HalfedgeId(target.first(pair.target).value + corner));
  return twin.valid() && target.face(twin) == other.target;
}

class SoundPart {
 public:
  SoundPart(const Mesh& source, const Mesh& target, const std::vector<FacePair>& truth)
      : source_(source), target_(target), truth_(by_source(source, truth)), inside_(source.face_count(), false) {
    std::vector<bool> free = without_conflict(truth);
    std::vector<FaceId> largest;
    for (std::uint32_t f = 0; f < free.size(); ++f) {
      std::vector<FaceId> part = take_component(FaceId(f), free);
      if (part.size() > largest.size()) largest = std::move(part);
    }
    for (const FaceId face : largest) add(face);
    grow();
  }

  [[nodiscard]] std::vector<FacePair> take() const {
    std::vector<FacePair> pairs;
    for (std::uint32_t f = 0; f < inside_.size(); ++f) {
      if (inside_[f]) pairs.push_back(truth_[f]);
    }
    return pairs;
  }

 private:
  /// True pairs none of whose corners is one with two images or two originals.
  [[nodiscard]] std::vector<bool> without_conflict(const std::vector<FacePair>& truth) const {
    std::map<VertexId, std::set<VertexId>> images, originals;
    for (const FacePair& pair : truth) {
      for (const auto& [from, to] : corners_of(source_, target_, pair)) {
        images[from].insert(to);
        originals[to].insert(from);
      }
    }
    std::vector<bool> free(source_.face_count(), false);
    for (const FacePair& pair : truth) {
      const std::vector<VertexPair> corners = corners_of(source_, target_, pair);
      free[pair.source.value] = std::all_of(corners.begin(), corners.end(), [&](const VertexPair& corner) {
        return images[corner.source].size() == 1 && originals[corner.target].size() == 1;
      });
    }
    return free;
  }
  /// The free faces that hang together with one, in both meshes; they are no longer free.
  std::vector<FaceId> take_component(FaceId start, std::vector<bool>& free) const {
    std::vector<FaceId> part;
    if (!free[start.value]) return part;
    free[start.value] = false;
    part.push_back(start);
    for (std::size_t k = 0; k < part.size(); ++k) {
      for (const HalfedgeId h : source_.halfedges(part[k])) {
        if (!source_.twin(h).valid()) continue;
        const FaceId beyond = source_.face(source_.twin(h));
        if (!free[beyond.value]) continue;
        if (!adjacent_in_target(source_, target_, truth_[part[k].value], truth_[beyond.value], h)) continue;
        free[beyond.value] = false;
        part.push_back(beyond);
      }
    }
    return part;
  }
  void add(FaceId face) {
    inside_[face.value] = true;
    for (const auto& [from, to] : corners_of(source_, target_, truth_[face.value])) {
      image_[from] = to;
      original_[to] = from;
    }
  }
  [[nodiscard]] bool fits(FaceId face) const {
    const FacePair& pair = truth_[face.value];
    if (!pair.source.valid() || inside_[face.value]) return false;
    for (const auto& [from, to] : corners_of(source_, target_, pair)) {
      const auto image = image_.find(from);
      const auto original = original_.find(to);
      if (image != image_.end() && image->second != to) return false;
      if (original != original_.end() && original->second != from) return false;
    }
    for (const HalfedgeId h : source_.halfedges(face)) {
      if (!source_.twin(h).valid()) continue;
      const FaceId beyond = source_.face(source_.twin(h));
      if (inside_[beyond.value] && adjacent_in_target(source_, target_, pair, truth_[beyond.value], h)) return true;
    }
    return false;
  }
  void grow() {
    for (bool grown = true; grown;) {
      grown = false;
      for (std::uint32_t f = 0; f < inside_.size(); ++f) {
        if (!fits(FaceId(f))) continue;
        add(FaceId(f));
        grown = true;
      }
    }
  }

  const Mesh& source_;
  const Mesh& target_;
  std::vector<FacePair> truth_;
  std::vector<bool> inside_;
  std::map<VertexId, VertexId> image_, original_;
};

/// The edges of the region's rim, of faces in the region, in groups that share vertices.
class RimGroups {
 public:
  RimGroups(const Mesh& mesh, const std::vector<HalfedgeId>& rim) {
    std::map<VertexId, std::vector<std::size_t>> at;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      at[mesh.origin(rim[k])].push_back(k);
      at[mesh.tip(rim[k])].push_back(k);
    }
    std::vector<bool> seen(rim.size(), false);
    for (std::size_t first = 0; first < rim.size(); ++first) {
      if (seen[first]) continue;
      seen[first] = true;
      std::vector<std::size_t> group = {first};
      for (std::size_t k = 0; k < group.size(); ++k) {
        for (const VertexId v : {mesh.origin(rim[group[k]]), mesh.tip(rim[group[k]])}) {
          for (const std::size_t other : at[v]) {
            if (!seen[other]) group.push_back(other);
            seen[other] = true;
          }
        }
      }
      std::vector<HalfedgeId>& edges = groups.emplace_back();
      for (const std::size_t k : group) edges.push_back(rim[k]);
    }
  }

  std::vector<std::vector<HalfedgeId>> groups;
};

}  // namespace

std::vector<FacePair> sound_part(const Mesh& source, const Mesh& target, const std::vector<FacePair>& truth) {
  return SoundPart(source, target, truth).take();
}

std::vector<std::uint32_t> steps_from(const Mesh& mesh, const std::vector<FaceId>& starts,
                                      const std::vector<bool>& allowed) {
  std::vector<std::vector<FaceId>> around(mesh.vertex_count());
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (!allowed[f]) continue;
    for (const HalfedgeId h : mesh.halfedges(FaceId(f))) around[mesh.origin(h).value].push_back(FaceId(f));
  }
  std::vector<std::uint32_t> steps(mesh.face_count(), mesh.face_count() + 1);
  std::vector<FaceId> reached = starts;
  for (const FaceId face : starts) steps[face.value] = 0;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    for (const HalfedgeId h : mesh.halfedges(reached[k])) {
      for (const FaceId beyond : around[mesh.origin(h).value]) {
        if (steps[beyond.value] <= mesh.face_count()) continue;
        steps[beyond.value] = steps[reached[k].value] + 1;
        reached.push_back(beyond);
      }
    }
  }
  return steps;
}

Rims measure_rims(const Mesh& source, const Mesh& target, const std::vector<FacePair>& region) {
  const std::vector<FacePair> pairs = by_source(source, region);
  std::vector<bool> inside(source.face_count(), false);
  for (const FacePair& pair : region) inside[pair.source.value] = true;
  std::vector<HalfedgeId> rim, end;
  for (const FacePair& pair : region) {
    for (const HalfedgeId h : source.halfedges(pair.source)) {
      const HalfedgeId twin = source.twin(h);
      if (twin.valid() && inside[source.face(twin).value]) continue;
      const std::uint32_t corner =
          image_corner(Orientation::Preserving, pair.rotation, source.corner(h), source.size(pair.source));
      const bool ends_there = !target.twin(HalfedgeId(target.first(pair.target).value + corner)).valid();
      (!twin.valid() && ends_there ? end : rim).push_back(h);
    }
  }

  Rims rims;
  RimGroups mismatches(source, rim);
  for (const std::vector<HalfedgeId>& group : mismatches.groups) {
    rims.longest = std::max(rims.longest, static_cast<std::uint32_t>(group.size()));
  }
  std::vector<std::vector<HalfedgeId>> groups = std::move(mismatches.groups);
  for (std::vector<HalfedgeId>& group : RimGroups(source, end).groups) groups.push_back(std::move(group));
  rims.narrowest = source.face_count() + 2;
  std::vector<FaceId> all;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    std::vector<FaceId> starts;
    for (const HalfedgeId h : groups[k]) starts.push_back(source.face(h));
    all.insert(all.end(), starts.begin(), starts.end());
    const std::vector<std::uint32_t> steps = steps_from(source, starts, inside);
    for (std::size_t other = k + 1; other < groups.size(); ++other) {
      for (const HalfedgeId h : groups[other])
        rims.narrowest = std::min(rims.narrowest, steps[source.face(h).value] + 1);
    }
  }
  const std::vector<std::uint32_t> steps = steps_from(source, all, inside);
  for (const FacePair& pair : region) rims.depth.push_back(steps[pair.source.value]);
  return rims;
}

}  // namespace quadmatch::shapes
