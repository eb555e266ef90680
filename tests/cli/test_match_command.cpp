#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/io/match_file.hpp>
#include <quadmatch/shapes/figures.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// A star of five petals and the same mesh in another order.
void write_pair(const Folder& folder) {
  const PolygonSoup star = shapes::star(5, 3);
  folder.write("a.obj", star);
  folder.write("b.obj", shapes::renumbered(star, 1).soup);
}

}  // namespace

TEST_CASE("a mesh and its renumbered copy are matched whole, and the match file verifies") {
  const Folder folder;
  write_pair(folder);
  for (const std::string algorithm : {"lazy-greedy", "greedy"}) {
    CAPTURE(algorithm);
    const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--algorithm", algorithm});
    CHECK(outcome.status == 0);
    CHECK(outcome.err.empty());
    CHECK(contains(outcome.out, "source   a.obj: 45 faces, all matched\n"));
    CHECK(contains(outcome.out, "target   b.obj: 45 faces, all matched\n"));
    CHECK(contains(outcome.out, "matched  45 faces, 61 vertices\n"));
    CHECK(contains(outcome.out, "region   45 faces, preserving; "));
    CHECK(contains(outcome.out, "anchor   corner "));
    CHECK(contains(outcome.out, "time     reading "));
    CHECK(contains(outcome.out, "written  m.json\n"));
    CHECK(folder.run({"verify", "a.obj", "b.obj", "m.json"}).status == 0);
    CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj", "m.json"});
  }
}

TEST_CASE("what is left unmatched is counted in faces and connected areas on each side") {
  const Folder folder;
  folder.write("a.obj", shapes::disjoint_union({shapes::star(5, 3), shapes::cube(), shapes::cube()}));
  folder.write("b.obj", shapes::star(5, 3));
  const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "-o", "m.json"});
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "source   a.obj: 57 faces, 78.9 % matched, 12 unmatched in 2 areas\n"));
  CHECK(contains(outcome.out, "target   b.obj: 45 faces, all matched\n"));
}

TEST_CASE("without -o the match file goes to standard output and the summary to standard error") {
  const Folder folder;
  write_pair(folder);
  const Outcome to_file = folder.run({"match", "a.obj", "b.obj", "-o", "m.json"});
  for (const std::vector<std::string>& output : {std::vector<std::string>{}, {"-o", "-"}}) {
    std::vector<std::string> arguments{"match", "a.obj", "b.obj"};
    arguments.insert(arguments.end(), output.begin(), output.end());
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.status == 0);
    CHECK(outcome.out == folder.read("m.json"));
    CHECK(contains(outcome.err, "matched  45 faces"));
    CHECK_FALSE(contains(outcome.err, "written"));
  }
}

TEST_CASE("--quiet prints nothing, and the file is the same") {
  const Folder folder;
  write_pair(folder);
  folder.run({"match", "a.obj", "b.obj", "-o", "m.json"});
  const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "-o", "quiet.json", "--quiet"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.empty());
  CHECK(folder.read("quiet.json") == folder.read("m.json"));
  const Outcome piped = folder.run({"match", "a.obj", "b.obj", "--quiet"});
  CHECK(piped.out == folder.read("m.json"));
  CHECK(piped.err.empty());
}

TEST_CASE("--json prints figures on standard output") {
  const Folder folder;
  write_pair(folder);
  const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--json"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  const Json figures = Json::parse(outcome.out);
  CHECK(figures.at("source").at("path") == "a.obj");
  CHECK(figures.at("source").at("coverage") == 1.0);
  CHECK(figures.at("target").at("unmatched_areas") == 0);
  CHECK(figures.at("matched_faces") == 45);
  CHECK(figures.at("matched_vertices") == 61);
  CHECK(figures.at("regions").size() == 1);
  CHECK(figures.at("regions").at(0).at("orientation") == "preserving");
  CHECK(figures.at("regions").at(0).at("evidence").at("agreeing") == 6);
  CHECK(figures.at("regions").at(0).at("confidence") == 1.0);
  CHECK(figures.at("regions").at(0).at("ambiguous") == false);
  CHECK(figures.at("ambiguous_faces") == 0);
  CHECK(figures.at("anchor").is_null());
  CHECK(figures.at("settings").at("algorithm") == "regions");
  CHECK(figures.at("milliseconds").at("matching").get<double>() >= 0.0);
  CHECK(figures.at("output") == "m.json");
}

