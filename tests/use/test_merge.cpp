#include <quadmatch/use/merge.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>

#include "io/io_support.hpp"
#include "mesh/named_meshes.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

MeshFile bare(const PolygonSoup& soup) { return {.mesh = build(soup)}; }

Expected<Merged> try_merge(const MeshFile& base, const MeshFile& ours, const MeshFile& theirs,
                           Side prefer = Side::Ours) {
  return merge(base, ours, theirs, match_side(base.mesh, ours.mesh), match_side(base.mesh, theirs.mesh),
               {.prefer = prefer});
}

Merged merged(const MeshFile& base, const MeshFile& ours, const MeshFile& theirs, Side prefer = Side::Ours) {
  Expected<Merged> result = try_merge(base, ours, theirs, prefer);
  if (!result) FAIL(result.error().describe());
  return *std::move(result);
}

/// Text with one line for another.
std::string with(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

MeshFile obj(const std::string& text) { return parsed(text, Format::Obj); }
std::string text_of(const MeshFile& file) { return format_mesh(file, Format::Obj); }

/// A grid of four by one quads with texture coordinates, two objects and two materials.
const std::string kStrip =
    "mtllib a.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\nv 4 1 0\n"
    "vt 0 0\nvt 0.25 0\nvt 0.5 0\nvt 0.75 0\nvt 1 0\nvt 0 1\nvt 0.25 1\nvt 0.5 1\nvt 0.75 1\nvt 1 1\n"
    "o left\ng a\nusemtl skin\nf 1/1 2/2 7/7 6/6\nf 2/2 3/3 8/8 7/7\n"
    "o right\ng b\nusemtl cloth\nf 3/3 4/4 9/9 8/8\nf 4/4 5/5 10/10 9/9\n";

const ValueConflict& conflict(const Merged& result, std::string_view name) {
  for (const ValueConflict& entry : result.report.values) {
    if (entry.name == name) return entry;
  }
  FAIL("no conflict of " << name);
  return result.report.values.front();
}

PolygonSoup moved(PolygonSoup soup, std::uint32_t vertex, const Point& to) {
  soup.positions[vertex] = to;
  return soup;
}

}  // namespace

TEST_CASE("merge: vertices moved by either side are moved, those moved by both to the same place too") {
  const PolygonSoup soup = shapes::grid(5, 4);
  const MeshFile base = bare(soup);
  const MeshFile ours = bare(moved(moved(soup, 3, {3, 0, 1}), 7, {1, 1, 1}));
  const MeshFile theirs = bare(moved(moved(soup, 20, {2, 3, 9}), 7, {1, 1, 1}));
  const Merged result = merged(base, ours, theirs);
  CHECK(result.report.clean());
  CHECK(result.report.ours.moved_vertices == 2);
  CHECK(result.report.theirs.moved_vertices == 2);
  CHECK(result.file.mesh.positions()[3] == Point{3, 0, 1});
  CHECK(result.file.mesh.positions()[7] == Point{1, 1, 1});
  CHECK(result.file.mesh.positions()[20] == Point{2, 3, 9});
}

TEST_CASE(
    "merge: a vertex moved to two places is a conflict of positions, named, and is where the preferred side has it") {
  const PolygonSoup soup = shapes::grid(5, 4);
  const MeshFile base = bare(soup);
  const MeshFile ours = bare(moved(moved(soup, 7, {1, 1, 1}), 2, {2, 0, 5}));
  const MeshFile theirs = bare(moved(soup, 7, {1, 1, 2}));
  for (const Side prefer : {Side::Ours, Side::Theirs}) {
    const Merged result = merged(base, ours, theirs, prefer);
    CHECK_FALSE(result.report.clean());
    CHECK(result.report.areas.empty());
    CHECK(conflict(result, "positions").count == 1);
    CHECK(conflict(result, "positions").first == std::vector<std::uint32_t>{7});
    CHECK(result.file.mesh.positions()[7][2] == (prefer == Side::Ours ? 1 : 2));
    CHECK(result.file.mesh.positions()[2] == Point{2, 0, 5});
  }
}

