// The definition of a match, sentence by sentence: §3's condition on mu, and what makes a match carry vertex data.
// Plain loops over flat arrays and no search; nothing here knows how a match is found.

#include <quadmatch/verify/verify.hpp>

#include <algorithm>
#include <iterator>
#include <numeric>
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

  bool operator==(const Stamped&) const = default;
};

/// What was said of a vertex of the target.
struct Hit {
  Stamped<VertexId> origin;
  VertexId first;   ///< the first origin of all regions
  VertexId listed;  ///< its origin in the list of vertices
};

/// Which corners a face has. Where all faces are quads, as mostly, the compiler knows it too.
template <bool kQuads>
struct Corners {
  explicit Corners(const Mesh& of) : mesh(of), origins(of.corners()) {}

  const Mesh& mesh;
  const std::span<const VertexId> origins;

  [[nodiscard]] std::uint32_t size(FaceId face) const { return kQuads ? 4 : mesh.size(face); }
  [[nodiscard]] HalfedgeId at(FaceId face, std::uint32_t corner) const {
    return HalfedgeId((kQuads ? 4 * face.value : mesh.first(face).value) + corner);
  }
  [[nodiscard]] VertexId origin(HalfedgeId h) const { return origins[h.value]; }
  [[nodiscard]] FaceId face(HalfedgeId h) const { return kQuads ? FaceId(h.value / 4) : mesh.face(h); }
  [[nodiscard]] std::uint32_t corner(HalfedgeId h) const { return kQuads ? h.value % 4 : mesh.corner(h); }
};

/// How many pairs before they are judged their corners are asked for.
constexpr std::size_t kAhead = 8;

template <bool kQuads>
class Judge {
 public:
  Judge(const Mesh& source, const Mesh& target, std::size_t kept)
      : source_(source),
        target_(target),
        kept_(kept),
        face_image_(source.face_count()),
        face_hit_(target.face_count(), FaceId::kNone),
        listed_image_(source.vertex_count()) {}

  Verdict judge(const Match& match) &&;

 private:
  bool lies_as_listed(const Match& match);
  bool take_list(std::span<const VertexPair> vertices);
  void face(Orientation orientation);
  void judge_region(const Region& region);
  void judge_vertices();
  void gather_pairs(std::span<const FacePair> faces);
  bool names_a_pair(const FacePair& pair);
  // Compilers take a function that only gives hints for one without effect, and leave its calls out.
  [[gnu::always_inline]] inline void ask_for_vertices(std::size_t number) const;
  void map_corners(FacePair pair);
  void map_disputed(const FacePair& pair, VertexId vertex, VertexId other);
  bool judge_adjacency(std::uint32_t number);
  void judge_side(const FacePair& pair, std::uint32_t corner);
  std::size_t count_reached() const;
  void judge_listed(std::span<const VertexPair> vertices);
  void judge_missing();

  [[nodiscard]] bool exists(const FacePair& pair) const {
    return pair.source.value < face_image_.size() && pair.target.value < face_hit_.size();
  }
  [[nodiscard]] bool fits(const FacePair& pair) const {
    return source_.size(pair.source) == target_.size(pair.target) && pair.rotation < source_.size(pair.source);
  }
  [[nodiscard]] bool is_image(FaceId face) const { return face_image_[face].region == region_; }
  [[nodiscard]] bool is_target(FaceId face) const { return face_hit_[face] == region_; }
  /// The corner of the target face on which corner `corner` of the source face lies, as the half-edge that leaves it.
  [[nodiscard]] HalfedgeId corner_image(const FacePair& pair, std::uint32_t corner) const {
    if constexpr (kQuads) return target_.at(pair.target, (pair.rotation + step_ * corner) % 4);
    return target_.at(pair.target, image_corner(orientation_, pair.rotation, corner, source_.size(pair.source)));
  }
  /// The half-edge of the target face on which side `corner` of the source face lies. A side leaves its corner; turned
  /// over, it arrives there.
  [[nodiscard]] HalfedgeId side_image(const FacePair& pair, std::uint32_t corner) const {
    if (orientation_ == Orientation::Preserving) return corner_image(pair, corner);
    return corner_image(pair, corner + 1 == source_.size(pair.source) ? 0 : corner + 1);
  }