TEST_CASE("--json without -o prints the figures only, and both on standard output are refused") {
  const Folder folder;
  write_pair(folder);
  const Outcome only = folder.run({"match", "a.obj", "b.obj", "--json"});
  CHECK(only.status == 0);
  CHECK(Json::parse(only.out).at("output").is_null());
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj"});
  const Outcome both = folder.run({"match", "a.obj", "b.obj", "--json", "-o", "-"});
  CHECK(both.status == 2);
  CHECK(both.out.empty());
  CHECK(both.err ==
        "quadmatch: --json and -o - would mix figures and match file on standard output; write the match to a file\n");
}

TEST_CASE("a mesh may come from standard input") {
  const Folder folder;
  write_pair(folder);
  const Outcome outcome = folder.run({"match", "-", "b.obj", "-o", "m.json"}, folder.read("a.obj"));
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "source   standard input: 45 faces, all matched\n"));
  CHECK(parse_match(folder.read("m.json"), "m.json")->source.path == "-");
}

TEST_CASE("the match file names both meshes and the settings") {
  const Folder folder;
  write_pair(folder);
  folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--rounds", "3", "--arc-lengths", "--waves"});
  const Expected<MatchFile> file = parse_match(folder.read("m.json"), "m.json");
  REQUIRE(file.has_value());
  CHECK(file->source == MatchSide{"a.obj", 61, 45});
  CHECK(file->target == MatchSide{"b.obj", 61, 45});
  const Json json = Json::parse(folder.read("m.json"));
  CHECK(json.at("settings").at("rounds") == "3");
  CHECK(json.at("settings").at("arc_lengths") == "true");
  REQUIRE(file->match.regions.size() == 1);
  REQUIRE_FALSE(file->match.regions[0].waves.empty());
  CHECK(file->match.regions[0].waves.back() == 45);
}

TEST_CASE("--without leaves out stages, remembers them, and refuses what is none") {
  const Folder folder;
  folder.write("a.obj", shapes::fig_4_1().soup);
  folder.write("b.obj", shapes::fig_4_2().soup);
  const auto figures_of = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"match", "a.obj", "b.obj", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return Json::parse(folder.run(arguments).out);
  };
  const Json all = figures_of({});
  CHECK(all.at("matched_faces") == 162);
  CHECK_FALSE(all.at("settings").contains("without"));
  // What the squeezed quads cut off is matched as a sliver, or not at all.
  const Json figures = figures_of({"--without", "slides,slivers"});
  CHECK(figures.at("matched_faces") == 157);
  CHECK(figures.at("settings").at("without") == "slides slivers");
  CHECK(figures_of({"--without", "slides", "--without", "slivers"}).at("regions") == figures.at("regions"));

  const Outcome refused = folder.run({"match", "a.obj", "b.obj", "--without", "seams,ears"});
  CHECK(refused.status == 2);
  CHECK(contains(refused.err, "ears"));
  CHECK(line_count(refused.err) == 1);
}

TEST_CASE("--orientation reversing matches a mirror image") {
  const Folder folder;
  const PolygonSoup soup = shapes::fig_4_1().soup;
  PolygonSoup mirror = soup;
  for (std::size_t f = 0; f < mirror.corners.size(); f += 4) {
    std::swap(mirror.corners[f + 1], mirror.corners[f + 3]);
  }
  folder.write("a.obj", soup);
  folder.write("b.obj", mirror);
  const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--orientation", "reversing"});
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "b.obj: " + std::to_string(soup.corners.size() / 4) + " faces, all matched\n"));
  CHECK(contains(outcome.out, "reversing"));
  CHECK(folder.run({"verify", "a.obj", "b.obj", "m.json"}).status == 0);
}

TEST_CASE("meshes with no face alike give exit status 1 and an empty match") {
  const Folder folder;
  folder.write("quad.obj", shapes::grid(1, 1));
  folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const Outcome outcome = folder.run({"match", "quad.obj", "triangle.obj", "-o", "m.json"});
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "matched  nothing\n"));
  CHECK(parse_match(folder.read("m.json"), "m.json")->match.regions.empty());
  CHECK(folder.run({"verify", "quad.obj", "triangle.obj", "m.json"}).status == 0);
  const Outcome figures = folder.run({"match", "quad.obj", "triangle.obj", "--json"});
  CHECK(figures.status == 1);
  CHECK(Json::parse(figures.out).at("anchor").is_null());
}

TEST_CASE("the same input gives the same bytes") {
  const Folder folder;
  folder.write("a.obj", shapes::fig_4_1().soup);
  folder.write("b.obj", shapes::fig_4_2().soup);
  for (const std::string algorithm : {"lazy-greedy", "greedy"}) {
    const Outcome first = folder.run({"match", "a.obj", "b.obj", "--quiet", "--algorithm", algorithm});
    const Outcome second = folder.run({"match", "a.obj", "b.obj", "--quiet", "--algorithm", algorithm});
    CHECK(first.status == 0);
    CHECK(first.out == second.out);
  }
}