TEST_CASE("merge: what one side adds is carried along by the pose of the other") {
  const shapes::Model rest = shapes::bear();
  shapes::BearOptions posed;
  posed.pose.left_arm = 0.2;
  const MeshFile base = bare(rest.soup), theirs = bare(shapes::bear(posed).soup);
  // A loop on the raised arm; and, for the truth, the same loop on the posed bear.
  std::uint32_t highest = 0;
  double most = 0;
  for (std::uint32_t v = 0; v < rest.soup.vertex_count; ++v) {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double d = theirs.mesh.positions()[v][k] - base.mesh.positions()[v][k];
      square += d * d;
    }
    if (square > most) most = square, highest = v;
  }
  const HalfedgeId at = base.mesh.halfedge(FanId(highest));
  const auto ours = shapes::refine_patch(rest.soup, base.mesh.face(at), 4);
  const auto truth = shapes::refine_patch(shapes::bear(posed).soup, base.mesh.face(at), 4);
  REQUIRE((ours.has_value() && truth.has_value()));
  const Merged result = merged(base, bare(ours->soup), theirs);
  CHECK(result.report.clean());
  CHECK(result.report.carried_along > 0);
  const Mesh expected = build(truth->soup);
  REQUIRE(result.file.mesh.vertex_count() == expected.vertex_count());
  // The order is that of OURS, so vertex lies beside vertex; displacements there differ by little from harmonic ones.
  double worst = 0;
  for (std::uint32_t v = 0; v < expected.vertex_count(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::max(worst, std::abs(expected.positions()[v][k] - result.file.mesh.positions()[v][k]));
    }
  }
  CHECK(worst < 0.05 * std::sqrt(most));
}

TEST_CASE("merge: where edits meet in a posed mesh, the preferred side's faces are carried along by the pose") {
  const shapes::Model rest = shapes::bear();
  shapes::BearOptions bent;
  bent.pose.body_bend = 0.1;
  const PolygonSoup pose = shapes::bear(bent).soup;
  const MeshFile base = bare(rest.soup);
  const auto ours = shapes::refine_patch(rest.soup, FaceId(700), 4);
  const auto theirs = shapes::delete_patch(pose, FaceId(700), 6);
  const auto truth = shapes::refine_patch(pose, FaceId(700), 4);
  REQUIRE((ours.has_value() && theirs.has_value() && truth.has_value()));
  const Merged result = merged(base, bare(ours->soup), bare(theirs->soup));
  CHECK(result.report.areas.size() == 1);
  const Mesh expected = build(truth->soup);
  REQUIRE(result.file.mesh.vertex_count() == expected.vertex_count());
  double worst = 0, left_behind = 0;
  for (std::uint32_t v = 0; v < expected.vertex_count(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::max(worst, std::abs(expected.positions()[v][k] - result.file.mesh.positions()[v][k]));
      left_behind = std::max(left_behind, std::abs(expected.positions()[v][k] - ours->soup.positions[v][k]));
    }
  }
  CHECK(worst < 0.1 * left_behind);
}

TEST_CASE("merge: texture coordinates, groups and materials come from the side that changed them") {
  const MeshFile base = obj(kStrip);
  const MeshFile ours = obj(with(with(kStrip, "vt 0 0\n", "vt 0.1 0.1\n"), "g b\n", "g sleeve\n"));
  const MeshFile theirs = obj(with(with(kStrip, "vt 1 1\n", "vt 0.9 0.9\n"), "usemtl skin\n", "usemtl fur\n"));
  const Merged result = merged(base, ours, theirs);
  CHECK(result.report.clean());
  const std::string expected = with(with(with(text_of(ours), "usemtl skin", "usemtl fur"), "vt 1 1\n", ""),
                                    "vt 0.75 1\n", "vt 0.75 1\nvt 0.9 0.9\n");
  CHECK(text_of(result.file) == expected);
}

TEST_CASE("merge: data that both sides changed, differently, are conflicts by kind, and OUT has the preferred side's") {
  const MeshFile base = obj(kStrip);
  const MeshFile ours = obj(with(with(kStrip, "vt 0.5 0\n", "vt 0.5 0.1\n"), "usemtl cloth", "usemtl silk"));
  const MeshFile theirs = obj(with(with(kStrip, "vt 0.5 0\n", "vt 0.5 0.2\n"), "usemtl cloth", "usemtl wool"));
  for (const Side prefer : {Side::Ours, Side::Theirs}) {
    const Merged result = merged(base, ours, theirs, prefer);
    CHECK(result.report.values.size() == 2);
    CHECK(conflict(result, "usemtl").count == 2);
    CHECK(conflict(result, "usemtl").first == std::vector<std::uint32_t>{2, 3});
    CHECK(conflict(result, "texture coordinates").count == 2);
    const std::string text = text_of(result.file);
    CHECK((text.find("usemtl silk") != std::string::npos) == (prefer == Side::Ours));
    CHECK((text.find("vt 0.5 0.1") != std::string::npos) == (prefer == Side::Ours));
    CHECK((text.find("vt 0.5 0.2") != std::string::npos) == (prefer == Side::Theirs));
  }
}