  template <class... Values>
  void fault(FaultKind kind, fmt::format_string<Values...> text, Values&&... values) {
    if (verdict_.fault_count++ >= kept_) return;
    verdict_.faults.push_back({kind, fmt::format(text, std::forward<Values>(values)...)});
  }

  const Corners<kQuads> source_;
  const Corners<kQuads> target_;
  const std::size_t kept_;
  bool as_listed_ = false;  // all corners lie as the list of vertices says: nothing else is to be said of vertices
  Verdict verdict_;

  // The region being judged.
  std::uint32_t region_ = 0;
  Orientation orientation_ = Orientation::Preserving;
  std::uint32_t step_ = 1;                      // from corner to corner of a target's quad, forward or back
  std::span<const FacePair> pairs_;             // what it names
  std::vector<FacePair> named_;                 // they, where it names others that cannot be judged
  std::size_t face_count_ = 0;                  // source faces
  PerFace<Stamped<std::uint32_t>> face_image_;  // index into pairs_
  PerFace<std::uint32_t> face_hit_;             // the last region that has it
  PerVertex<Stamped<VertexId>> vertex_image_;
  PerVertex<Hit> vertex_hit_;

  // Where regions disagree: all images of a source vertex that has several, and targets that have several origins.
  std::vector<VertexPair> further_images_;
  std::vector<VertexId> disputed_targets_;

  // The list of vertices.
  PerVertex<VertexId> listed_image_;
};

/// 1 where nothing else was said. A number, so that the processor is not made to guess.
constexpr unsigned is_free_for(VertexId said, VertexId wanted) {
  return static_cast<unsigned>(said == wanted) | static_cast<unsigned>(!said.valid());
}

constexpr bool by_number(const VertexPair& a, const VertexPair& b) {
  return a.source != b.source ? a.source < b.source : a.target < b.target;
}

template <bool kQuads>
Verdict Judge<kQuads>::judge(const Match& match) && {
  as_listed_ = lies_as_listed(match);
  if (!as_listed_) {
    vertex_image_ = PerVertex<Stamped<VertexId>>(listed_image_.size());
    vertex_hit_ = PerVertex<Hit>(target_.mesh.vertex_count());
    listed_image_ = PerVertex<VertexId>(listed_image_.size());
  }
  for (region_ = 0; region_ < match.regions.size(); ++region_) judge_region(match.regions[region_]);
  if (as_listed_) {
    verdict_.matched_vertices = match.vertices.size();
    return std::move(verdict_);
  }
  std::sort(further_images_.begin(), further_images_.end(), by_number);
  std::sort(disputed_targets_.begin(), disputed_targets_.end());
  judge_listed(match.vertices);
  judge_missing();
  return std::move(verdict_);
}

/// Is `vertices` one-to-one, do all corners of all regions lie as it says, and do they reach all of it? Then sentences
/// 2 and 6 hold. Mostly it is so, and quickly seen; else it takes the long way to say where it is not, or that regions
/// disagree, as they may.
template <bool kQuads>
bool Judge<kQuads>::lies_as_listed(const Match& match) {
  if (!take_list(match.vertices)) return false;
  PerVertex<std::uint8_t> reached(listed_image_.size(), 0);
  for (const Region& region : match.regions) {
    face(region.orientation);
    for (const FacePair& pair : region.faces) {
      if (!exists(pair) || !fits(pair)) return false;
      const std::uint32_t size = source_.size(pair.source);
      bool same = true;
      for (std::uint32_t corner = 0; corner < size; ++corner) {
        const VertexId vertex = source_.origin(source_.at(pair.source, corner));
        same &= listed_image_[vertex] == target_.origin(corner_image(pair, corner));
        reached[vertex] = 1;
      }
      if (!same) return false;
    }
  }
  return std::accumulate(reached.begin(), reached.end(), std::size_t{0}) == match.vertices.size();
}

