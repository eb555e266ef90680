// --anchor in all its forms, and what it says to one that cannot be.

#include <doctest/doctest.h>

#include <quadmatch/io/match_file.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include <fmt/format.h>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

/// Match two files from an anchor; the regions found.
std::vector<Region> regions(const Folder& folder, const std::vector<std::string>& options) {
  std::vector<std::string> arguments{"match",  "a.obj",   "b.obj",       "-o",
                                     "m.json", "--quiet", "--algorithm", "lazy-greedy"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = folder.run(arguments);
  CHECK(outcome.err.empty());
  REQUIRE(outcome.status == 0);
  return parse_match(folder.read("m.json"), "m.json")->match.regions;
}

PolygonSoup turned_over(PolygonSoup soup) {
  for (std::size_t f = 0; f < soup.corners.size(); f += 4) std::swap(soup.corners[f + 1], soup.corners[f + 3]);
  return soup;
}

/// Twelve quads in the plane, four across.
PolygonSoup plate() { return shapes::grid(4, 3); }

}  // namespace

TEST_CASE("--anchor F:C=G:D seeds the growth with these corners") {
  const Folder folder;
  folder.write("a.obj", shapes::torus(5, 4));
  folder.write("b.obj", shapes::torus(5, 4));
  const std::vector<Region> found = regions(folder, {"--anchor", "3:1=7:1"});
  REQUIRE(found.size() == 1);
  CHECK(found[0].faces.size() == 20);
  CHECK(found[0].faces[0] == FacePair{FaceId(3), FaceId(7), 0});
}

TEST_CASE("--anchor A-B=C-D lays edge on edge, by the faces to their left") {
  // Vertex (i, j) of the plate is 5j + i; the edge 6-7 is the lower side of quad (1, 1), number 5.
  const Folder folder;
  folder.write("a.obj", plate());
  folder.write("b.obj", plate());
  const std::vector<Region> same = regions(folder, {"--anchor", "6-7=6-7"});
  CHECK(same[0].faces[0] == FacePair{FaceId(5), FaceId(5), 0});
  CHECK(same[0].faces.size() == 12);
  const std::vector<Region> shifted = regions(folder, {"--anchor", "6-7=7-8", "--orientation", "preserving"});
  CHECK(shifted[0].faces[0] == FacePair{FaceId(5), FaceId(6), 0});
}

TEST_CASE("--anchor A-B=C-D falls back on the faces to the right where one edge has none to its left") {
  const Folder folder;
  folder.write("a.obj", plate());
  folder.write("b.obj", plate());
  const std::vector<Region> found = regions(folder, {"--anchor", "1-0=1-0"});  // quad 0 lies right of 1-0
  CHECK(found[0].faces[0] == FacePair{FaceId(0), FaceId(0), 0});
}

TEST_CASE("--anchor A-B=C-D means the face on the other side when the target is a mirror image") {
  const Folder folder;
  folder.write("a.obj", plate());
  folder.write("b.obj", turned_over(plate()));
  for (const char* anchor : {"6-7=6-7", "0-1=0-1", "7-6=7-6"}) {
    CAPTURE(anchor);
    const std::vector<Region> found = regions(folder, {"--anchor", anchor, "--orientation", "reversing"});
    CHECK(found[0].orientation == Orientation::Reversing);
    CHECK(found[0].faces.size() == 12);
    for (const FacePair& pair : found[0].faces) CHECK(pair.source == pair.target);
  }
}

TEST_CASE("with an anchor, --orientation auto keeps the larger of both ways round") {
  const Folder folder;
  folder.write("a.obj", shapes::star(5, 3));
  folder.write("b.obj", turned_over(shapes::star(5, 3)));
  folder.write("c.obj", shapes::star(5, 3));
  const std::vector<Region> mirrored = regions(folder, {"--anchor", "0-1=0-1"});
  CHECK(mirrored[0].faces.size() == 45);
  const Outcome same = folder.run({"match", "a.obj", "c.obj", "-o", "m.json", "--anchor", "0=0"});
  CHECK(contains(same.out, "all matched"));
  CHECK(contains(same.out, ", as given"));
}

