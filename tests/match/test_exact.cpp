// The exact search against brute force, the judge, and itself.

#include <algorithm>
#include <optional>

#include <quadmatch/match/exact.hpp>
#include <quadmatch/mesh/components.hpp>
#include <quadmatch/shapes/random_edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/verify/verify.hpp>

#include "exact_oracle.hpp"
#include "mesh/named_meshes.hpp"

namespace quadmatch {
namespace {

std::uint32_t size_of(const LargestRegion& largest) {
  return static_cast<std::uint32_t>(largest.match.matched_faces());
}

/// Solve, and let the judge see what was found; the bound is never below it.
LargestRegion judged(const Mesh& source, const Mesh& target, const ExactOptions& options = {}) {
  LargestRegion largest = largest_region(source, target, options);
  const Verdict verdict = verify(source, target, largest.match);
  CHECK_MESSAGE(verdict.sound(), (verdict.faults.empty() ? std::string() : verdict.faults.front().message));
  CHECK(largest.match.regions.size() <= 1);
  CHECK(largest.optimality.bound >= size_of(largest));
  CHECK(largest.optimality.proved == (largest.optimality.bound == size_of(largest)));
  return largest;
}

/// Some faces of a mesh, by themselves.
PolygonSoup part_of(const Mesh& mesh, const std::vector<FaceId>& faces) {
  PolygonSoup part;
  std::vector<std::uint32_t> number(mesh.vertex_count(), VertexId::kNone);
  for (const FaceId face : faces) {
    part.face_starts.push_back(static_cast<std::uint32_t>(part.corners.size()));
    for (const HalfedgeId h : mesh.halfedges(face)) {
      std::uint32_t& here = number[mesh.origin(h).value];
      if (here == VertexId::kNone) {
        here = part.vertex_count++;
        part.positions.push_back(mesh.positions()[mesh.origin(h).value]);
      }
      part.corners.push_back(VertexId(here));
    }
  }
  part.face_starts.push_back(static_cast<std::uint32_t>(part.corners.size()));
  return part;
}

/// A disc of `count` faces around a random one, or fewer where the component has no more.
PolygonSoup random_patch(const PolygonSoup& soup, std::uint32_t count, shapes::Random& random) {
  const Mesh mesh = test::build(soup);
  std::vector<FaceId> faces{FaceId(random.below(mesh.face_count()))};
  for (std::size_t next = 0; next < faces.size() && faces.size() < count; ++next) {
    for (const HalfedgeId h : mesh.halfedges(faces[next])) {
      const HalfedgeId across = mesh.twin(h);
      if (!across.valid() || faces.size() == count) continue;
      if (std::find(faces.begin(), faces.end(), mesh.face(across)) == faces.end()) faces.push_back(mesh.face(across));
    }
  }
  return part_of(mesh, faces);
}

/// Meshes to cut patches from: regular and irregular, closed and open, with triangles and n-gons.
std::vector<PolygonSoup> quarries() {
  return {shapes::grid(8, 8),  shapes::star(5, 4),         shapes::star(3, 4),      shapes::sphere(3),
          shapes::torus(6, 5), shapes::dog_toy(3, 3),      shapes::cylinder(4, 6),  shapes::cube_subdivided(2),
          shapes::prism(5),    shapes::klein_bottle(4, 5), shapes::mobius_strip(9), shapes::grating(2, 2)};
}

/// A patch after one to three small edits; the patch itself where none fits.
PolygonSoup edited(const PolygonSoup& soup, shapes::Random& random) {
  static const shapes::RandomEdit kEdits[] = {{"delete", 1}, {"delete", 2}, {"collapse", 1}, {"extrude", 1},
                                              {"rip", 2},    {"refine", 1}, {"loop", 1},     {"unloop", 1}};
  PolygonSoup result = soup;
  for (std::uint32_t edits = 1 + random.below(3); edits > 0; --edits) {
    const Expected<shapes::Edit> edit = shapes::edit_at_random(result, kEdits[random.below(std::size(kEdits))], random);
    if (edit) result = edit->soup;
  }
  return result;
}

struct Instance {
  PolygonSoup source, target;
};

/// Tiny pairs by the hundred: patches and their edited copies, and patches that have nothing to do with each other.
std::vector<Instance> tiny_instances() {
  std::vector<Instance> instances;
  shapes::Random random(7);
  const std::vector<PolygonSoup> from = quarries();
  for (std::uint32_t round = 0; round < 12; ++round) {
    for (const PolygonSoup& quarry : from) {
      const PolygonSoup patch = random_patch(quarry, 4 + random.below(9), random);
      const PolygonSoup strange =
          random_patch(from[random.below(static_cast<std::uint32_t>(from.size()))], 4 + random.below(9), random);
      instances.push_back({patch, shapes::renumbered(edited(patch, random), round).soup});
      instances.push_back({patch, strange});
    }
  }
  return instances;
}

std::uint32_t by_brute_force(const Mesh& source, const Mesh& target) {
  const bool forth = source.face_count() <= target.face_count();
  return forth ? test::ExactOracle(source, target).largest() : test::ExactOracle(target, source).largest();
}

TEST_CASE("§3: the largest region is as large as brute force finds it, on hundreds of tiny pairs, either way round") {
  std::size_t number = 0, searched = 0;
  for (const auto& [source_soup, target_soup] : tiny_instances()) {
    CAPTURE(number);
    const Mesh source = test::build(source_soup), target = test::build(target_soup);
    const std::uint32_t preserving = by_brute_force(source, target);
    const std::uint32_t reversing = by_brute_force(source, target.mirrored());
    const LargestRegion one = judged(source, target, {.orientation = OrientationChoice::Preserving});
    const LargestRegion two = judged(source, target, {.orientation = OrientationChoice::Reversing});
    const LargestRegion both = judged(source, target);
    CHECK(one.optimality.proved);
    CHECK(two.optimality.proved);
    CHECK(both.optimality.proved);
    CHECK(size_of(one) == preserving);
    CHECK(size_of(two) == reversing);
    CHECK(size_of(both) == std::max(preserving, reversing));
    searched += both.optimality.nodes > 20 ? 1 : 0;
    ++number;
  }
  CHECK(number == 288);
  CHECK(searched > 50);  // or the test would say little
}

TEST_CASE("Theorem 3.2: a region of as many faces as the largest has is found, and none of one more") {
  std::size_t number = 0;
  for (const auto& [source_soup, target_soup] : tiny_instances()) {
    if (++number % 3 != 0) continue;
    CAPTURE(number);
    const Mesh source = test::build(source_soup), target = test::build(target_soup);
    const std::uint32_t optimum = size_of(judged(source, target));
    const LargestRegion none = judged(source, target, {.at_least = optimum + 1});
    CHECK(none.optimality.decision == Decision::No);
    CHECK(none.optimality.bound <= optimum);
    CHECK(none.match.complete);
    if (optimum == 0) continue;
    const LargestRegion some = judged(source, target, {.at_least = optimum});
    CHECK(some.optimality.decision == Decision::Yes);
    CHECK(size_of(some) == optimum);
    CHECK(some.match.complete);
  }
}

TEST_CASE("the largest region has the same size when source and target change places, and when both are renumbered") {
  std::size_t number = 0;
  for (const auto& [source_soup, target_soup] : tiny_instances()) {
    if (++number % 3 != 1) continue;
    CAPTURE(number);
    const Mesh source = test::build(source_soup), target = test::build(target_soup);
    const std::uint32_t size = size_of(judged(source, target));
    CHECK(size_of(judged(target, source)) == size);
    const Mesh copy = test::build(shapes::renumbered(source_soup, number).soup);
    const Mesh other_copy = test::build(shapes::renumbered(target_soup, number + 1).soup);
    CHECK(size_of(judged(copy, other_copy)) == size);
  }
}

TEST_CASE("every mesh of the zoo has its largest component in common with itself, proved") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    CAPTURE(name);
    const Mesh mesh = test::build(soup);
    const LargestRegion largest = judged(mesh, mesh);
    CHECK(largest.optimality.proved);
    const Components components = connected_components(mesh);
    CHECK(size_of(largest) == *std::max_element(components.face_count.begin(), components.face_count.end()));
  }
}