/// @return  whether the list is one-to-one between vertices that exist.
template <bool kQuads>
bool Judge<kQuads>::take_list(std::span<const VertexPair> vertices) {
  PerVertex<std::uint8_t> hit(target_.mesh.vertex_count(), 0);
  for (const auto [vertex, other] : vertices) {
    if (vertex.value >= listed_image_.size() || other.value >= hit.size()) return false;
    if (listed_image_[vertex].valid() || hit[other] != 0) return false;
    listed_image_[vertex] = other;
    hit[other] = 1;
  }
  return true;
}

template <bool kQuads>
void Judge<kQuads>::face(Orientation orientation) {
  orientation_ = orientation;
  step_ = orientation == Orientation::Preserving ? 1 : 3;
}

template <bool kQuads>
void Judge<kQuads>::judge_region(const Region& region) {
  face(region.orientation);
  gather_pairs(region.faces);
  if (!as_listed_) judge_vertices();
  if (pairs_.empty()) {
    fault(FaultKind::EmptyRegion, "region {} has no face", region_);
    return;
  }
  const bool repeats = face_count_ < pairs_.size();
  // Sentence 4 holds if every face but the first lies beside one that stands before it, as in the order of growth.
  bool in_order = true;
  for (std::uint32_t k = 0; k < pairs_.size(); ++k) {
    if (repeats && face_image_[pairs_[k].source].value != k) continue;
    in_order = (judge_adjacency(k) || k == 0) && in_order;
  }
  const std::size_t reached = in_order ? face_count_ : count_reached();
  if (reached != face_count_) {
    fault(FaultKind::NotConnected, "region {}: {} of its {} faces are not connected to the first, {}", region_,
          face_count_ - reached, face_count_, pairs_.front().source.value);
  }
  verdict_.matched_faces += face_count_;
  verdict_.largest_region = std::max(verdict_.largest_region, face_count_);
}

/// The pairs that can be judged. Where a face is given two images, the later one is gone on with; but its vertices are
/// laid by both.
template <bool kQuads>
void Judge<kQuads>::gather_pairs(std::span<const FacePair> faces) {
  face_count_ = 0;
  std::uint32_t named = 0;
  for (const FacePair& pair : faces) {
    if (!names_a_pair(pair)) continue;
    if (!is_image(pair.source)) ++face_count_;
    face_image_[pair.source] = {region_, named++};
    face_hit_[pair.target] = region_;
  }
  pairs_ = faces;
  if (named == faces.size()) return;
  named_.clear();
  std::copy_if(faces.begin(), faces.end(), std::back_inserter(named_),
               [this](const FacePair& pair) { return exists(pair) && fits(pair); });
  pairs_ = named_;
}

/// Sentences 1 and 5.
template <bool kQuads>
bool Judge<kQuads>::names_a_pair(const FacePair& pair) {
  const auto [source, target, rotation] = pair;
  if (!exists(pair)) {
    fault(FaultKind::NoSuchElement, "region {}, pair {} -> {}: there is no such face", region_, source.value,
          target.value);
    return false;
  }
  if (!fits(pair)) {
    fault(FaultKind::CornersDoNotFit, "region {}, pair {} -> {}: {} and {} corners do not fit by rotation {}", region_,
          source.value, target.value, source_.size(source), target_.size(target), rotation);
    return false;
  }
  const bool source_twice = face_image_[source].region != FaceId::kNone;
  if (source_twice || face_hit_[target] != FaceId::kNone) {
    fault(FaultKind::FaceTwice, "region {}, pair {} -> {}: the {} face is matched twice", region_, source.value,
          target.value, source_twice ? "source" : "target");
  }
  return true;
}

/// Growth jumps about in both meshes: what will be read soon is asked for, first corners and then what they name.
template <bool kQuads>
void Judge<kQuads>::ask_for_vertices(std::size_t number) const {
  if (number + 2 * kAhead < pairs_.size()) {
    const FacePair& ahead = pairs_[number + 2 * kAhead];
    source_.mesh.prefetch_corners(source_.at(ahead.source, 0));
    target_.mesh.prefetch_corners(target_.at(ahead.target, 0));
  }
  if (number + kAhead < pairs_.size()) {
    const FacePair& ahead = pairs_[number + kAhead];
    const std::uint32_t size = source_.size(ahead.source);
    for (std::uint32_t corner = 0; corner < size; ++corner) {
      __builtin_prefetch(&vertex_image_[source_.origin(source_.at(ahead.source, corner))]);
      __builtin_prefetch(&vertex_hit_[target_.origin(target_.at(ahead.target, corner))]);
    }
  }
}

