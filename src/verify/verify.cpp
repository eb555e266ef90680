// The definition of a match, sentence by sentence: §3's condition on mu, and what makes a match carry vertex data.
// Plain loops over flat arrays and no search; nothing here knows how a match is found.

#include <quadmatch/verify/verify.hpp>

#include <algorithm>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <quadmatch/mesh/per_element.hpp>

namespace quadmatch {
namespace {

/// What was said of an element, and in which region: it holds only while that region is judged, so that nothing need
/// be cleared between regions.
template <class Value>
struct Stamped {
  std::uint32_t region = FaceId::kNone;
  Value value = {};
};

class Judge {
 public:
  Judge(const Mesh& source, const Mesh& target, std::size_t kept)
      : source_(source),
        target_(target),
        kept_(kept),
        face_image_(source.face_count()),
        face_origin_(target.face_count()),
        reached_(source.face_count(), 0),
        vertex_image_(source.vertex_count()),
        vertex_origin_(target.vertex_count()),
        first_image_(source.vertex_count()),
        first_origin_(target.vertex_count()),
        disputed_target_(target.vertex_count(), 0),
        listed_image_(source.vertex_count()),
        listed_origin_(target.vertex_count()) {}

  Verdict judge(const Match& match) &&;

 private:
  void judge_region(const Region& region);
  bool names_a_pair(const FacePair& pair);
  void map_corners(const FacePair& pair);
  void judge_adjacency(const FacePair& pair);
  void judge_side(const FacePair& pair, std::uint32_t corner);
  void judge_connectedness();
  void remember_vertices();
  void judge_listed(std::span<const VertexPair> vertices);
  void judge_missing();

  [[nodiscard]] bool is_image(FaceId face) const { return face_image_[face].region == region_; }
  [[nodiscard]] bool is_target(FaceId face) const { return face_origin_[face].region == region_; }
  /// The half-edge of the target face on which side `corner` of the source face lies. A side leaves its corner; turned
  /// over, it arrives there.
  [[nodiscard]] HalfedgeId side_image(const FacePair& pair, std::uint32_t corner) const {
    const std::uint32_t size = source_.size(pair.source);
    const std::uint32_t start = orientation_ == Orientation::Preserving ? corner : (corner + 1) % size;
    return HalfedgeId(target_.first(pair.target).value + image_corner(orientation_, pair.rotation, start, size));
  }

  template <class... Values>
  void fault(FaultKind kind, fmt::format_string<Values...> text, Values&&... values) {
    if (verdict_.fault_count++ >= kept_) return;
    verdict_.faults.push_back({kind, fmt::format(text, std::forward<Values>(values)...)});
  }

  const Mesh& source_;
  const Mesh& target_;
  const std::size_t kept_;
  Verdict verdict_;

  // The region being judged.
  std::uint32_t region_ = 0;
  Orientation orientation_ = Orientation::Preserving;
  std::vector<FacePair> pairs_;                 // one for each source face
  PerFace<Stamped<std::uint32_t>> face_image_;  // index into pairs_
  PerFace<Stamped<FaceId>> face_origin_;
  PerFace<std::uint8_t> reached_;
  std::vector<VertexId> region_vertices_;
  PerVertex<Stamped<VertexId>> vertex_image_;
  PerVertex<Stamped<VertexId>> vertex_origin_;

  // The vertex maps of all regions: the first image of each vertex, and those that disagree with it.
  PerVertex<VertexId> first_image_;
  PerVertex<VertexId> first_origin_;
  PerVertex<std::uint8_t> disputed_target_;
  std::vector<VertexPair> further_images_;

