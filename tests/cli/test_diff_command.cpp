#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// Four quads in the shape of an S, or of its mirror image, a Z.
constexpr const char* kS =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\nv 1 2 0\nv 2 2 0\nv 3 2 0\n"
    "f 1 2 5 4\nf 2 3 6 5\nf 5 6 9 8\nf 6 7 10 9\n";
constexpr const char* kZ =
    "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 3 1 0\nv 1 2 0\nv 2 2 0\nv 3 2 0\n"
    "f 4 5 2 1\nf 5 6 3 2\nf 8 9 6 5\nf 9 10 7 6\n";

std::vector<std::string> diff(const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"diff", "a.obj", "b.obj", "--isomorphic"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

}  // namespace

TEST_CASE("diff --isomorphic calls a renumbered mesh the same, counts the maps, and writes one that verifies") {
  const Folder folder;
  folder.write("a.obj", shapes::star(5, 3));
  folder.write("b.obj", shapes::renumbered(shapes::star(5, 3), 1).soup);
  const Outcome outcome = folder.run(diff({"-o", "map.json"}));
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "the same\n"
        "  map          45 faces, 61 vertices, in 1 component\n"
        "  orientation  preserving\n"
        "  ways         one of 5 maps\n"
        "  written      map.json\n");
  CHECK(folder.run({"verify", "a.obj", "b.obj", "map.json"}).status == 0);
}

TEST_CASE("diff --isomorphic says in what meshes are different, writes nothing, and exits with 1") {
  const Folder folder;
  folder.write("a.obj", shapes::many_components(12));
  folder.write("b.obj", shapes::many_components(11));
  const Outcome outcome = folder.run(diff({"-o", "map.json"}));
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "different\n"
        "  the source has 96 vertices, the target 88\n"
        "  the source has 72 faces, the target 66\n"
        "  the source has 72 faces of 4 corners, the target 66\n"
        "  the source has 12 components of 6 faces, the target 11\n"
        "  the source has 96 fans of valence 3, the target 88\n");
  CHECK_FALSE(folder.has("map.json"));
}

TEST_CASE("diff --isomorphic tells a mirror image by the orientation of the map") {
  const Folder folder;
  folder.write("a.obj", kS);
  folder.write("b.obj", kZ);
  CHECK(folder.run(diff({"--orientation", "preserving"})).status == 1);
  CHECK(folder.run(diff({"--orientation", "reversing", "-o", "map.json"})).status == 0);
  CHECK(folder.run({"verify", "a.obj", "b.obj", "map.json"}).status == 0);
  const Outcome outcome = folder.run(diff({}));
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "  orientation  reversing\n"));
  CHECK(contains(outcome.out, "  ways         one of 2 maps\n"));
  folder.write("b.obj", kS);
  CHECK(folder.run(diff({"--orientation", "reversing"})).status == 1);
}

TEST_CASE("diff --isomorphic --json gives the number of maps, or the differences") {
  const Folder folder;
  folder.write("a.obj", shapes::many_components(30));
  folder.write("b.obj", shapes::renumbered(shapes::many_components(30), 4).soup);
  const Outcome same = folder.run(diff({"--json"}));
  CHECK(same.status == 0);
  const Json json = Json::parse(same.out);
  CHECK(json.at("isomorphic") == true);
  CHECK(json.at("orientation") == "preserving");
  CHECK(json.at("ways").at("number").is_null());
  CHECK(json.at("ways").at("product") == "24^30 * 30!");
  CHECK(json.at("ways").at("log10").get<double>() == doctest::Approx(73.8300032));
  CHECK(json.at("components") == 30);
  CHECK(json.at("differences").empty());
  CHECK(contains(folder.run(diff({})).out, "one of 24^30 * 30! maps, a number of 74 digits\n"));

  folder.write("b.obj", shapes::cube());
  const Json different = Json::parse(folder.run(diff({"--json"})).out);
  CHECK(different.at("isomorphic") == false);
  CHECK(different.at("differences").at(0) == "the source has 240 vertices, the target 8");
}

TEST_CASE("diff --isomorphic --quiet only sets the exit status, and is in trouble where a mesh is missing") {
  const Folder folder;
  folder.write("a.obj", shapes::book());
  folder.write("b.obj", shapes::renumbered(shapes::book(), 2).soup);
  const Outcome same = folder.run(diff({"--quiet"}));
  CHECK(same.status == 0);
  CHECK(same.out.empty());
  CHECK(same.err.empty());
  folder.write("b.obj", shapes::bow_tie());
  CHECK(folder.run(diff({"--quiet"})).status == 1);
  CHECK(folder.run({"diff", "a.obj", "absent.obj", "--isomorphic", "--quiet"}).status == 2);
}

TEST_CASE("check --hash prints the same hash for a renumbered mesh, and both hashes of a chiral one") {
  const Folder folder;
  folder.write("a.obj", kS);
  folder.write("b.obj", kZ);
  folder.write("cube.obj", shapes::cube());
  folder.write("turned.obj", shapes::renumbered(shapes::cube(), 9).soup);
  const Outcome outcome = folder.run({"check", "a.obj", "b.obj", "cube.obj", "turned.obj", "--hash", "--json"});
  CHECK(outcome.status == 0);
  const Json reports = Json::parse(outcome.out);
  const auto hash = [&reports](std::size_t k, const char* which) {
    return reports.at(k).at("hash").at(which).get<std::string>();
  };
  CHECK(hash(0, "oriented") != hash(1, "oriented"));
  CHECK(hash(0, "unoriented") == hash(1, "unoriented"));
  CHECK(hash(2, "oriented") == hash(3, "oriented"));
  CHECK(hash(2, "oriented") == hash(2, "unoriented"));
  CHECK(hash(2, "oriented").size() == 40);
  const std::string text = folder.run({"check", "a.obj", "--hash"}).out;
  CHECK(contains(text, "  hash            " + hash(0, "oriented") + ", oriented\n"));
  CHECK(contains(text, hash(0, "unoriented") + ", unoriented\n"));
  CHECK(contains(folder.run({"check", "cube.obj", "--hash"}).out, "the mesh is its own mirror image"));
  CHECK_FALSE(contains(folder.run({"check", "cube.obj"}).out, "hash"));
}
