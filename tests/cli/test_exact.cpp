// match --algorithm exact: what it says of proof and bound, and its exit statuses.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/shapes/figures.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

void write_figures(const Folder& folder) {
  folder.write("a.obj", shapes::fig_4_1().soup);
  folder.write("b.obj", shapes::fig_4_2().soup);
}

}  // namespace

TEST_CASE("Figs 4.1 and 4.2: the exact search proves that no region has more than 157 faces, in words, JSON and file") {
  const Folder folder;
  write_figures(folder);
  const Outcome text = folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--algorithm", "exact"});
  CHECK(text.status == 0);
  CHECK(contains(text.out, "matched  157 faces, 190 vertices\n"));
  CHECK(contains(text.out, "largest  proved: no region has more than 157 faces; "));
  CHECK_FALSE(contains(text.out, "answer"));
  CHECK(folder.run({"verify", "a.obj", "b.obj", "m.json"}).status == 0);

  const Json file = Json::parse(folder.read("m.json"));
  CHECK(file["statistics"]["proved"] == true);
  CHECK(file["statistics"]["bound"] == 157);
  CHECK_FALSE(file.contains("complete"));
  const Json figures = Json::parse(folder.run({"match", "a.obj", "b.obj", "--algorithm", "exact", "--json"}).out);
  CHECK(figures["matched_faces"] == 157);
  CHECK(figures["optimality"] == file["statistics"]);
  CHECK(Json::parse(folder.run({"match", "a.obj", "b.obj", "--json"}).out)["optimality"].is_null());
}

TEST_CASE("--at-least answers yes by status 0 and no by status 1") {
  const Folder folder;
  write_figures(folder);
  const auto ask = [&](const char* faces) {
    return folder.run({"match", "a.obj", "b.obj", "-o", "m.json", "--algorithm", "exact", "--at-least", faces});
  };
  const Outcome yes = ask("157");
  CHECK(yes.status == 0);
  CHECK(contains(yes.out, "answer   yes, there is a region of 157 faces or more\n"));
  CHECK(Json::parse(folder.read("m.json"))["statistics"]["answer"] == "yes");
  const Outcome no = ask("158");
  CHECK(no.status == 1);
  CHECK(contains(no.out, "answer   no, there is no region of 158 faces or more\n"));
  CHECK(Json::parse(folder.read("m.json"))["statistics"]["at_least"] == 158);
  CHECK(ask("0").status == 2);
}

TEST_CASE("a time limit that is over leaves the best region so far, a bound, and status 3 where a question was asked") {
  const Folder folder;
  // A torus a row longer: all placements are alike, and each loses much.
  folder.write("a.obj", shapes::torus(20, 31));
  folder.write("b.obj", shapes::torus(21, 30));
  const std::vector<std::string> arguments{"match",       "a.obj", "b.obj",        "-o",  "m.json",
                                           "--algorithm", "exact", "--time-limit", "0.2", "--json"};
  const Outcome stopped = folder.run(arguments);
  CHECK(stopped.status == 0);
  const Json figures = Json::parse(stopped.out);
  CHECK(figures["optimality"]["proved"] == false);
  CHECK(figures["optimality"]["bound"] > figures["matched_faces"]);
  CHECK(figures["matched_faces"] > 0);
  CHECK(Json::parse(folder.read("m.json"))["complete"] == false);
  CHECK(folder.run({"verify", "a.obj", "b.obj", "m.json"}).status == 0);

  std::vector<std::string> question = arguments;
  question.insert(question.end(), {"--at-least", "615"});
  const Outcome unknown = folder.run(question);
  CHECK(unknown.status == 3);
  CHECK(Json::parse(unknown.out)["optimality"]["answer"] == "unknown");
}

TEST_CASE("options of the exact search are refused beside another algorithm, and anchors beside it") {
  const Folder folder;
  write_figures(folder);
  const Outcome limit = folder.run({"match", "a.obj", "b.obj", "--time-limit", "5"});
  CHECK(limit.status == 2);
  CHECK(contains(limit.err, "--time-limit needs --algorithm exact"));
  const Outcome at_least = folder.run({"match", "a.obj", "b.obj", "--at-least", "5", "--algorithm", "greedy"});
  CHECK(at_least.status == 2);
  CHECK(contains(at_least.err, "--at-least needs --algorithm exact"));
  const Outcome anchor = folder.run({"match", "a.obj", "b.obj", "--algorithm", "exact", "--anchor", "0:0=0:0"});
  CHECK(anchor.status == 2);
  CHECK(contains(anchor.err, "takes no --anchor"));
}