  // The list of vertices.
  PerVertex<VertexId> listed_image_;
  PerVertex<VertexId> listed_origin_;
};

Verdict Judge::judge(const Match& match) && {
  for (region_ = 0; region_ < match.regions.size(); ++region_) judge_region(match.regions[region_]);
  judge_listed(match.vertices);
  judge_missing();
  return std::move(verdict_);
}

void Judge::judge_region(const Region& region) {
  orientation_ = region.orientation;
  pairs_.clear();
  region_vertices_.clear();
  for (const FacePair& pair : region.faces) {
    if (names_a_pair(pair)) map_corners(pair);
  }
  remember_vertices();
  for (const FacePair& pair : pairs_) judge_adjacency(pair);
  judge_connectedness();
  verdict_.matched_faces += pairs_.size();
  verdict_.largest_region = std::max(verdict_.largest_region, pairs_.size());
}

/// Sentences 1 and 5.
bool Judge::names_a_pair(const FacePair& pair) {
  const auto [source, target, rotation] = pair;
  if (source.value >= source_.face_count() || target.value >= target_.face_count()) {
    fault(FaultKind::NoSuchElement, "region {}, pair {} -> {}: there is no such face", region_, source.value,
          target.value);
    return false;
  }
  if (source_.size(source) != target_.size(target) || rotation >= source_.size(source)) {
    fault(FaultKind::CornersDoNotFit, "region {}, pair {} -> {}: {} and {} corners do not fit by rotation {}", region_,
          source.value, target.value, source_.size(source), target_.size(target), rotation);
    return false;
  }
  const bool source_twice = face_image_[source].region != FaceId::kNone;
  if (source_twice || face_origin_[target].region != FaceId::kNone) {
    fault(FaultKind::FaceTwice, "region {}, pair {} -> {}: the {} face is matched twice", region_, source.value,
          target.value, source_twice ? "source" : "target");
  }
  return true;
}

/// Sentence 2. Where a face or vertex is given two images, the later face and the earlier vertex are gone on with.
void Judge::map_corners(const FacePair& pair) {
  if (is_image(pair.source)) {
    pairs_[face_image_[pair.source].value] = pair;
  } else {
    face_image_[pair.source] = {region_, static_cast<std::uint32_t>(pairs_.size())};
    pairs_.push_back(pair);
  }
  face_origin_[pair.target] = {region_, pair.source};

  const std::uint32_t size = source_.size(pair.source);
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const std::uint32_t opposite = image_corner(orientation_, pair.rotation, corner, size);
    const VertexId vertex = source_.origin(HalfedgeId(source_.first(pair.source).value + corner));
    const VertexId other = target_.origin(HalfedgeId(target_.first(pair.target).value + opposite));
    Stamped<VertexId>& image = vertex_image_[vertex];
    Stamped<VertexId>& origin = vertex_origin_[other];
    if (image.region != region_) {
      image = {region_, other};
      region_vertices_.push_back(vertex);
    } else if (image.value != other) {
      fault(FaultKind::VertexNotAFunction, "region {}, pair {} -> {}: source vertex {} has two images, {} and {}",
            region_, pair.source.value, pair.target.value, vertex.value, image.value.value, other.value);
    }
    if (origin.region != region_) {
      origin = {region_, vertex};
    } else if (origin.value != vertex) {
      fault(FaultKind::VertexNotOneToOne, "region {}, pair {} -> {}: target vertex {} is hit twice, by {} and {}",
            region_, pair.source.value, pair.target.value, other.value, origin.value.value, vertex.value);
    }
  }
}

/// Sentence 3, at one face.
void Judge::judge_adjacency(const FacePair& pair) {
  for (std::uint32_t corner = 0; corner < source_.size(pair.source); ++corner) judge_side(pair, corner);
}

void Judge::judge_side(const FacePair& pair, std::uint32_t corner) {
  const HalfedgeId beside = source_.twin(HalfedgeId(source_.first(pair.source).value + corner));
  const HalfedgeId beside_target = target_.twin(side_image(pair, corner));
  const bool matched = beside.valid() && is_image(source_.face(beside));
  if (matched && beside_target.valid() &&
      pairs_[face_image_[source_.face(beside)].value].target == target_.face(beside_target)) {
    return;
  }
  const bool matched_target = beside_target.valid() && is_target(target_.face(beside_target));
  if (matched != matched_target) {
    fault(FaultKind::AdjacencyLost, "region {}, pair {} -> {}: adjacent to a matched face in the {} only, at side {}",
          region_, pair.source.value, pair.target.value, matched ? "source" : "target", corner);
  } else if (matched) {
    fault(FaultKind::AdjacencyLost, "region {}, pair {} -> {}: the faces beside it at side {}, {} and {}, are no pair",
          region_, pair.source.value, pair.target.value, corner, source_.face(beside).value,
          target_.face(beside_target).value);
  }
}

/// Sentence 4: every face can be reached from the first one.
void Judge::judge_connectedness() {
  if (pairs_.empty()) {
    fault(FaultKind::EmptyRegion, "region {} has no face", region_);
    return;
  }
  std::vector<FaceId> to_visit{pairs_.front().source};
  std::size_t reached = 1;
  reached_[pairs_.front().source] = 1;
  while (!to_visit.empty()) {
    const FaceId face = to_visit.back();
    to_visit.pop_back();
    for (const HalfedgeId h : source_.halfedges(face)) {
      const HalfedgeId other = source_.twin(h);
      if (!other.valid() || !is_image(source_.face(other)) || reached_[source_.face(other)] != 0) continue;
      reached_[source_.face(other)] = 1;
      to_visit.push_back(source_.face(other));
      ++reached;
    }
  }
  for (const FacePair& pair : pairs_) reached_[pair.source] = 0;  // another region may, wrongly, hold it too
  if (reached == pairs_.size()) return;
  fault(FaultKind::NotConnected, "region {}: {} of its {} faces are not connected to the first, {}", region_,
        pairs_.size() - reached, pairs_.size(), pairs_.front().source.value);
}

void Judge::remember_vertices() {
  for (const VertexId vertex : region_vertices_) {
    const VertexId image = vertex_image_[vertex].value;
    if (!first_image_[vertex].valid()) {
      first_image_[vertex] = image;
    } else if (first_image_[vertex] != image) {
      further_images_.push_back({vertex, image});
    }
    if (!first_origin_[image].valid()) first_origin_[image] = vertex;
    if (first_origin_[image] != vertex) disputed_target_[image] = 1;
  }
}

/// Sentence 6: what stands in the list is one-to-one and comes from a region.
void Judge::judge_listed(std::span<const VertexPair> vertices) {
  const auto by_number = [](const VertexPair& a, const VertexPair& b) {
    return a.source != b.source ? a.source < b.source : a.target < b.target;
  };
  std::sort(further_images_.begin(), further_images_.end(), by_number);
  for (const VertexPair& pair : vertices) {
    const auto [vertex, other] = pair;
    if (vertex.value >= source_.vertex_count() || other.value >= target_.vertex_count()) {
      fault(FaultKind::NoSuchElement, "vertices: {} -> {}: there is no such vertex", vertex.value, other.value);
      continue;
    }
    if (!listed_image_[vertex].valid()) {
      listed_image_[vertex] = other;
      ++verdict_.matched_vertices;
    }
    if (!listed_origin_[other].valid()) listed_origin_[other] = vertex;
    if (listed_image_[vertex] != other || listed_origin_[other] != vertex) {
      fault(FaultKind::BadVertexList, "vertices: {} -> {} breaks one-to-one", vertex.value, other.value);
    }
    if (first_image_[vertex] != other &&
        !std::binary_search(further_images_.begin(), further_images_.end(), pair, by_number)) {
      fault(FaultKind::BadVertexList, "vertices: {} -> {} is in no region", vertex.value, other.value);
    }
  }
}

/// Sentence 6: every vertex of a matched face stands in the list, unless regions disagree on it: it has two images, or
/// its image comes from two vertices.
void Judge::judge_missing() {
  PerVertex<std::uint8_t> disputed(source_.vertex_count(), 0);
  for (const VertexPair& further : further_images_) disputed[further.source] = 1;
  for (std::uint32_t number = 0; number < source_.vertex_count(); ++number) {
    const VertexId vertex(number);
    const VertexId image = first_image_[vertex];
    if (!image.valid() || listed_image_[vertex].valid()) continue;
    if (disputed[vertex] != 0 || disputed_target_[image] != 0) continue;
    fault(FaultKind::BadVertexList, "vertices: source vertex {} of a matched face is missing", number);
  }
}

}  // namespace

Verdict verify(const Mesh& source, const Mesh& target, const Match& match, std::size_t kept) {
  return Judge(source, target, kept).judge(match);
}

}  // namespace quadmatch
