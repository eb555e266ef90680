#pragma once
/// Sound matches to begin with, and their vertex maps.

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include <doctest/doctest.h>
#include <quadmatch/mesh/match.hpp>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

namespace quadmatch::test {

inline Mesh build(PolygonSoup soup) {
  Expected<Mesh> mesh = Mesh::build(std::move(soup));
  REQUIRE(mesh.has_value());
  return *std::move(mesh);
}

inline VertexId corner_vertex(const Mesh& mesh, FaceId face, std::uint32_t corner) {
  return mesh.origin(HalfedgeId(mesh.first(face).value + corner));
}

/// The pairs of vertices that a region lays on each other.
inline std::set<std::pair<VertexId, VertexId>> vertex_pairs(const Mesh& source, const Mesh& target,
                                                            const Region& region) {
  std::set<std::pair<VertexId, VertexId>> pairs;
  for (const FacePair& pair : region.faces) {
    const std::uint32_t size = source.size(pair.source);
    for (std::uint32_t corner = 0; corner < size; ++corner) {
      pairs.emplace(corner_vertex(source, pair.source, corner),
                    corner_vertex(target, pair.target, image_corner(region.orientation, pair.rotation, corner, size)));
    }
  }
  return pairs;
}

/// Fill in `vertices` as a matcher would: regions in order, an image only where neither end is taken.
inline void list_vertices(const Mesh& source, const Mesh& target, Match& match) {
  std::map<VertexId, VertexId> images;
  std::set<VertexId> taken;
  for (const Region& region : match.regions) {
    for (const auto& [vertex, other] : vertex_pairs(source, target, region)) {
      if (images.count(vertex) == 0 && taken.count(other) == 0) {
        images.emplace(vertex, other);
        taken.insert(other);
      }
    }
  }
  match.vertices.clear();
  for (const auto& [vertex, other] : images) match.vertices.push_back({vertex, other});
}

/// A mesh, a copy of it in another order, and the true match of the two.
struct Instance {
  Mesh source;
  Mesh target;
  Match match;
};

inline Instance renumbered_instance(const PolygonSoup& soup, std::uint64_t seed) {
  const shapes::Renumbered copy = shapes::renumbered(soup, seed);
  Instance instance{build(soup), build(copy.soup), {}};
  instance.match.regions.push_back({.orientation = Orientation::Preserving, .faces = copy.faces});
  list_vertices(instance.source, instance.target, instance.match);
  return instance;
}

/// The same, the target turned over: corner k of n has become corner n - 1 - k.
inline Instance mirrored_instance(const PolygonSoup& soup, std::uint64_t seed) {
  Instance instance = renumbered_instance(soup, seed);
  instance.target = instance.target.mirrored();
  Region& region = instance.match.regions[0];
  region.orientation = Orientation::Reversing;
  for (FacePair& pair : region.faces) pair.rotation = instance.target.size(pair.target) - 1 - pair.rotation;
  return instance;
}

}  // namespace quadmatch::test