TEST_CASE("what any two meshes of the zoo have in common is sound and within its bound, wherever the search stops") {
  for (const auto& [name, soup] : test::whole_zoo()) {
    for (const auto& [other_name, other_soup] : test::whole_zoo()) {
      CAPTURE(name);
      CAPTURE(other_name);
      const Mesh source = test::build(soup), target = test::build(other_soup);
      const LargestRegion stopped = judged(source, target, {.node_limit = 1});
      const LargestRegion later = judged(source, target, {.node_limit = 500});
      CHECK(size_of(later) >= size_of(stopped));
      CHECK(later.optimality.bound >= size_of(stopped));
      CHECK(stopped.optimality.bound >= size_of(later));
      CHECK(later.optimality.nodes <= 500);
    }
  }
}

TEST_CASE("a mesh without faces, without quads, or of faces that fit none has an answer too") {
  const Mesh nothing = test::build(PolygonSoup{});
  const Mesh quad = test::build(shapes::grid(1, 1));
  const Mesh triangle = test::mesh_of(3, {{0, 1, 2}});
  const Mesh triangles = test::mesh_of(4, {{0, 1, 2}, {0, 2, 3}});
  for (const Mesh* other : {&nothing, &quad, &triangle, &triangles}) {
    CHECK(size_of(judged(nothing, *other)) == 0);
    CHECK(judged(nothing, *other).optimality.proved);
  }
  CHECK(size_of(judged(quad, quad)) == 1);
  CHECK(size_of(judged(quad, triangles)) == 0);
  CHECK(judged(quad, triangles).optimality.proved);
  CHECK(size_of(judged(triangle, triangles)) == 1);
  CHECK(size_of(judged(triangles, triangles)) == 2);
}

