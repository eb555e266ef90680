// The program that edits meshes: what it writes is a mesh, and what it says survived is found again.

#include <doctest/doctest.h>

#include <set>

#include <nlohmann/json.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

TEST_CASE("edit_mesh: a renumbered mesh with a hole, and quadmatch finds what its truth says") {
  const Folder folder;
  folder.write("a.obj", shapes::star(5, 6));
  const Outcome outcome =
      folder.edit_mesh({"a.obj", "b.obj", "delete:7", "renumber", "--truth", "t.json", "--seed", "4"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err == "173 faces, of which 173 survive\n");
  CHECK(folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--quiet"}).status == 0);
  const Json truth = Json::parse(folder.read("t.json"));
  CHECK(truth.at("orientation") == "preserving");
  const Json match = Json::parse(folder.read("m.json"));
  std::set<Json> found;
  for (const Json& region : match.at("regions")) {
    for (const Json& pair : region.at("faces")) found.insert(pair);
  }
  const std::set<Json> asked(truth.at("exact").begin(), truth.at("exact").end());
  CHECK(asked.size() == 173);
  CHECK((found == asked));  // in brackets: nobody wants to read all of it
}

TEST_CASE("edit_mesh: the same seed writes the same bytes, and its help names every edit") {
  const Folder folder;
  folder.write("a.obj", shapes::sphere(5));
  for (const char* name : {"b.obj", "c.obj"}) {
    CHECK(folder.edit_mesh({"a.obj", name, "loop", "rip:3", "twist", "renumber", "--seed", "9"}).status == 0);
  }
  CHECK(folder.read("b.obj") == folder.read("c.obj"));
  const Outcome help = folder.edit_mesh({"--help"});
  CHECK(help.status == 0);
  for (const char* name : {"delete:20", "extrude:12", "collapse:3", "rip:6", "refine:9", "loop:1", "unloop:1",
                           "twist:1", "handle:1", "subdivide:1", "renumber:1"}) {
    CHECK(contains(help.out, name));
  }
}

TEST_CASE("edit_mesh: what cannot be done is said in a line, and nothing is written") {
  const Folder folder;
  folder.write("a.obj", shapes::grid(3, 3));
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"a.obj", "b.obj", "lop"}, {"a.obj", "b.obj", "twist"}, {"a.obj", "b.obj"}, {"c.obj", "b.obj", "loop"}}) {
    const Outcome outcome = folder.edit_mesh(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK_FALSE(outcome.err.empty());
    CHECK_FALSE(folder.has("b.obj"));
  }
  CHECK(folder.edit_mesh({"a.obj", "b.obj", "twist"}).err ==
        "edit_mesh: twist does not fit: the row of quads is no ring\n");
}