/// Sentence 2.
template <bool kQuads>
void Judge<kQuads>::judge_vertices() {
  for (std::size_t k = 0; k < pairs_.size(); ++k) {
    ask_for_vertices(k);
    map_corners(pairs_[k]);
  }
}

/// Sentence 2, at one face.
template <bool kQuads>
void Judge<kQuads>::map_corners(FacePair pair) {
  const std::uint32_t size = source_.size(pair.source), region = region_;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const VertexId vertex = source_.origin(source_.at(pair.source, corner));
    const VertexId other = target_.origin(corner_image(pair, corner));
    Stamped<VertexId>& image = vertex_image_[vertex];
    Hit& hit = vertex_hit_[other];
    // Mostly nothing else was ever said of either.
    if ((is_free_for(image.value, other) & is_free_for(hit.origin.value, vertex)) != 0) {
      image = {region, other};
      hit.origin = {region, vertex};
      hit.first = vertex;
    } else {
      map_disputed(pair, vertex, other);
    }
  }
}

/// The same where something else was said of one of them, in this region or before. Where a vertex is given two images
/// in one region, the earlier is gone on with.
template <bool kQuads>
void Judge<kQuads>::map_disputed(const FacePair& pair, VertexId vertex, VertexId other) {
  Stamped<VertexId>& image = vertex_image_[vertex];
  Hit& hit = vertex_hit_[other];
  if (image == Stamped<VertexId>{region_, other}) return;  // by another face of the region
  if (image.region == region_) {
    fault(FaultKind::VertexNotAFunction, "region {}, pair {} -> {}: source vertex {} has two images, {} and {}",
          region_, pair.source.value, pair.target.value, vertex.value, image.value.value, other.value);
  } else {
    if (image.region != FaceId::kNone && image.value != other) {
      further_images_.push_back({vertex, image.value});
      further_images_.push_back({vertex, other});
    }
    image = {region_, other};
    if (!hit.first.valid()) hit.first = vertex;
    if (hit.first != vertex) disputed_targets_.push_back(other);
  }
  if (hit.origin.region != region_) {
    hit.origin = {region_, vertex};
  } else if (hit.origin.value != vertex) {
    fault(FaultKind::VertexNotOneToOne, "region {}, pair {} -> {}: target vertex {} is hit twice, by {} and {}",
          region_, pair.source.value, pair.target.value, other.value, hit.origin.value.value, vertex.value);
  }
}

/// Sentence 3, at one face. What two faces share is looked at from the one that stands first: if it is laid on what
/// their partners share, both see it.
/// @return  whether a face beside it stands before it.
template <bool kQuads>
bool Judge<kQuads>::judge_adjacency(std::uint32_t number) {
  if (number + kAhead < pairs_.size()) {
    source_.mesh.prefetch_twins(source_.at(pairs_[number + kAhead].source, 0));
    target_.mesh.prefetch_twins(target_.at(pairs_[number + kAhead].target, 0));
  }
  const FacePair pair = pairs_[number];
  const std::uint32_t size = source_.size(pair.source), region = region_;
  bool follows = false;
  for (std::uint32_t corner = 0; corner < size; ++corner) {
    const HalfedgeId beside = source_.mesh.twin(source_.at(pair.source, corner));
    const Stamped<std::uint32_t> other = beside.valid() ? face_image_[source_.face(beside)] : Stamped<std::uint32_t>();
    if (other.region != region) {
      judge_side(pair, corner);
    } else if (other.value < number) {
      follows = true;
    } else if (const std::uint32_t back = source_.corner(beside);
               target_.mesh.twin(side_image(pair, corner)) != side_image(pairs_[other.value], back)) {
      judge_side(pair, corner);
      if (other.value > number) judge_side(pairs_[other.value], back);
    }
  }
  return follows;
}

