// --report: the page a verb writes beside its figures.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

void write_pair(const Folder& folder) {
  const PolygonSoup star = shapes::star(5, 3);
  folder.write("a.obj", shapes::disjoint_union({star, shapes::cube()}));
  folder.write("b.obj", shapes::renumbered(star, 1).soup);
}

Json header_of(const std::string& html) {
  const std::string opening = "id=\"report-header\">";
  const std::size_t start = html.find(opening) + opening.size();
  return Json::parse(html.substr(start, html.find("</script>", start) - start));
}

}  // namespace

TEST_CASE("match --report writes a page with the figures of the summary, and without -o no match file") {
  const Folder folder;
  write_pair(folder);
  const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "--report", "page.html"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "source   a.obj: 51 faces, 88.2 % matched, 6 unmatched in 1 area\n"));
  CHECK(contains(outcome.out, "written  page.html\n"));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj", "page.html"});

  const Json header = header_of(folder.read("page.html"));
  CHECK(header.at("title") == "a.obj and b.obj");
  CHECK(header.at("figures").at(0) ==
        Json::array({"source", "a.obj: 51 faces, 88.2 % matched, 6 unmatched in 1 area"}));
  CHECK(header.at("changes") == Json::array({Json::array({"only in source", "6 faces around f45 have no partner"})}));
  CHECK(header.at("regions").size() == 1);
}

TEST_CASE("the page changes nothing of the match file, and is the same on every run") {
  const Folder folder;
  write_pair(folder);
  for (const std::string algorithm : {"regions", "lazy-greedy", "greedy", "exact"}) {
    CAPTURE(algorithm);
    folder.run({"match", "b.obj", "b.obj", "-o", "plain.json", "--algorithm", algorithm, "--quiet"});
    const Outcome outcome = folder.run(
        {"match", "b.obj", "b.obj", "-o", "paged.json", "--algorithm", algorithm, "--report", "page.html", "--quiet"});
    CHECK(outcome.status == 0);
    CHECK(outcome.out.empty());
    CHECK((folder.read("plain.json") == folder.read("paged.json")));
    folder.run({"match", "b.obj", "b.obj", "--algorithm", algorithm, "--report", "again.html", "--quiet"});
    CHECK((folder.read("page.html") == folder.read("again.html")));
  }
}

TEST_CASE("with --json the page is named among the figures") {
  const Folder folder;
  write_pair(folder);
  const Outcome outcome = folder.run({"match", "a.obj", "b.obj", "--report", "page.html", "--json"});
  CHECK(outcome.status == 0);
  CHECK(Json::parse(outcome.out).at("report") == "page.html");
  CHECK(Json::parse(folder.run({"match", "a.obj", "b.obj", "--json"}).out).at("report").is_null());
  const Outcome nothing = folder.run({"match", "a.obj", "b.obj", "--report", "page.html", "--min-region", "1000"});
  CHECK(nothing.status == 1);
  CHECK(header_of(folder.read("page.html")).at("regions").empty());
}

TEST_CASE("diff --report lists every change by its name, with its faces, and shows what was left out as unmatched") {
  const Folder folder;
  const PolygonSoup shirt = shapes::shirt(shapes::Sleeves::Short).soup;
  folder.write("a.obj", shirt);
  const Expected<shapes::Edit> edit = shapes::delete_patch(shirt, FaceId(600), 12);
  REQUIRE(edit.has_value());
  folder.write("cut.obj", shapes::renumbered(edit->soup, 4).soup);
  const Outcome outcome = folder.run({"diff", "a.obj", "cut.obj", "--report", "page.html"});
  CHECK(outcome.status == 1);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "  written   page.html\n"));
  const Json header = header_of(folder.read("page.html"));
  REQUIRE(header.at("changes").size() == 1);
  CHECK(header.at("changes").at(0).at(0) == "deletion");
  CHECK(header.at("changes").at(0).at(1).get<std::string>().starts_with("12 faces removed: f"));
  CHECK(header.at("figures").at(2) == Json::array({"faces", "1,420 the same, 12 removed"}));
  // Two lists of faces, of twelve and of none: a byte for each length, and one or two for each face.
  const std::size_t bytes = header.at("blocks").back().at(1);
  CHECK((bytes >= 14 && bytes <= 26));
  const Json figures = Json::parse(folder.run({"diff", "a.obj", "cut.obj", "--report", "page.html", "--json"}).out);
  CHECK(figures.at("report") == "page.html");

  const Outcome misplaced = folder.run({"diff", "a.obj", "cut.obj", "--isomorphic", "--report", "page.html"});
  CHECK(misplaced.status == 2);
  CHECK(contains(misplaced.err, "--report is about comparing part by part"));
  CHECK(folder.run({"diff", "a.obj", "cut.obj", "--report", "cut.obj"}).status == 2);
}

TEST_CASE("a page that cannot be written is trouble in one line, and nothing is overwritten") {
  const Folder folder;
  write_pair(folder);
  const std::string before = folder.read("a.obj");
  struct Trouble {
    std::vector<std::string> arguments;
    std::string complaint;
  };
  for (const Trouble& trouble : std::vector<Trouble>{
           {{"--report", "a.obj"},
            "a.obj: this is an input and would be overwritten; choose another name for --report"},
           {{"--report", "-"},
            "--report needs the name of a file, such as report.html; - is for standard output, which has the figures"},
           {{"--report", "m.html", "-o", "./m.html"},
            "m.html: another option and --report name the same file; choose another name for one of them"}}) {
    std::vector<std::string> arguments{"match", "a.obj", "b.obj"};
    arguments.insert(arguments.end(), trouble.arguments.begin(), trouble.arguments.end());
    const Outcome outcome = folder.run(arguments);
    CHECK(outcome.status == 2);
    CHECK(outcome.out.empty());
    CHECK(outcome.err == "quadmatch: " + trouble.complaint + "\n");
  }
  const Outcome missing = folder.run({"match", "a.obj", "b.obj", "--report", "none/page.html"});
  CHECK(missing.status == 2);
  CHECK(line_count(missing.err) == 1);
  CHECK(contains(missing.err, "none/page.html"));
  std::filesystem::create_symlink("/dev/full", folder.path("full.html"));
  CHECK(folder.run({"match", "a.obj", "b.obj", "--report", "full.html"}).status == 2);
  CHECK((folder.read("a.obj") == before));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj", "full.html"});
}
