// Merges of random edits, held against both edits made one after the other.

#include <quadmatch/use/merge.hpp>

#include <doctest/doctest.h>

#include <array>
#include <optional>

#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/random_edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/verify/verify.hpp>

#include "io/io_support.hpp"
#include "merge_sites.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

MeshFile bare(const PolygonSoup& soup) { return {.mesh = build(soup)}; }

Merged merged(const MeshFile& base, const MeshFile& ours, const MeshFile& theirs, Side prefer = Side::Ours) {
  Expected<Merged> result = merge(base, ours, theirs, match_side(base.mesh, ours.mesh),
                                  match_side(base.mesh, theirs.mesh), {.prefer = prefer});
  if (!result) FAIL(result.error().describe());
  return *std::move(result);
}

/// Every face of a merge is, corner by corner, one that each of its origins has; and it has one.
void check_origins(const Merged& result, const MeshFile& base, const MeshFile& ours, const MeshFile& theirs) {
  REQUIRE(result.face_origins.size() == result.file.mesh.face_count());
  REQUIRE(result.vertex_origins.size() == result.file.mesh.vertex_count());
  std::size_t wrong = 0;
  for (std::uint32_t f = 0; f < result.face_origins.size(); ++f) {
    bool any = false;
    for (const auto& [side, file] : {std::pair(Side::Base, &base), {Side::Ours, &ours}, {Side::Theirs, &theirs}}) {
      const FaceId there = result.face_origins[f][side];
      if (!there.valid()) continue;
      any = true;
      if (file->mesh.size(there) != result.file.mesh.size(FaceId(f))) ++wrong;
    }
    if (!any) ++wrong;
  }
  CHECK(wrong == 0);
}

/// No more departures of any kind than both sides have together, but for holes that came to touch themselves.
void check_departures(const Mesh& result, const std::array<const Mesh*, 3>& meshes) {
  std::vector<std::size_t> allowed = check(*meshes[0], 0).departure_counts;
  for (std::size_t k = 1; k < 3; ++k) {
    const std::vector<std::size_t> counts = check(*meshes[k], 0).departure_counts;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) allowed[kind] += counts[kind];
  }
  const std::vector<std::size_t> found = check(result, 0).departure_counts;
  for (std::size_t kind = 0; kind < found.size(); ++kind) {
    if (static_cast<DepartureKind>(kind) != DepartureKind::PinchedHole) CHECK(found[kind] <= allowed[kind]);
  }
}

/// The same mesh up to numbering, with every vertex where it should be.
bool is_same(const Mesh& result, const Mesh& truth) {
  const IsomorphismResult found = find_isomorphism(result, truth, IsomorphismKind::Preserving);
  if (!found.isomorphism) return false;
  std::size_t moved = 0;
  for (const VertexPair& pair : found.isomorphism->match.vertices) {
    const Point &a = result.positions()[pair.source.value], &b = truth.positions()[pair.target.value];
    for (std::size_t k = 0; k < 3; ++k) {
      if (std::abs(a[k] - b[k]) > 1e-12) ++moved;
    }
  }
  return moved == 0;
}

MeshFile renumbered_file(const PolygonSoup& soup, std::uint64_t seed) {
  return bare(shapes::renumbered(soup, seed).soup);
}

/// Edits of a mesh at places that have nothing to do with each other.
struct Places {
  const Mesh& base;
  const PolygonSoup& soup;
  shapes::Random random;

  /// A random edit that fits, two faces or more away from these vertices.
  std::pair<Site, std::vector<bool>> next(const std::vector<bool>& taken) {
    for (int attempt = 0; attempt < 2000; ++attempt) {
      const Site site = random_site(base, random);
      Edited edited(soup);
      if (!edited.apply(base, site)) continue;
      std::vector<bool> touched = edited.touched(base);
      if (meet(widened(base, widened(base, touched)), taken)) continue;
      return {site, std::move(touched)};
    }
    FAIL("no place for another edit");
    return {};
  }

  /// One that touches some of these vertices, and these not.
  std::optional<Site> next_meeting(const std::vector<bool>& some, const std::vector<bool>& taken) {
    for (int attempt = 0; attempt < 4000; ++attempt) {
      const Site site = random_site(base, random);
      Edited edited(soup);
      if (!edited.apply(base, site)) continue;
      const std::vector<bool> touched = edited.touched(base);
      if (meet(touched, some) && !meet(widened(base, widened(base, touched)), taken)) return site;
    }
    return std::nullopt;
  }
};

