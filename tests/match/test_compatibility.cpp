// The lazy-greedy growth against its definition: every wave it reports is replayed on a compatibility graph that is
// built from nothing.

#include <quadmatch/analysis/vertex_code.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/figures.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "match/compatibility_oracle.hpp"
#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

std::vector<std::uint32_t> codes_of(const Mesh& mesh) {
  const PerFan<VertexCode> codes = vertex_codes(mesh);
  std::vector<std::uint32_t> values;
  for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) values.push_back(codes[FanId(v)].value);
  return values;
}

/// Larger, or as large with fewer disagreeing corners.
bool is_better(const test::PlainComponent& one, const test::PlainComponent& other) {
  return one.faces != other.faces ? one.faces > other.faces : one.disagreeing < other.disagreeing;
}

/// The component of L that a wave of accepted pairs comes from; the best, where it can have come from several.
const test::PlainComponent* component_of(const test::PlainGraph& graph, const Mesh& source, const Mesh& target,
                                         const std::vector<FacePair>& wave) {
  const auto holds = [&](const test::PlainComponent& component, const FacePair& pair) {
    const auto is_pair = [&](const test::PlainCandidate& candidate) {
      const std::uint32_t size = source.size(pair.source);
      return source.face(candidate.first) == pair.source && target.face(candidate.second) == pair.target &&
             (source.corner(candidate.first) + pair.rotation) % size == target.corner(candidate.second);
    };
    return std::any_of(component.across_edges.begin(), component.across_edges.end(), is_pair) ||
           std::any_of(component.across_vertices.begin(), component.across_vertices.end(), is_pair);
  };
  const test::PlainComponent* best = nullptr;
  for (const test::PlainComponent& component : graph.components) {
    const auto in_it = [&](const FacePair& pair) { return holds(component, pair); };
    if (!std::all_of(wave.begin(), wave.end(), in_it)) continue;
    if (best == nullptr || is_better(component, *best)) best = &component;
  }
  return best;
}

/// Replay a lazy-greedy match wave by wave.
void check_waves(const Mesh& source, const Mesh& target, const MatchOptions& given = {}) {
  MatchOptions options = given;
  options.algorithm = Algorithm::LazyGreedy;
  options.waves = true;
  options.orientation = OrientationChoice::Preserving;
  const Match match = quadmatch::match(source, target, options).match;
  if (match.regions.empty()) return;
  const Region& region = match.regions.front();
  const std::vector<std::uint32_t> source_codes = codes_of(source);
  const std::vector<std::uint32_t> target_codes = codes_of(target);

  REQUIRE(region.waves.front() == 1);
  REQUIRE(region.waves.back() == region.faces.size());
  test::PlainMatch plain(source, target);
  plain.accept(region.faces.front());
  for (std::size_t wave = 1; wave <= region.waves.size(); ++wave) {
    const test::PlainGraph graph = test::compatibility_graph(source, target, plain, source_codes, target_codes);
    CHECK(graph.most_neighbours <= 2);  // §4.5.2: "vertices in L have degree at most 2"
    if (wave == region.waves.size()) {
      CHECK(graph.components.empty());  // §4.5.3: "until the current version of L contains no vertices"
      return;
    }
    const std::vector<FacePair> accepted(region.faces.begin() + region.waves[wave - 1],
                                         region.faces.begin() + region.waves[wave]);
    const test::PlainComponent* const component = component_of(graph, source, target, accepted);
    CAPTURE(wave);
    REQUIRE(component != nullptr);
    for (const test::PlainComponent& other : graph.components) CHECK_FALSE(is_better(other, *component));
    for (const FacePair& pair : accepted) plain.accept(pair);
    for (const auto& [s, t] : component->across_edges) CHECK_FALSE(plain.fits(s, t));  // all that fit were accepted
  }
}

TEST_CASE("§4.5.3: every wave is a largest component of L, on each mesh of the zoo and its renumbered self") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    check_waves(mesh, mesh);
    check_waves(mesh, test::build(shapes::renumbered(soup, 3).soup));
  }
}

TEST_CASE("§4.5.3: every wave is a largest component of L, on each two meshes of the zoo") {
  const std::vector<test::NamedSoup> zoo = test::whole_zoo();
  for (const auto& [name, soup] : zoo) {
    for (const auto& [other_name, other_soup] : zoo) {
      CAPTURE(name);
      CAPTURE(other_name);
      check_waves(test::build(soup), test::build(other_soup));
    }
  }
}

TEST_CASE("§4.5.3: every wave is a largest component of L, across random edits of a sphere and a grid") {
  for (const PolygonSoup& soup : {shapes::sphere(5), shapes::grid(9, 8), shapes::star(5, 4)}) {
    const Mesh source = test::build(soup);
    for (std::uint32_t step = 0; step < 12; ++step) {
      const FaceId face((7 * step + 3) % source.face_count());
      CAPTURE(step);
      for (const Expected<shapes::Edit>& edit :
           {shapes::collapse_quad(soup, source.first(face)), shapes::delete_patch(soup, face, 1 + step),
            shapes::insert_edge_loop(soup, source.first(face)), shapes::extrude_patch(soup, face, 1 + step, 0.5)}) {
        if (!edit) continue;
        check_waves(source, test::build(shapes::renumbered(edit->soup, step).soup));
      }
    }
  }
}

TEST_CASE("Fig 4.4: every wave is a largest component of L, on the paper's own example") {
  const Mesh m1 = test::build(shapes::fig_4_1().soup);
  const Mesh m2 = test::build(shapes::fig_4_2().soup);
  check_waves(m1, m2);
  check_waves(m2, m1);
}

}  // namespace
}  // namespace quadmatch
