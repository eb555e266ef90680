#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// a.obj: a shirt; same.obj: renumbered; cut.obj: twelve faces of it are missing, and it is renumbered.
void write_shirts(const Folder& folder) {
  const PolygonSoup shirt = shapes::shirt(shapes::Sleeves::Short).soup;
  folder.write("a.obj", shirt);
  folder.write("same.obj", shapes::renumbered(shirt, 3).soup);
  const Expected<shapes::Edit> edit = shapes::delete_patch(shirt, FaceId(600), 12);
  REQUIRE(edit.has_value());
  folder.write("cut.obj", shapes::renumbered(edit->soup, 4).soup);
}

/// All but the line with times.
std::string without_time(const std::string& text) {
  const std::size_t at = text.find("\n  time");
  return at == std::string::npos ? text : text.substr(0, at + 1) + text.substr(text.find('\n', at + 1) + 1);
}

}  // namespace

TEST_CASE("diff says that a renumbered copy has no differences, and exits with 0") {
  const Folder folder;
  write_shirts(folder);
  const Outcome outcome = folder.run({"diff", "a.obj", "same.obj"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(without_time(outcome.out) ==
        "no differences\n"
        "  source    a.obj: 1,432 faces, 1,476 vertices\n"
        "  target    same.obj: 1,432 faces, 1,476 vertices\n"
        "  faces     1,432 the same\n"
        "  vertices  1,476 the same\n");
  CHECK(folder.run({"diff", "a.obj", "same.obj", "--stat"}).out ==
        "changes=0 faces_added=0 faces_removed=0 faces_rejoined=0 faces_turned=0 vertices_added=0 vertices_removed=0 "
        "vertices_moved=0 kinds=\n");
}

TEST_CASE("diff names a change with its size and elements, in text, in one line and as JSON, and exits with 1") {
  const Folder folder;
  write_shirts(folder);
  const Outcome outcome = folder.run({"diff", "a.obj", "cut.obj"});
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "different\n"));
  CHECK(contains(outcome.out, "  faces     1,420 the same, 12 removed\n"));
  CHECK(contains(outcome.out, "  deletion  12 faces removed: f"));

  const Outcome stat = folder.run({"diff", "a.obj", "cut.obj", "--stat"});
  CHECK(stat.status == 1);
  CHECK(line_count(stat.out) == 1);
  CHECK(contains(stat.out, "changes=1 faces_added=0 faces_removed=12 faces_rejoined=0 "));
  CHECK(contains(stat.out, " kinds=deletion:1\n"));

  const Outcome machine = folder.run({"diff", "a.obj", "cut.obj", "--json"});
  CHECK(machine.status == 1);
  const Json json = Json::parse(machine.out);
  CHECK(json.at("same") == false);
  CHECK(json.at("totals").at("faces").at("removed") == 12);
  REQUIRE(json.at("changes").size() == 1);
  const Json& change = json.at("changes").at(0);
  CHECK(change.at("kind") == "deletion");
  CHECK(change.at("source_faces").size() == 12);
  CHECK(change.at("source_faces").at(0).is_number());
  CHECK(change.at("target_faces").empty());
  CHECK(json.at("moved").empty());
}

TEST_CASE("diff tells moved vertices as a difference, unless positions are ignored") {
  const Folder folder;
  const PolygonSoup bear = shapes::bear().soup;
  folder.write("a.obj", bear);
  folder.write("posed.obj", shapes::bear({.pose = {.left_arm = 0.2}}).soup);
  PolygonSoup turned = bear;
  for (Point& p : turned.positions) p = {p[0], -p[2], p[1]};
  folder.write("turned.obj", turned);
  const Outcome posed = folder.run({"diff", "a.obj", "posed.obj"});
  CHECK(posed.status == 1);
  CHECK(contains(posed.out, "  faces     2,944 the same\n"));
  CHECK(contains(posed.out, " of them moved\n"));
  CHECK_FALSE(contains(posed.out, "motion"));
  CHECK(folder.run({"diff", "a.obj", "posed.obj", "--ignore-positions", "--quiet"}).status == 0);
  const Outcome whole = folder.run({"diff", "a.obj", "turned.obj"});
  CHECK(whole.status == 1);
  CHECK(contains(whole.out, "  motion    the whole moved as one body: turned by 90.0 degrees"));
  CHECK(folder.run({"diff", "a.obj", "posed.obj", "--tolerance", "1"}).status == 0);
}

TEST_CASE("diff takes a match file of these meshes and refuses one of others or one that is not sound") {
  const Folder folder;
  write_shirts(folder);
  REQUIRE(folder.run({"match", "a.obj", "cut.obj", "-o", "m.json", "--quiet"}).status == 0);
  const Outcome given = folder.run({"diff", "a.obj", "cut.obj", "--match", "m.json", "--stat"});
  CHECK(given.status == 1);
  CHECK(given.out == folder.run({"diff", "a.obj", "cut.obj", "--stat"}).out);

  const Outcome other = folder.run({"diff", "a.obj", "same.obj", "--match", "m.json"});
  CHECK(other.status == 2);
  CHECK(other.out.empty());
  CHECK(line_count(other.err) == 1);
  CHECK(contains(other.err, "m.json"));

  folder.write("wrong.json",
               R"({"format": "quadmatch.match/1", "source": {"path": "a.obj", "vertices": 1476, "faces": 1432},
                   "target": {"path": "same.obj", "vertices": 1476, "faces": 1432},
                   "regions": [{"orientation": "preserving", "faces": [[0, 0, 0], [700, 700, 0]]}], "vertices": []})");
  const Outcome unsound = folder.run({"diff", "a.obj", "same.obj", "--match", "wrong.json"});
  CHECK(unsound.status == 2);
  CHECK(contains(unsound.err, "quadmatch: wrong.json: the match is not sound for these meshes"));
}

TEST_CASE("diff is in trouble where options contradict each other or a mesh is missing") {
  const Folder folder;
  write_shirts(folder);
  const auto refused = [&](const std::vector<std::string>& more, const char* why) {
    std::vector<std::string> arguments{"diff"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = folder.run(arguments);
    CAPTURE(outcome.err);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(line_count(outcome.err) == 1);
    CHECK(contains(outcome.err, why));
  };
  refused({}, "A is required");
  refused({"a.obj"}, "B is required");
  refused({"a.obj", "absent.obj"}, "absent.obj: there is no such file");
  refused({"a.obj", "same.obj", "-o", "m.json"}, "-o writes the map of --isomorphic");
  refused({"a.obj", "same.obj", "--isomorphic", "--stat"}, "--stat is about comparing part by part");
  refused({"a.obj", "same.obj", "--json", "--stat"}, "--json and --stat");
  refused({"a.obj", "same.obj", "--match", "m.json", "--no-positions"}, "--no-positions is about matching");
  refused({"-", "-"}, "standard input (-) can be read only once");
  CHECK_FALSE(folder.has("m.json"));
}

TEST_CASE("diff names regions that could lie otherwise") {
  const Folder folder;
  PolygonSoup rings = shapes::star(5, 3);
  folder.write("a.obj", rings);
  for (Point& p : rings.positions) p = {p[1] * p[1], p[0] + 3 * p[1], p[0] * p[1]};
  folder.write("b.obj", shapes::renumbered(rings, 2).soup);
  const Outcome outcome = folder.run({"diff", "a.obj", "b.obj", "--no-positions", "--ignore-positions"});
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "  doubt     45 faces from f"));
  CHECK(contains(outcome.out, "one of 5 ways to lay them"));
}