std::vector<bool> united(std::vector<bool> a, const std::vector<bool>& b) {
  for (std::size_t v = 0; v < a.size(); ++v) a[v] = a[v] || b[v];
  return a;
}

PolygonSoup edited_at(const Mesh& base, const PolygonSoup& soup, const std::vector<Site>& sites) {
  Edited edited(soup);
  for (const Site& site : sites) REQUIRE(edited.apply(base, site));
  return edited.soup();
}

}  // namespace

TEST_CASE("merge: disjoint edits are both applied, as if made one after the other, renumbered or not") {
  for (const auto& [name, soup] :
       {std::pair("bear", shapes::bear().soup), std::pair("shirt", shapes::shirt(shapes::Sleeves::Short).soup)}) {
    const MeshFile base = bare(soup);
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
      Places places{base.mesh, soup, shapes::Random(seed)};
      const auto [one, touched] = places.next(std::vector<bool>(base.mesh.vertex_count(), false));
      const auto [another, _] = places.next(widened(base.mesh, touched));
      INFO(name << ", seed " << seed << ": " << one.name() << ", " << another.name());
      const PolygonSoup ours = edited_at(base.mesh, soup, {one}), theirs = edited_at(base.mesh, soup, {another});
      const Mesh truth = build(edited_at(base.mesh, soup, {one, another}));
      for (const bool shuffled : {false, true}) {
        INFO((shuffled ? "renumbered" : "as they are"));
        const MeshFile a = shuffled ? renumbered_file(ours, 2 * seed) : bare(ours);
        const MeshFile b = shuffled ? renumbered_file(theirs, 2 * seed + 1) : bare(theirs);
        const Merged result = merged(base, a, b);
        CHECK(result.report.clean());
        CHECK(result.report.new_departures.empty());
        CHECK(is_same(result.file.mesh, truth));
        check_origins(result, base, a, b);
      }
    }
  }
}

TEST_CASE("merge: where edits meet, OUT holds the preferred side, and all other edits of both sides") {
  const PolygonSoup soup = shapes::bear().soup;
  const MeshFile base = bare(soup);
  std::uint32_t tried = 0;
  for (std::uint64_t seed = 100; tried < 10; ++seed) {
    Places places{base.mesh, soup, shapes::Random(seed)};
    const auto [a, near_a] = places.next(std::vector<bool>(base.mesh.vertex_count(), false));
    const auto [c, near_c] = places.next(widened(base.mesh, near_a));
    const auto [d, near_d] = places.next(widened(base.mesh, united(near_a, near_c)));
    const auto b = places.next_meeting(near_a, widened(base.mesh, united(near_c, near_d)));
    if (!b) continue;
    ++tried;
    INFO("seed " << seed << ": " << a.name() << " and " << c.name() << "; " << b->name() << " and " << d.name());
    const MeshFile ours = renumbered_file(edited_at(base.mesh, soup, {a, c}), seed);
    const MeshFile theirs = bare(edited_at(base.mesh, soup, {*b, d}));
    const Merged with_ours = merged(base, ours, theirs);
    if (with_ours.report.clean()) {
      // A twisted ring is joined anew at one of its ends only, so twists of rings side by side can both be made.
      CHECK((a.kind == EditKind::Twist && b->kind == EditKind::Twist));
      CHECK(is_same(with_ours.file.mesh, build(edited_at(base.mesh, soup, {a, *b, c, d}))));
      continue;
    }
    CHECK(with_ours.report.areas.size() >= 1);
    CHECK(is_same(with_ours.file.mesh, build(edited_at(base.mesh, soup, {a, c, d}))));
    const Merged with_theirs = merged(base, ours, theirs, Side::Theirs);
    CHECK(with_theirs.report.areas.size() == with_ours.report.areas.size());
    CHECK(is_same(with_theirs.file.mesh, build(edited_at(base.mesh, soup, {*b, c, d}))));
    check_origins(with_ours, base, ours, theirs);
    check_origins(with_theirs, base, ours, theirs);
  }
}

