#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>

#include <quadmatch/shapes/figures.hpp>

#include "topology.hpp"

using namespace quadmatch;
using quadmatch::testing::Face;
using quadmatch::testing::faces_meet_properly;
using quadmatch::testing::faces_of;
using quadmatch::testing::Topology;
using quadmatch::testing::topology_of;
using Valences = std::map<std::uint32_t, std::uint32_t>;

TEST_CASE("Fig 4.1: five extraordinary vertices, the four corners and the one marked start") {
  const shapes::Figure41 figure = shapes::fig_4_1();
  const Topology topology = topology_of(figure.soup);
  CHECK(topology.faces == 165);
  CHECK(topology.vertices == 193);
  CHECK(topology.extraordinary == 5);
  CHECK(topology.boundary_valences.at(2) == 4);
  CHECK(topology.boundary_valences.at(7) == 1);
  CHECK(topology.genus() == 0);
  CHECK(topology.boundary_loops == 2);
  CHECK(topology.clean());
  CHECK(faces_meet_properly(figure.soup));

  CHECK(figure.soup.corners[figure.seed.value] == figure.start);
  const auto faces_at_start = std::count(figure.soup.corners.begin(), figure.soup.corners.end(), figure.start);
  CHECK(faces_at_start == 6);
}

TEST_CASE("Fig 4.2: M2 is M1 with three quads in a row compressed into edges, and still a simple quad mesh") {
  const shapes::Figure42 figure = shapes::fig_4_2();
  const Topology topology = topology_of(figure.soup);
  CHECK(topology.faces == 162);
  CHECK(topology.vertices == 190);
  CHECK(topology.extraordinary == 9);
  CHECK(topology.inner_valences.at(3) == 2);
  CHECK(topology.inner_valences.at(5) == 2);
  CHECK(topology.genus() == 0);
  CHECK(topology.boundary_loops == 2);
  CHECK(topology.clean());
  CHECK(faces_meet_properly(figure.soup));
  CHECK(figure.soup.corners[figure.seed.value] == figure.start);
}

TEST_CASE("Fig 4.2: every other quad of M1 survives, corner on corner, and three vertices take in another") {
  const shapes::Figure41 original = shapes::fig_4_1();
  const shapes::Figure42 figure = shapes::fig_4_2();
  const std::vector<Face> before = faces_of(original.soup), after = faces_of(figure.soup);
  std::set<FaceId> lost(figure.squeezed.begin(), figure.squeezed.end());
  REQUIRE(lost.size() == 3);
  REQUIRE(figure.truth.size() == 162);
  std::map<std::uint32_t, std::set<std::uint32_t>> images, origins;
  for (const FacePair& pair : figure.truth) {
    CHECK(lost.count(pair.source) == 0);
    CHECK(pair.rotation == 0);
    for (std::size_t i = 0; i < 4; ++i) {
      images[before[pair.source.value][i]].insert(after[pair.target.value][i]);
      origins[after[pair.target.value][i]].insert(before[pair.source.value][i]);
    }
  }
  for (const auto& [vertex, found] : images) CHECK(found.size() == 1);
  const auto merged = std::count_if(origins.begin(), origins.end(), [](const auto& o) { return o.second.size() == 2; });
  CHECK(merged == 3);
  CHECK(origins.size() == 190);
  CHECK(*images[original.start.value].begin() == figure.start.value);
}