TEST_CASE("--anchor A=B finds the alignment in which most neighbours look alike") {
  const PolygonSoup soup = plate();
  const Folder folder;
  folder.write("a.obj", soup);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    const shapes::Renumbered copy = shapes::renumbered(soup, seed);
    folder.write("b.obj", copy.soup);
    for (const std::uint32_t v : {0U, 1U, 6U, 8U}) {  // a corner, a side, and inside, near corners
      CAPTURE(v);
      const std::vector<Region> found = regions(folder, {"--orientation", "preserving", "--anchor",
                                                         fmt::format("{}={}", v, copy.vertices[VertexId(v)].value)});
      CHECK(found[0].faces.size() == 12);
    }
  }
}

TEST_CASE("--anchor A=B finds the alignment in a mirror image") {
  const Folder folder;
  folder.write("a.obj", plate());
  folder.write("b.obj", turned_over(plate()));
  for (const std::uint32_t v : {0U, 1U, 6U, 8U, 19U}) {
    CAPTURE(v);
    const std::vector<Region> found =
        regions(folder, {"--orientation", "reversing", "--anchor", fmt::format("{}={}", v, v)});
    CHECK(found[0].faces.size() == 12);
  }
}

TEST_CASE("of several anchors the first that fits is taken") {
  const Folder folder;
  folder.write("a.obj", shapes::torus(5, 4));
  folder.write("b.obj", shapes::torus(5, 4));
  const std::vector<Region> found = regions(folder, {"--anchor", "3:0=7:0", "--anchor", "1:0=1:0"});
  CHECK(found[0].faces[0] == FacePair{FaceId(3), FaceId(7), 0});
}

TEST_CASE("an anchor that cannot be is named, with what it could be") {
  struct Case {
    std::string anchor, complaint;
  };
  const std::string form =
      "this is no anchor; write face:corner=face:corner, vertex-vertex=vertex-vertex or vertex=vertex, counted from 0";
  const std::vector<Case> cases{
      {"nonsense", form},
      {"1=", form},
      {"1:2", form},
      {"1:0=1-2", form},
      {"1.5:0=1:0", form},
      {"1:0=99999999999:0", form},
      {"12:0=0:0", "a.obj has no face 12; its faces are 0 to 11"},
      {"0:4=0:0", "face 0 of a.obj has no corner 4; its corners are 0 to 3"},
      {"0:0=9:0", "b.obj has no face 9; its faces are 0 to 5"},
      {"0:0=0:5", "face 0 of b.obj has no corner 5; its corners are 0 to 3"},
      {"0-99=0-1", "a.obj has no vertex 99; its vertices are 0 to 19"},
      {"0-7=0-1", "a.obj has no edge between the vertices 0 and 7"},
      {"0-1=0-9", "b.obj has no edge between the vertices 0 and 9"},
      {"0=99", "b.obj has no vertex 99; its vertices are 0 to 12"},
      {"0=12", "vertex 0 of a.obj or vertex 12 of b.obj belongs to no face; choose another"},
  };
  const Folder folder;
  folder.write("a.obj", plate());
  folder.write("b.obj", obj_of(shapes::grid(3, 2)) + "v 9 9 9\n");
  for (const Case& wrong : cases) {
    CAPTURE(wrong.anchor);
    const Outcome outcome =
        folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--quiet", "--anchor", wrong.anchor});
    CHECK(outcome.status == 2);
    CHECK(outcome.err == "quadmatch: --anchor " + wrong.anchor + ": " + wrong.complaint + "\n");
  }
  CHECK_FALSE(folder.has("m.json"));
}

TEST_CASE("an anchor between faces of unequal corner counts is refused") {
  const Folder folder;
  folder.write("quad.obj", shapes::grid(1, 1));
  folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  for (const std::string anchor : {"0:0=0:0", "0-1=0-1", "0=0"}) {
    const Outcome outcome = folder.run({"match", "quad.obj", "triangle.obj", "--quiet", "--anchor", anchor});
    CHECK(outcome.status == 2);
    CHECK(outcome.err == "quadmatch: --anchor " + anchor +
                             ": the anchor lays face f0 of 4 corners on face f0 of 3; choose faces that fit\n");
  }
}
