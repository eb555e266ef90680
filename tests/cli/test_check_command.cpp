#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

TEST_CASE("check prints a page of sizes for a well-formed mesh") {
  const Folder folder;
  folder.write("grid.obj", shapes::grid(4, 3));
  const Outcome outcome = folder.run({"check", "grid.obj"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "grid.obj: well-formed\n"
        "  vertices        20\n"
        "  edges           31\n"
        "  faces           12: 12 quads\n"
        "  components      1: of genus 0\n"
        "  boundary loops  1\n"
        "  extraordinary   4 vertices, 20.0 %\n");
}

TEST_CASE("check names the first departures of each kind and counts all, and exits with 1") {
  const Folder folder;
  folder.write("unused.obj", shapes::unused_vertices());
  const Outcome outcome = folder.run({"check", "unused.obj", "--list", "2"});
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  CHECK(outcome.out ==
        "unused.obj: not well-formed\n"
        "  vertices        4\n"
        "  edges           4\n"
        "  faces           1: 1 quad\n"
        "  components      1: of genus 0\n"
        "  boundary loops  1\n"
        "  extraordinary   4 vertices, 100.0 %\n"
        "  unused-vertex   6\n"
        "                    v0 belongs to no face\n"
        "                    v2 belongs to no face\n"
        "                    and 4 more\n");
  CHECK_FALSE(contains(folder.run({"check", "unused.obj", "--list", "0"}).out, "belongs"));
}

TEST_CASE("check tells components apart by genus") {
  const Folder folder;
  folder.write("parts.obj", shapes::disjoint_union({shapes::torus(4, 4), shapes::cube(), shapes::cube()}));
  CHECK(contains(folder.run({"check", "parts.obj"}).out, "components      3: 1 of genus 1, 2 of genus 0\n"));
  folder.write("strip.obj", shapes::mobius_strip(5));
  CHECK(contains(folder.run({"check", "strip.obj"}).out, " 1: one-sided with 1 crosscap\n"));
  folder.write("book.obj", shapes::book());
  CHECK(contains(folder.run({"check", "book.obj"}).out, " 1: not manifold\n"));
}

TEST_CASE("check --json prints one object for each mesh") {
  const Folder folder;
  folder.write("grid.obj", shapes::grid(4, 3));
  folder.write("book.obj", shapes::book());
  const Outcome outcome = folder.run({"check", "grid.obj", "book.obj", "--json"});
  CHECK(outcome.status == 1);
  const Json reports = Json::parse(outcome.out);
  REQUIRE(reports.size() == 2);
  CHECK(reports[0].at("well_formed") == true);
  CHECK(reports[0].at("edges") == 31);
  CHECK(reports[0].at("components").at(0).at("genus") == 0);
  CHECK(reports[1].at("path") == "book.obj");
  CHECK(reports[1].at("components").at(0).at("genus").is_null());
  CHECK(reports[1].at("departures").at("non-manifold-edge").at("count") == 1);
  CHECK(reports[1].at("departures").at("non-manifold-edge").at("first").size() == 1);
}

TEST_CASE("check goes on after a file it cannot read, and exits with 2") {
  const Folder folder;
  folder.write("grid.obj", shapes::grid(4, 3));
  const Outcome outcome = folder.run({"check", "absent.obj", "grid.obj"});
  CHECK(outcome.status == 2);
  CHECK(line_count(outcome.err) == 1);
  CHECK(contains(outcome.out, "grid.obj: well-formed\n"));
}

TEST_CASE("check reads standard input, and --quiet only sets the exit status") {
  const Folder folder;
  CHECK(contains(folder.run({"check", "-"}, obj_of(shapes::cube())).out, "standard input: well-formed\n"));
  for (const auto& [soup, status] : {std::pair(shapes::cube(), 0), std::pair(shapes::book(), 1)}) {
    const Outcome outcome = folder.run({"check", "-", "--quiet"}, obj_of(soup));
    CHECK(outcome.status == status);
    CHECK(outcome.out.empty());
    CHECK(outcome.err.empty());
  }
}
