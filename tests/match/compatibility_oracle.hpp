#pragma once
/// The compatibility graph of §4.5.2 built from nothing at every step, straight from its definition: slow, plain, and
/// sharing no code with the one that is updated in place.

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>

namespace quadmatch::test {

/// mu and its vertex map, in maps.
class PlainMatch {
 public:
  PlainMatch(const Mesh& source, const Mesh& target) : source_(source), target_(target) {}

  void accept(const FacePair& pair) {
    const std::uint32_t size = source_.size(pair.source);
    for (std::uint32_t corner = 0; corner < size; ++corner) {
      const HalfedgeId s(source_.first(pair.source).value + corner);
      const HalfedgeId t(target_.first(pair.target).value + (pair.rotation + corner) % size);
      image_[s] = t;
      vertex_image_[source_.origin(s)] = target_.origin(t);
      vertex_origin_[target_.origin(t)] = source_.origin(s);
    }
    taken_.insert(pair.target);
  }

  [[nodiscard]] bool is_matched(FaceId f) const { return image_.contains(source_.first(f)); }
  [[nodiscard]] bool is_taken(FaceId f) const { return taken_.contains(f); }
  [[nodiscard]] const std::map<HalfedgeId, HalfedgeId>& image() const { return image_; }

  /// §3 for one more pair, laid half-edge on half-edge.
  [[nodiscard]] bool fits(HalfedgeId s, HalfedgeId t) const {
    const FaceId q = source_.face(s);
    const FaceId r = target_.face(t);
    if (is_matched(q) || is_taken(r) || source_.size(q) != target_.size(r)) return false;
    for (std::uint32_t corner = 0; corner < source_.size(q); ++corner, s = source_.next(s), t = target_.next(t)) {
      const auto image = vertex_image_.find(source_.origin(s));
      const auto origin = vertex_origin_.find(target_.origin(t));
      if (image != vertex_image_.end() && image->second != target_.origin(t)) return false;
      if (origin != vertex_origin_.end() && origin->second != source_.origin(s)) return false;
      const HalfedgeId beyond = source_.twin(s);
      const HalfedgeId beyond_target = target_.twin(t);
      const bool matched = beyond.valid() && is_matched(source_.face(beyond));
      const bool taken = beyond_target.valid() && is_taken(target_.face(beyond_target));
      if (matched != taken || (matched && image_.at(beyond) != beyond_target)) return false;
    }
    return true;
  }

 private:
  const Mesh& source_;
  const Mesh& target_;
  std::map<HalfedgeId, HalfedgeId> image_;
  std::map<VertexId, VertexId> vertex_image_, vertex_origin_;
  std::set<FaceId> taken_;
};

using PlainCandidate = std::pair<HalfedgeId, HalfedgeId>;

struct PlainComponent {
  std::vector<PlainCandidate> across_edges;     ///< the vertices of L
  std::vector<PlainCandidate> across_vertices;  ///< the candidates in the middle of gaps
  std::int64_t faces = 0;                       ///< distinct faces; a gap of one face joins two candidates that are one
  std::uint32_t disagreeing = 0;
};

/// All components of L, and the largest number of neighbours that a candidate has in L.
struct PlainGraph {
  std::vector<PlainComponent> components;
  std::size_t most_neighbours = 0;
};

/// The faces about the origin of a half-edge, from its own on clockwise as seen from the face beyond, as long as they
/// are free; and the half-edge by which the next matched face is reached, if one is.
struct FreeFan {
  std::vector<HalfedgeId> sides;  ///< outgoing at the vertex, one per free face
  HalfedgeId end;                 ///< half-edge of the matched face that ends the fan
};

template <class IsFree>
FreeFan free_fan(const Mesh& mesh, HalfedgeId start, IsFree is_free) {
  FreeFan fan;
  for (HalfedgeId h = start; h.valid(); h = mesh.rotate_ccw(h)) {
    if (!is_free(mesh.face(h))) {
      fan.end = h;
      break;
    }
    fan.sides.push_back(h);
  }
  return fan;
}

inline PlainGraph compatibility_graph(const Mesh& source, const Mesh& target, const PlainMatch& match,
                                      const std::vector<std::uint32_t>& source_codes,
                                      const std::vector<std::uint32_t>& target_codes) {
  std::vector<PlainCandidate> candidates;
  for (const auto& [h, image] : match.image()) {
    const HalfedgeId s = source.twin(h);
    const HalfedgeId t = target.twin(image);
    if (s.valid() && t.valid() && match.fits(s, t)) candidates.emplace_back(s, t);
  }
  std::map<HalfedgeId, std::size_t> number_of;
  for (std::size_t n = 0; n < candidates.size(); ++n) number_of[candidates[n].first] = n;

  std::vector<std::size_t> label(candidates.size());
  std::iota(label.begin(), label.end(), 0U);
  std::vector<std::size_t> neighbours(candidates.size(), 0);
  struct Link {
    std::size_t from;
    FreeFan fan, target_fan;
  };
  std::vector<Link> links;
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    const FreeFan fan = free_fan(source, candidates[n].first, [&](FaceId f) { return !match.is_matched(f); });
    const FreeFan target_fan = free_fan(target, candidates[n].second, [&](FaceId f) { return !match.is_taken(f); });
    if (!fan.end.valid() || !target_fan.end.valid() || fan.sides.size() != target_fan.sides.size()) continue;
    if (match.image().at(fan.end) != target_fan.end) continue;
    const auto other = number_of.find(source.twin(fan.end));
    if (other == number_of.end()) continue;
    bool all_fit = true;
    for (std::size_t k = 1; k + 1 < fan.sides.size(); ++k) {
      all_fit = all_fit && match.fits(fan.sides[k], target_fan.sides[k]);
    }
    if (!all_fit) continue;
    ++neighbours[n];
    ++neighbours[other->second];
    links.push_back({n, fan, target_fan});
    const std::size_t old_label = label[other->second];
    for (std::size_t& l : label) l = l == old_label ? label[n] : l;
  }

  PlainGraph graph;
  for (const std::size_t count : neighbours) graph.most_neighbours = std::max(graph.most_neighbours, count);
  std::map<std::size_t, PlainComponent> by_label;
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    PlainComponent& component = by_label[label[n]];
    component.across_edges.push_back(candidates[n]);
    component.faces += 1;
    auto [s, t] = candidates[n];
    for (s = source.next(source.next(s)), t = target.next(target.next(t)); s != candidates[n].first;
         s = source.next(s), t = target.next(t)) {
      component.disagreeing += source_codes[source.origin(s).value] != target_codes[target.origin(t).value];
    }
  }
  for (const Link& link : links) {
    PlainComponent& component = by_label[label[link.from]];
    component.faces += static_cast<std::int64_t>(link.fan.sides.size()) - 2;
    for (std::size_t k = 1; k + 1 < link.fan.sides.size(); ++k) {
      component.across_vertices.emplace_back(link.fan.sides[k], link.target_fan.sides[k]);
    }
  }
  for (auto& [l, component] : by_label) graph.components.push_back(std::move(component));
  return graph;
}

}  // namespace quadmatch::test
