#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

TEST_CASE("symmetry says how many mirrors a cube has, and its map is a sound match of the cube with itself") {
  const Folder folder;
  folder.write("cube.obj", shapes::renumbered(shapes::cube_subdivided(8), 5).soup);
  const Outcome outcome = folder.run({"symmetry", "cube.obj", "-o", "map.json"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "mesh         cube.obj: 384 faces, 386 vertices, wholly symmetric\n"));
  CHECK(contains(outcome.out, "mirrors      9 fit as well as each other"));
  CHECK(contains(outcome.out, "pairs        192 of faces, 177 of vertices\n"));
  CHECK(contains(outcome.out, "centre line  32 vertices, 32 edges along it; it crosses 0 edges and 0 faces\n"));
  CHECK(contains(outcome.out, "written      map.json\n"));
  CHECK(folder.run({"verify", "cube.obj", "cube.obj", "map.json"}).status == 0);
  const Json map = Json::parse(folder.read("map.json"));
  CHECK(map["format"] == "quadmatch.match/1");
  CHECK(map["symmetry"]["mirrors"] == 9);
  CHECK(map["symmetry"]["centre_line"]["vertices"].size() == 32);
  CHECK(map["symmetry"]["unpaired"]["faces"].empty());
  CHECK(map["vertices"].size() == 386);
}

TEST_CASE("symmetry names what has no mirror image and where it is, and the status says so") {
  const Folder folder;
  folder.write("bear.obj", shapes::bear().soup);
  const Outcome outcome = folder.run({"symmetry", "bear.obj", "-o", "-"});
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.err, "no partner   "));
  CHECK(contains(outcome.err, "on the +x side from f"));
  CHECK(contains(outcome.err, "nothing opposite is connected like this\n"));
  const Json map = Json::parse(outcome.out);
  const Outcome figures = folder.run({"symmetry", "bear.obj", "--json"});
  CHECK(figures.status == 1);
  const Json report = Json::parse(figures.out);
  CHECK(report["whole"] == false);
  CHECK(report["unpaired_faces"] == map["symmetry"]["unpaired"]["faces"].size());
  std::size_t lonely = 0;
  for (const Json& area : report["unpaired_areas"]) lonely += area["faces"].get<std::size_t>();
  CHECK(report["unpaired_faces"] == lonely);
}

TEST_CASE("symmetrize writes the mesh with one side copied, in place too, and the figures say how far it moved") {
  const Folder folder;
  PolygonSoup soup = shapes::star(3, 4);
  for (Point& p : soup.positions) p[2] = p[0] > 1.5 && p[1] > 0 ? 0.01 : 0;
  folder.write("a.obj", soup);
  const Outcome outcome =
      folder.run({"symmetry", "a.obj", "--symmetrize", "a.obj", "--from", "-y", "-o", "map.json", "--json"});
  CHECK(outcome.err.empty());
  CHECK(outcome.status == 0);
  const Json report = Json::parse(outcome.out);
  CHECK(report["symmetrized"]["moved"] > 0);
  CHECK(report["symmetrized"]["farthest"].get<double>() == doctest::Approx(0.01).epsilon(0.05));
  const auto result = read_mesh(folder.path("a.obj"));
  REQUIRE(result.has_value());
  for (const Point& p : result->mesh.positions()) CHECK(p[2] == doctest::Approx(0).epsilon(0.001));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "map.json"});
}

TEST_CASE("symmetry refuses what makes no sense, in one line, and writes nothing") {
  const Folder folder;
  folder.write("cube.obj", shapes::cube_subdivided(4));
  folder.write("posed.obj", shapes::bear({.pose = {.left_arm = 0.2, .left_leg = 0.2, .body_bend = 0.25}}).soup);
  const auto refused = [&](std::vector<std::string> arguments, std::string_view why) {
    arguments.insert(arguments.begin(), "symmetry");
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(line_count(outcome.err) == 1);
    CHECK_MESSAGE(contains(outcome.err, why), outcome.err);
  };
  refused({"cube.obj", "--symmetrize", "o.obj"}, "needs --from");
  refused({"cube.obj", "--from", "+x"}, "does not say where to");
  refused({"cube.obj", "--only", "uv"}, "does not say where to");
  refused({"cube.obj", "--symmetrize", "o.obj", "--from", "left"}, "left");
  refused({"cube.obj", "--symmetrize", "o.txt", "--from", "+x"}, "does not tell the format");
  refused({"cube.obj", "-o", "cube.obj"}, "would be overwritten");
  refused({"cube.obj", "-o", "x.obj", "--symmetrize", "x.obj", "--from", "+x"}, "same place");
  refused({"cube.obj", "-o", "-", "--json"}, "standard output");
  refused({"cube.obj", "--symmetrize", "o.obj", "--from", "+z"}, "choose the axis across the mirror");
  refused({"cube.obj", "--symmetrize", "o.obj", "--from", "+x", "--only", "uv"}, "none of the data");
  refused({"posed.obj", "--symmetrize", "o.obj", "--from", "+x", "-o", "m.json"}, "the model is posed");
  refused({"no.obj"}, "no.obj");
  CHECK(folder.names() == std::vector<std::string>{"cube.obj", "posed.obj"});
}
