#pragma once
/// The zoo by name, for properties that every mesh has.

#include <initializer_list>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <quadmatch/mesh/mesh.hpp>
#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/zoo.hpp>

namespace quadmatch::test {

/// @pre the soup is one a mesh can be built from
inline Mesh build(PolygonSoup soup) {
  Expected<Mesh> mesh = Mesh::build(std::move(soup));
  REQUIRE(mesh.has_value());
  return *std::move(mesh);
}

/// A soup without positions, face by face.
inline PolygonSoup soup_of(std::uint32_t vertex_count, std::initializer_list<std::vector<std::uint32_t>> faces) {
  PolygonSoup soup;
  soup.vertex_count = vertex_count;
  for (const std::vector<std::uint32_t>& face : faces) {
    soup.face_starts.push_back(static_cast<std::uint32_t>(soup.corners.size()));
    for (const std::uint32_t v : face) soup.corners.push_back(VertexId(v));
  }
  soup.face_starts.push_back(static_cast<std::uint32_t>(soup.corners.size()));
  return soup;
}

inline Mesh mesh_of(std::uint32_t vertex_count, std::initializer_list<std::vector<std::uint32_t>> faces) {
  return build(soup_of(vertex_count, faces));
}

struct NamedSoup {
  std::string name;
  PolygonSoup soup;
};

/// Simple, well-formed quad meshes, each connected.
inline std::vector<NamedSoup> well_formed_zoo() {
  return {{"quad", shapes::grid(1, 1)},
          {"grid", shapes::grid(4, 3)},
          {"cylinder", shapes::cylinder(5, 3)},
          {"slim cylinder", shapes::cylinder(3, 1)},
          {"star", shapes::star(5, 2)},
          {"torus", shapes::torus(5, 4)},
          {"cube", shapes::cube()},
          {"subdivided cube", shapes::cube_subdivided(3)},
          {"sphere", shapes::sphere(2)},
          {"grating", shapes::grating(2, 3)},
          {"dog toy", shapes::dog_toy(16)}};
}

/// Meshes that depart from §2.1, each in its own way.
inline std::vector<NamedSoup> dirty_zoo() {
  return {{"Moebius strip", shapes::mobius_strip(5)},
          {"Klein bottle", shapes::klein_bottle(4, 5)},
          {"prism", shapes::prism(5)},
          {"book", shapes::book()},
          {"Obs 2.2", shapes::observation_2_2(5)},
          {"hourglass", shapes::hourglass()},
          {"bow tie", shapes::bow_tie()},
          {"wrongly wound", shapes::wrongly_wound()},
          {"self-glued face", shapes::self_glued_face()},
          {"degenerate face", shapes::degenerate_face()},
          {"duplicate faces", shapes::duplicate_faces()},
          {"overlapping faces", shapes::overlapping_faces()},
          {"unused vertices", shapes::unused_vertices()},
          {"several pieces", shapes::disjoint_union({shapes::cube(), shapes::prism(3), shapes::grid(2, 2)})}};
}

inline std::vector<NamedSoup> whole_zoo() {
  std::vector<NamedSoup> zoo = well_formed_zoo();
  for (NamedSoup& dirty : dirty_zoo()) zoo.push_back(std::move(dirty));
  return zoo;
}

}  // namespace quadmatch::test
