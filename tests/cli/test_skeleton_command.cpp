#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include <sstream>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

TEST_CASE("skeleton prints the columns of Table 5.1") {
  // A cube of 3 by 3 quads a side: its eight corners are joined by the twelve edges of the cube.
  const Folder folder;
  folder.write("cube.obj", shapes::cube_subdivided(3));
  folder.write("torus.obj", shapes::torus(5, 4));
  const Outcome outcome = folder.run({"skeleton", "cube.obj", "torus.obj"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "model      vertices  edges  skeleton vertices  skeleton edges  reduction\n"
        "cube.obj         56    108                  8              12     85.7 %\n"
        "torus.obj        20     40                  0               0    100.0 %\n");
}

TEST_CASE("a skeleton is as large in a renumbered copy") {
  const Folder folder;
  for (const PolygonSoup& soup :
       {shapes::star(5, 3), shapes::dog_toy(3, 4), shapes::grating(2, 2), shapes::hourglass()}) {
    folder.write("a.obj", soup);
    const std::string table = folder.run({"skeleton", "a.obj", "--quiet", "--json"}).out;
    folder.write("a.obj", shapes::renumbered(soup, 5).soup);
    CHECK(folder.run({"skeleton", "a.obj", "--quiet", "--json"}).out == table);
  }
}

TEST_CASE("skeleton counts vertices that faces use and distinct edges, as check does") {
  const Folder folder;
  for (const PolygonSoup& soup : {shapes::unused_vertices(), shapes::book(), shapes::wrongly_wound(),
                                  shapes::self_glued_face(), shapes::degenerate_face(), shapes::duplicate_faces()}) {
    folder.write("a.obj", soup);
    const Json skeleton = Json::parse(folder.run({"skeleton", "a.obj", "--json", "--quiet"}).out);
    const Json check = Json::parse(folder.run({"check", "a.obj", "--json"}).out);
    CHECK(skeleton[0].at("vertices") == check[0].at("vertices"));
    CHECK(skeleton[0].at("edges") == check[0].at("edges"));
  }
}

TEST_CASE("skeleton -o writes the arcs as lines") {
  const Folder folder;
  folder.write("cube.obj", shapes::cube_subdivided(3));
  const Outcome outcome = folder.run({"skeleton", "cube.obj", "-o", "lines.obj"});
  CHECK(outcome.status == 0);
  CHECK(line_count(outcome.out) == 2);
  std::istringstream text(folder.read("lines.obj"));
  std::size_t points = 0;
  std::size_t lines = 0;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string keyword;
    words >> keyword;
    if (keyword == "v") {
      ++points;
      continue;
    }
    REQUIRE(keyword == "l");
    ++lines;
    std::size_t corners = 0;
    for (std::size_t number = 0; words >> number; ++corners) CHECK((number >= 1 && number <= points));
    CHECK(corners == 4);  // three edges a side
  }
  CHECK(points == 8 + 12 * 2);
  CHECK(lines == 12);
}

TEST_CASE("skeleton -o - writes lines to standard output and the table to standard error") {
  const Folder folder;
  folder.write("cube.obj", shapes::cube_subdivided(2));
  const Outcome outcome = folder.run({"skeleton", "cube.obj", "-o", "-"});
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "\nl "));
  CHECK_FALSE(contains(outcome.out, "model"));
  CHECK(contains(outcome.err, "model "));
}

TEST_CASE("skeleton -o takes one mesh only") {
  const Folder folder;
  folder.write("cube.obj", shapes::cube());
  const Outcome outcome = folder.run({"skeleton", "cube.obj", "cube.obj", "-o", "lines.obj"});
  CHECK(outcome.status == 2);
  CHECK(outcome.err == "quadmatch: -o takes the lines of one mesh; name only one, or leave -o away\n");
  CHECK_FALSE(folder.has("lines.obj"));
}

TEST_CASE("skeleton --separatrices has no node at a crossing") {
  const Folder folder;
  folder.write("star.obj", shapes::star(3, 4));
  const Json skeleton = Json::parse(folder.run({"skeleton", "star.obj", "--json"}).out);
  const Outcome outcome = folder.run({"skeleton", "star.obj", "--json", "--separatrices"});
  const Json separatrices = Json::parse(outcome.out);
  CHECK(skeleton[0].at("graph") == "skeleton");
  CHECK(separatrices[0].at("graph") == "separatrices");
  CHECK(separatrices[0].at("graph_vertices") < skeleton[0].at("graph_vertices"));
  CHECK(contains(folder.run({"skeleton", "star.obj", "--separatrices"}).out, "separatrix vertices"));
}

TEST_CASE("skeleton warns of a dirty mesh, goes on after one it cannot read, and is silent when told") {
  const Folder folder;
  folder.write("book.obj", shapes::book());
  const Outcome outcome = folder.run({"skeleton", "absent.obj", "book.obj"});
  CHECK(outcome.status == 2);
  CHECK(contains(outcome.err, "quadmatch: absent.obj: "));
  CHECK(contains(outcome.err,
                 "quadmatch: warning: book.obj: 1 non-manifold edge, 2 non-manifold vertices; tracing goes on"));
  CHECK(line_count(outcome.out) == 2);
  const Outcome quiet = folder.run({"skeleton", "book.obj", "--quiet"});
  CHECK(quiet.status == 0);
  CHECK(quiet.out.empty());
  CHECK(quiet.err.empty());
}