TEST_CASE("merge: a side that changed nothing gives the other side back, whatever that is") {
  std::vector<NamedSoup> bases = whole_zoo();
  shapes::Random random(3);
  for (const NamedSoup& base : bases) {
    const MeshFile file = bare(base.soup);
    std::vector<NamedSoup> others = whole_zoo();
    others.push_back({"renumbered", shapes::renumbered(base.soup, 5).soup});
    for (const char* const kind : {"delete:1", "extrude:1", "refine:1", "rip:2", "twist:1"}) {
      const auto edit = shapes::edit_at_random(base.soup, *shapes::parse_random_edit(kind), random);
      if (edit) others.push_back({kind, edit->soup});
    }
    for (const NamedSoup& named : others) {
      INFO(base.name << " and " << named.name);
      const MeshFile other = bare(named.soup);
      const std::string text = format_mesh(other, Format::Obj);
      CHECK((format_mesh(merged(file, other, file).file, Format::Obj) == text));
      const MeshFile theirs = merged(file, file, other).file;
      if (named.name == "renumbered") {  // then neither changed anything
        CHECK(find_isomorphism(theirs.mesh, other.mesh, IsomorphismKind::Preserving).isomorphism.has_value());
      } else {
        CHECK((format_mesh(theirs, Format::Obj) == text));
      }
      // Unchanged up to numbering is unchanged, too.
      const MeshFile again = renumbered_file(base.soup, 9);
      const Merged result = merged(file, other, again);
      CHECK(result.report.areas.empty());
      CHECK(find_isomorphism(result.file.mesh, other.mesh, IsomorphismKind::Preserving).isomorphism.has_value());
      check_origins(result, file, other, again);
    }
  }
}

TEST_CASE("merge: what both sides did in the same way is done once") {
  const PolygonSoup soup = shapes::bear().soup;
  const MeshFile base = bare(soup);
  for (std::uint32_t kind = 0; kind < kEditKinds; ++kind) {
    shapes::Random random(kind);
    for (int attempt = 0; attempt < 400; ++attempt) {
      Site site = random_site(base.mesh, random);
      site.kind = static_cast<EditKind>(kind);
      Edited edited(soup);
      if (!edited.apply(base.mesh, site)) continue;
      INFO(site.name());
      const Merged result = merged(base, bare(edited.soup()), renumbered_file(edited.soup(), 4));
      CHECK(result.report.clean());
      CHECK(is_same(result.file.mesh, edited.mesh()));
      break;
    }
  }
}

TEST_CASE("merge: any matches that are sound make a mesh of faces of the three, as clean as they are") {
  // Matches that lie wrongly: found by connectivity alone, of meshes with many symmetries or nothing to do with each
  // other.
  std::uint32_t seed = 0;
  for (const NamedSoup& named : well_formed_zoo()) {
    const MeshFile base = bare(named.soup);
    shapes::Random random(++seed);
    std::vector<MeshFile> sides{bare(shapes::torus(6, 4)), bare(shapes::cube_subdivided(2)), bare(shapes::grid(5, 3))};
    for (const char* const kind : {"delete:2", "extrude:2", "loop:1", "rip:3", "collapse:1", "handle:1"}) {
      const auto edit = shapes::edit_at_random(named.soup, *shapes::parse_random_edit(kind), random);
      if (edit) sides.push_back(renumbered_file(edit->soup, seed));
    }
    for (const MeshFile& ours : sides) {
      for (const MeshFile& theirs : sides) {
        const MatchOptions blind{.positions = false};
        const Match to_ours = match_side(base.mesh, ours.mesh, blind),
                    to_theirs = match_side(base.mesh, theirs.mesh, blind);
        for (const Side prefer : {Side::Ours, Side::Theirs}) {
          const Expected<Merged> result = merge(base, ours, theirs, to_ours, to_theirs, {.prefer = prefer});
          if (!result) {
            CHECK((to_ours.regions.empty() || to_theirs.regions.empty()));
            continue;
          }
          INFO(named.name);
          check_origins(*result, base, ours, theirs);
          CHECK(result->report.new_departures.empty());
          check_departures(result->file.mesh, {&base.mesh, &ours.mesh, &theirs.mesh});
        }
      }
    }
  }
}
