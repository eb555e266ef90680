// verify against a second judge that reads the definition with maps and sets, on thousands of small damaged matches.

#include "matches.hpp"

#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/random.hpp>
#include <quadmatch/verify/verify.hpp>

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

/// Faces across each side, told from the corners alone: sides by (face, corner).
using Side = std::pair<std::uint32_t, std::uint32_t>;
using Across = std::map<Side, Side>;

Across adjacency(const Mesh& mesh) {
  std::map<std::pair<VertexId, VertexId>, std::vector<Side>> uses;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    for (std::uint32_t k = 0; k < mesh.size(FaceId(f)); ++k) {
      const VertexId from = corner_vertex(mesh, FaceId(f), k);
      const VertexId to = corner_vertex(mesh, FaceId(f), (k + 1) % mesh.size(FaceId(f)));
      uses[std::minmax(from, to)].emplace_back(f, k);
    }
  }
  Across across;
  for (const auto& [edge, sides] : uses) {
    if (sides.size() != 2 || sides[0].first == sides[1].first) continue;
    const VertexId one = corner_vertex(mesh, FaceId(sides[0].first), sides[0].second);
    const VertexId other = corner_vertex(mesh, FaceId(sides[1].first), sides[1].second);
    if (one == other) continue;
    across[sides[0]] = sides[1];
    across[sides[1]] = sides[0];
  }
  return across;
}

class SlowJudge {
 public:
  SlowJudge(const Mesh& source, const Mesh& target)
      : source_(source), target_(target), source_across_(adjacency(source)), target_across_(adjacency(target)) {}

  std::set<FaultKind> judge(const Match& match) {
    for (const Region& region : match.regions) judge_region(region);
    judge_list(match.vertices);
    return faults_;
  }

 private:
  void judge_region(const Region& region) {
    std::map<std::uint32_t, FacePair> image;
    std::set<std::uint32_t> targets;
    std::map<VertexId, VertexId> forward;
    std::map<VertexId, VertexId> backward;
    for (const FacePair& pair : region.faces) {
      const auto [source, target, rotation] = pair;
      if (source.value >= source_.face_count() || target.value >= target_.face_count()) {
        faults_.insert(FaultKind::NoSuchElement);
        continue;
      }
      const std::uint32_t size = source_.size(source);
      if (size != target_.size(target) || rotation >= size) {
        faults_.insert(FaultKind::CornersDoNotFit);
        continue;
      }
      if (used_source_.count(source.value) + used_target_.count(target.value) > 0) {
        faults_.insert(FaultKind::FaceTwice);
      }
      used_source_.insert(source.value);
      used_target_.insert(target.value);
      image[source.value] = pair;
      targets.insert(target.value);
      for (std::uint32_t k = 0; k < size; ++k) {
        const VertexId vertex = corner_vertex(source_, source, k);
        const VertexId other = corner_vertex(target_, target, image_of(region, rotation, k, size));
        if (forward.emplace(vertex, other).first->second != other) faults_.insert(FaultKind::VertexNotAFunction);
        if (backward.emplace(other, vertex).first->second != vertex) faults_.insert(FaultKind::VertexNotOneToOne);
      }
    }
    for (const auto& [vertex, other] : forward) {
      images_[vertex].insert(other);
      origins_[other].insert(vertex);
    }
    judge_sides(region, image, targets);
  }

  void judge_sides(const Region& region, const std::map<std::uint32_t, FacePair>& image,
                   const std::set<std::uint32_t>& targets) {
    std::map<std::uint32_t, std::set<std::uint32_t>> joined;
    for (const auto& [face, pair] : image) {
      const std::uint32_t size = source_.size(FaceId(face));
      for (std::uint32_t k = 0; k < size; ++k) {
        // The side between corners k and k + 1 lies between their images, whichever comes first.
        const std::uint32_t here = image_of(region, pair.rotation, k, size);
        const std::uint32_t there = image_of(region, pair.rotation, (k + 1) % size, size);
        const std::uint32_t side = region.orientation == Orientation::Preserving ? here : there;
        const auto beside = source_across_.find({face, k});
        const auto beside_target = target_across_.find({pair.target.value, side});
        const bool matched = beside != source_across_.end() && image.count(beside->second.first) > 0;
        const bool matched_target =
            beside_target != target_across_.end() && targets.count(beside_target->second.first) > 0;
        if (matched) joined[face].insert(beside->second.first);
        if (matched != matched_target ||
            (matched && image.at(beside->second.first).target.value != beside_target->second.first)) {
          faults_.insert(FaultKind::AdjacencyLost);
        }
      }
    }
    if (image.empty()) {
      faults_.insert(FaultKind::EmptyRegion);
      return;
    }
    std::set<std::uint32_t> reached;
    std::vector<std::uint32_t> to_visit{image.begin()->first};
    while (!to_visit.empty()) {
      const std::uint32_t face = to_visit.back();
      to_visit.pop_back();
      if (!reached.insert(face).second) continue;
      to_visit.insert(to_visit.end(), joined[face].begin(), joined[face].end());
    }
    if (reached.size() != image.size()) faults_.insert(FaultKind::NotConnected);
  }