TEST_CASE("merge: new faces of THEIRS stand at the end of their object, with their groups and materials") {
  const MeshFile base = obj(kStrip);
  const MeshFile ours = obj(with(kStrip, "v 4 1 0\n", "v 4 1.5 0\n"));
  // A quad more on the left, before the object on the right.
  std::string more = with(kStrip, "v 4 1 0\n", "v 4 1 0\nv -1 0 0\nv -1 1 0\n");
  more = with(more, "vt 1 1\n", "vt 1 1\nvt -1 0\nvt -1 1\n");
  const MeshFile theirs = obj(with(more, "o right\n", "f 11/11 1/1 6/6 12/12\no right\n"));
  const Merged result = merged(base, ours, theirs);
  CHECK(result.report.clean());
  CHECK(text_of(result.file) == with(text_of(theirs), "v 4 1 0\n", "v 4 1.5 0\n"));
}

TEST_CASE("merge: PLY properties of vertices and faces are merged element by element, and stored as before") {
  const MeshFile base = parsed(kPly, Format::Ply);
  const std::string text(kPly);
  const MeshFile ours = parsed(with(text, "0 0 0 0\n", "0 0 0 77\n"), Format::Ply);
  const MeshFile theirs = parsed(with(with(text, "2 300 0\n", "2 -9 0\n"), "8 0 0 1 0", "8 0.5 0 1 0"), Format::Ply);
  const Merged result = merged(base, ours, theirs);
  CHECK(result.report.clean());
  const MeshFile expected =
      parsed(with(with(with(text, "2 300 0\n", "2 -9 0\n"), "8 0 0 1 0", "8 0.5 0 1 0"), "0 0 0 0\n", "0 0 0 77\n"),
             Format::Ply);
  CHECK(format_mesh(result.file, Format::Ply) == format_mesh(expected, Format::Ply));
}

TEST_CASE("merge: data that a side dropped are gone, unless the other side changed them") {
  const MeshFile base = parsed(kPly, Format::Ply);
  MeshFile without = base;
  std::erase_if(without.properties, [](const Property& property) { return property.name == "red"; });
  const MeshFile brighter = parsed(with(std::string(kPly), "1 0 0 10\n", "1 0 0 99\n"), Format::Ply);
  MeshFile elsewhere = parsed(with(std::string(kPly), "2 0 0.1 40\n", "2 0 0.7 40\n"), Format::Ply);
  const auto has_red = [](const Merged& result) {
    return std::any_of(result.file.properties.begin(), result.file.properties.end(),
                       [](const Property& property) { return property.name == "red"; });
  };
  const Merged gone = merged(base, elsewhere, without);
  CHECK(gone.report.clean());
  CHECK_FALSE(has_red(gone));
  const Merged kept = merged(base, brighter, without);
  CHECK(conflict(kept, "red").count == 1);
  CHECK(has_red(kept));
  CHECK_FALSE(has_red(merged(base, brighter, without, Side::Theirs)));
}

TEST_CASE("merge: lines that name vertices follow them, and are left out with a note where those are gone") {
  const std::string lines = "l 1 2\np 10\n";
  const MeshFile base = obj(kStrip + lines);
  // OURS: without the first face, so vertices 1 and 6 are gone; THEIRS moved something.
  std::string less = with(kStrip + lines, "f 1/1 2/2 7/7 6/6\n", "");
  const MeshFile ours = obj(less), theirs = obj(with(kStrip + lines, "v 4 1 0\n", "v 4 2 0\n"));
  const Merged result = merged(base, ours, theirs);
  CHECK(result.report.clean());
  CHECK(result.file.carried.size() == 2);  // OURS kept both, and vertex 1 for its line
  CHECK(find_isomorphism(result.file.mesh, ours.mesh, IsomorphismKind::Preserving).isomorphism.has_value());
}