TEST_CASE("two faces that share two edges lie only on two faces that do") {
  const Mesh overlapping = test::build(shapes::overlapping_faces());
  CHECK(size_of(judged(overlapping, overlapping)) == 2);
  const LargestRegion one = judged(overlapping, test::build(shapes::grid(3, 3)));
  CHECK(one.optimality.proved);
  CHECK(size_of(one) == 1);
}

TEST_CASE("a patch of fifty quads and its edited copy: proved, the same on every run, and no smaller than the truth") {
  shapes::Random random(3);
  for (const char* recipe : {"delete:3", "collapse:1", "extrude:2", "rip:3", "refine:1", "loop:1"}) {
    CAPTURE(recipe);
    const PolygonSoup patch = random_patch(shapes::sphere(6), 50, random);
    const Expected<shapes::Edit> edit = shapes::edit_at_random(patch, *shapes::parse_random_edit(recipe), random);
    REQUIRE(edit.has_value());
    const Mesh source = test::build(patch), target = test::build(shapes::renumbered(edit->soup, 5).soup);
    const LargestRegion one = judged(source, target), two = judged(source, target);
    CHECK(one.optimality.proved);
    CHECK(one.optimality == two.optimality);
    CHECK(one.match.regions.front().faces == two.match.regions.front().faces);
    const MatchResult regions = match(source, target, {.positions = false});
    CHECK(size_of(one) >= regions.match.regions.front().faces.size());
  }
}

TEST_CASE("a search that the caller stops tells what it has, and that it is not complete") {
  shapes::Random random(11);
  const PolygonSoup patch = random_patch(shapes::grid(30, 30), 300, random);
  const Expected<shapes::Edit> edit = shapes::edit_at_random(patch, {"refine", 12}, random);
  REQUIRE(edit.has_value());
  const Mesh source = test::build(patch), target = test::build(edit->soup);
  std::uint32_t calls = 0, faces = 0;
  const auto progress = [&](const ExactProgress& so_far) {
    CHECK(so_far.faces >= faces);
    CHECK(so_far.bound >= so_far.faces);
    faces = so_far.faces;
    return ++calls < 3;
  };
  const LargestRegion stopped = judged(source, target, {.progress = progress});
  CHECK(calls == 3);
  CHECK_FALSE(stopped.optimality.proved);
  CHECK_FALSE(stopped.match.complete);
  CHECK(size_of(stopped) > 0);
  const LargestRegion unknown = judged(source, target, {.at_least = size_of(stopped) + 1, .node_limit = 10});
  CHECK(unknown.optimality.decision == Decision::Unknown);
}

TEST_CASE("a torus full of labels that do not fit is searched to the limit of nodes, and not for ever") {
  // Walking all labels, far more pairs are seen here than fit.
  const PolygonSoup torus = shapes::torus(16, 12);
  shapes::Random random(1);
  PolygonSoup edited = torus;
  for (const char* word : {"collapse:1", "delete:4", "extrude:4", "renumber"}) {
    edited = shapes::edit_at_random(edited, *shapes::parse_random_edit(word), random)->soup;
  }
  const LargestRegion stopped = judged(test::build(torus), test::build(edited),
                                       {.orientation = OrientationChoice::Preserving, .node_limit = 20'000});
  CHECK(stopped.optimality.nodes >= 20'000);
  CHECK(size_of(stopped) >= 170);
}

}  // namespace
}  // namespace quadmatch