  void judge_list(const std::vector<VertexPair>& vertices) {
    std::map<VertexId, VertexId> forward;
    std::map<VertexId, VertexId> backward;
    for (const auto& [vertex, other] : vertices) {
      if (vertex.value >= source_.vertex_count() || other.value >= target_.vertex_count()) {
        faults_.insert(FaultKind::NoSuchElement);
        continue;
      }
      const bool one_to_one = forward.emplace(vertex, other).first->second == other &&
                              backward.emplace(other, vertex).first->second == vertex;
      if (!one_to_one || images_[vertex].count(other) == 0) faults_.insert(FaultKind::BadVertexList);
    }
    for (const auto& [vertex, others] : images_) {
      const bool disputed = others.size() > 1 || std::any_of(others.begin(), others.end(), [this](VertexId other) {
                              return origins_[other].size() > 1;
                            });
      if (!others.empty() && !disputed && forward.count(vertex) == 0) faults_.insert(FaultKind::BadVertexList);
    }
  }

  static std::uint32_t image_of(const Region& region, std::uint32_t rotation, std::uint32_t k, std::uint32_t size) {
    return (region.orientation == Orientation::Preserving ? rotation + k : rotation + size - k) % size;
  }

  const Mesh& source_;
  const Mesh& target_;
  Across source_across_;
  Across target_across_;
  std::set<FaultKind> faults_;
  std::set<std::uint32_t> used_source_;
  std::set<std::uint32_t> used_target_;
  std::map<VertexId, std::set<VertexId>> images_;
  std::map<VertexId, std::set<VertexId>> origins_;
};

std::set<FaultKind> quick_faults(const Instance& instance) {
  std::set<FaultKind> kinds;
  for (const Fault& fault : verify(instance.source, instance.target, instance.match, 100'000).faults) {
    kinds.insert(fault.kind);
  }
  return kinds;
}

/// Do one of the things that can go wrong with a match.
void damage(Instance& instance, shapes::Random& random) {
  std::vector<Region>& regions = instance.match.regions;
  Region& region = regions[random.below(static_cast<std::uint32_t>(regions.size()))];
  std::vector<VertexPair>& vertices = instance.match.vertices;
  if (region.faces.empty()) return;
  const std::uint32_t at = random.below(static_cast<std::uint32_t>(region.faces.size()));
  FacePair& pair = region.faces[at];
  switch (random.below(10)) {
    case 0:
      pair.rotation = random.below(5);
      break;
    case 1:
      pair.target = FaceId(random.below(instance.target.face_count() + 1));
      break;
    case 2:
      pair.source = FaceId(random.below(instance.source.face_count() + 1));
      break;
    case 3:
      region.faces.erase(region.faces.begin() + at);
      break;
    case 4:
      std::swap(pair.target, region.faces[random.below(static_cast<std::uint32_t>(region.faces.size()))].target);
      break;
    case 5:
      region.orientation = Orientation::Reversing;
      break;
    case 6: {  // split in two
      Region tail{.orientation = region.orientation, .faces = {region.faces.begin() + at, region.faces.end()}};
      region.faces.erase(region.faces.begin() + at, region.faces.end());
      regions.push_back(std::move(tail));
      break;
    }
    case 7:
      region.faces.erase(region.faces.begin() + at, region.faces.end());
      break;
    case 8:
      if (!vertices.empty())
        vertices.erase(vertices.begin() + random.below(static_cast<std::uint32_t>(vertices.size())));
      break;
    default:
      vertices.push_back({VertexId(random.below(instance.source.vertex_count() + 1)),
                          VertexId(random.below(instance.target.vertex_count() + 1))});
  }
}

}  // namespace

TEST_CASE("verify finds the kinds of fault that a judge with maps and sets finds") {
  const std::vector<PolygonSoup> soups{shapes::grid(2, 1),
                                       shapes::grid(3, 3),
                                       shapes::cube(),
                                       shapes::torus(3, 3),
                                       shapes::cylinder(3, 2),
                                       shapes::prism(3),
                                       shapes::star(3, 1),
                                       shapes::hourglass(),
                                       shapes::wrongly_wound(),
                                       shapes::mobius_strip(4),
                                       shapes::book(),
                                       shapes::bow_tie(),
                                       shapes::self_glued_face(),
                                       shapes::degenerate_face(),
                                       shapes::duplicate_faces(),
                                       shapes::overlapping_faces()};
  std::size_t sound = 0;
  std::set<FaultKind> seen;
  for (std::uint64_t seed = 0; seed < 6000; ++seed) {
    CAPTURE(seed);
    shapes::Random random(seed);
    const PolygonSoup& soup = soups[random.below(static_cast<std::uint32_t>(soups.size()))];
    Instance instance = random.below(2) == 0 ? renumbered_instance(soup, seed) : mirrored_instance(soup, seed);
    for (std::uint32_t blows = random.below(4); blows > 0; --blows) damage(instance, random);
    const std::set<FaultKind> expected = SlowJudge(instance.source, instance.target).judge(instance.match);
    REQUIRE(quick_faults(instance) == expected);
    CHECK(verify(instance.source, instance.target, instance.match).sound() == expected.empty());
    if (expected.empty()) ++sound;
    seen.insert(expected.begin(), expected.end());
  }
  CHECK(sound > 500);
  CHECK(seen.size() == 9);
}