TEST_CASE("merge: meshes with no part in common are refused, unless a side left all faces as they were") {
  const MeshFile base = bare(shapes::grid(4, 3)), cube = bare(shapes::cube()), prism = bare(shapes::prism(5));
  const Expected<Merged> nothing = try_merge(base, prism, cube);
  REQUIRE_FALSE(nothing.has_value());
  CHECK(nothing.error().code == ErrorCode::BadArgument);
  CHECK(nothing.error().message.find("no part in common") != std::string::npos);
  CHECK(text_of(merged(base, cube, base).file) == text_of(cube));
}

TEST_CASE("merge: a match that is not sound is refused") {
  const MeshFile base = bare(shapes::bear().soup);
  Match wrong = match_side(base.mesh, base.mesh);
  wrong.regions.front().faces[5].rotation = 1;
  const Expected<Merged> result = merge(base, base, base, match_side(base.mesh, base.mesh), wrong);
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().code == ErrorCode::MatchDoesNotFit);
}

TEST_CASE("merge: a doubtful part is named where the other side changed something in it, and only there") {
  // Two cubes that only positions tell apart, and those are of no use; beside them a bear.
  const PolygonSoup bear = shapes::bear().soup;
  const PolygonSoup all = shapes::disjoint_union({bear, shapes::cube(), shapes::cube()});
  const MeshFile base = bare(all);
  PolygonSoup scrambled = all;
  for (std::uint32_t v = bear.vertex_count; v < all.vertex_count; ++v) {
    scrambled.positions[v] = {1.0 / v, (v % 5) * 3.0, (v % 3) * 2.0};
  }
  const MeshFile ours = bare(shapes::renumbered(scrambled, 2).soup);
  const auto cut = shapes::delete_patch(all, FaceId(base.mesh.face_count() - 1), 1);
  const auto away = shapes::delete_patch(all, FaceId(500), 8);
  REQUIRE((cut.has_value() && away.has_value()));
  CHECK(merged(base, ours, bare(away->soup)).report.doubtful.empty());
  const Merged result = merged(base, ours, bare(cut->soup));
  REQUIRE(result.report.doubtful.size() == 1);
  CHECK(result.report.doubtful[0].side == Side::Ours);
  CHECK(result.report.doubtful[0].ambiguous);
  CHECK(result.report.doubtful[0].faces == 6);
}

TEST_CASE("merge: a match with mirrored regions is taken without them") {
  const MeshFile base = bare(shapes::bear().soup);
  PolygonSoup mirrored = shapes::bear().soup;
  for (Point& point : mirrored.positions) point[0] = -point[0];
  for (std::size_t f = 0; f < mirrored.corners.size(); f += 4) {
    std::reverse(mirrored.corners.begin() + static_cast<std::ptrdiff_t>(f),
                 mirrored.corners.begin() + static_cast<std::ptrdiff_t>(f + 4));
  }
  const MeshFile theirs = bare(mirrored);
  MatchOptions reversing;
  reversing.orientation = OrientationChoice::Reversing;
  const Match turned = match(base.mesh, theirs.mesh, reversing).match;
  const Expected<Merged> result = merge(base, base, theirs, match_side(base.mesh, base.mesh), turned);
  REQUIRE(result.has_value());
  CHECK(text_of(result->file) == text_of(theirs));
}

TEST_CASE("merge: the same files in the same order give the same bytes, and sides may be exchanged") {
  const PolygonSoup soup = shapes::bear().soup;
  const MeshFile base = bare(soup);
  const MeshFile ours = bare(shapes::renumbered(shapes::extrude_patch(soup, FaceId(40), 6, 0.1)->soup, 1).soup);
  const MeshFile theirs = bare(shapes::renumbered(shapes::delete_patch(soup, FaceId(2000), 9)->soup, 2).soup);
  const Merged one = merged(base, ours, theirs), again = merged(base, ours, theirs), other = merged(base, theirs, ours);
  CHECK(one.report.clean());
  CHECK((text_of(one.file) == text_of(again.file)));
  CHECK(find_isomorphism(one.file.mesh, other.file.mesh, IsomorphismKind::Preserving).isomorphism.has_value());
}
