// The program that writes shapes: sizes are what was asked for, and what it cannot make it says.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

using namespace quadmatch::test;
using Json = nlohmann::json;

TEST_CASE("make_shape: a torus of twelve by eight has 96 faces, and nothing is wrong with it") {
  const Folder folder;
  const Outcome outcome = folder.make_shape({"torus:12,8", "a.obj"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err == "96 faces\n");
  CHECK(folder.run({"check", "a.obj"}).status == 0);
}

TEST_CASE("make_shape: the truth of Fig. 4.2 is its faces in Fig. 4.1") {
  const Folder folder;
  CHECK(folder.make_shape({"fig_4_1", "a.obj"}).status == 0);
  CHECK(folder.make_shape({"fig_4_2", "b.obj", "--truth", "t.json"}).status == 0);
  const Json truth = Json::parse(folder.read("t.json"));
  CHECK(truth.at("exact").size() == 162);
  CHECK(truth.at("exact").back() == Json({164, 161, 0}));
}

TEST_CASE("make_shape: what it cannot make is said in a line, and nothing is written") {
  const Folder folder;
  for (const char* shape :
       {"torus", "torus:12", "torus:12,", "torus:12,x", "torus:2,3", "cube:4", "sphere:3,3", "sphere:0"}) {
    const Outcome outcome = folder.make_shape({shape, "a.obj"});
    CAPTURE(shape);
    CHECK(outcome.status == 2);
    CHECK(quadmatch::test::line_count(outcome.err) == 1);
  }
  CHECK(folder.make_shape({"torus:2,3", "a.obj"}).err == "make_shape: torus:2,3: the least there is is torus:3,3\n");
  CHECK(folder.make_shape({"grid:2,2", "a.obj", "--truth", "t.json"}).status == 2);
  CHECK(folder.names().empty());
}