/// Sentence 3 at one side.
template <bool kQuads>
void Judge<kQuads>::judge_side(const FacePair& pair, std::uint32_t corner) {
  const HalfedgeId beside = source_.mesh.twin(source_.at(pair.source, corner));
  const HalfedgeId beside_target = target_.mesh.twin(side_image(pair, corner));
  const bool matched = beside.valid() && is_image(source_.face(beside));
  const bool matched_target = beside_target.valid() && is_target(target_.face(beside_target));
  if (matched != matched_target) {
    fault(FaultKind::AdjacencyLost, "region {}, pair {} -> {}: adjacent to a matched face in the {} only, at side {}",
          region_, pair.source.value, pair.target.value, matched ? "source" : "target", corner);
  } else if (matched && pairs_[face_image_[source_.face(beside)].value].target != target_.face(beside_target)) {
    fault(FaultKind::AdjacencyLost, "region {}, pair {} -> {}: the faces beside it at side {}, {} and {}, are no pair",
          region_, pair.source.value, pair.target.value, corner, source_.face(beside).value,
          target_.face(beside_target).value);
  }
}

/// Faces of the region that can be reached from the first one, which is one of them.
template <bool kQuads>
std::size_t Judge<kQuads>::count_reached() const {
  std::vector<std::uint8_t> reached(pairs_.size(), 0);
  std::vector<FaceId> to_visit{pairs_.front().source};
  reached[face_image_[pairs_.front().source].value] = 1;
  std::size_t count = 1;
  while (!to_visit.empty()) {
    const FaceId face = to_visit.back();
    to_visit.pop_back();
    for (const HalfedgeId h : source_.mesh.halfedges(face)) {
      const HalfedgeId other = source_.mesh.twin(h);
      if (!other.valid() || !is_image(source_.face(other))) continue;
      std::uint8_t& here = reached[face_image_[source_.face(other)].value];
      if (here != 0) continue;
      here = 1;
      to_visit.push_back(source_.face(other));
      ++count;
    }
  }
  return count;
}

/// Sentence 6: what stands in the list is one-to-one and comes from a region.
template <bool kQuads>
void Judge<kQuads>::judge_listed(std::span<const VertexPair> vertices) {
  for (const VertexPair& pair : vertices) {
    const auto [vertex, other] = pair;
    if (vertex.value >= vertex_image_.size() || other.value >= vertex_hit_.size()) {
      fault(FaultKind::NoSuchElement, "vertices: {} -> {}: there is no such vertex", vertex.value, other.value);
      continue;
    }
    VertexId& image = listed_image_[vertex];
    VertexId& origin = vertex_hit_[other].listed;
    if (!image.valid()) {
      image = other;
      ++verdict_.matched_vertices;
    }
    if (!origin.valid()) origin = vertex;
    if (image != other || origin != vertex) {
      fault(FaultKind::BadVertexList, "vertices: {} -> {} breaks one-to-one", vertex.value, other.value);
    }
    if (vertex_image_[vertex].value != other &&
        !std::binary_search(further_images_.begin(), further_images_.end(), pair, by_number)) {
      fault(FaultKind::BadVertexList, "vertices: {} -> {} is in no region", vertex.value, other.value);
    }
  }
}

/// Sentence 6: every vertex of a matched face stands in the list, unless regions disagree on it: it has two images, or
/// its image comes from two vertices.
template <bool kQuads>
void Judge<kQuads>::judge_missing() {
  const auto by_source = [](const VertexPair& a, const VertexPair& b) { return a.source < b.source; };
  for (std::uint32_t number = 0; number < vertex_image_.size(); ++number) {
    const VertexId vertex(number);
    const VertexId image = vertex_image_[vertex].value;
    if (!image.valid() || listed_image_[vertex].valid()) continue;
    if (std::binary_search(further_images_.begin(), further_images_.end(), VertexPair{vertex, {}}, by_source)) continue;
    if (std::binary_search(disputed_targets_.begin(), disputed_targets_.end(), image)) continue;
    fault(FaultKind::BadVertexList, "vertices: source vertex {} of a matched face is missing", number);
  }
}

}  // namespace

Verdict verify(const Mesh& source, const Mesh& target, const Match& match, std::size_t kept) {
  if (source.all_quads() && target.all_quads()) return Judge<true>(source, target, kept).judge(match);
  return Judge<false>(source, target, kept).judge(match);
}

}  // namespace quadmatch
