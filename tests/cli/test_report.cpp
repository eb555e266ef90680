// --report: the page a verb writes beside its figures.

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

std::size_t faces_of(const PolygonSoup& soup) { return soup.corners.size() / 4; }

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
  check_refused(
      folder, {"match", "a.obj", "b.obj"},
      {{{"--report", "a.obj"}, "a.obj: this is an input and would be overwritten; choose another name for --report"},
       {{"--report", "-"},
        "--report needs the name of a file, such as report.html; - is for standard output, which has the figures"},
       {{"--report", "m.html", "-o", "./m.html"},
        "m.html: another option and --report name the same file; choose another name for one of them"}});
  const Outcome missing = folder.run({"match", "a.obj", "b.obj", "--report", "none/page.html"});
  CHECK(missing.status == 2);
  CHECK(line_count(missing.err) == 1);
  CHECK(contains(missing.err, "none/page.html"));
  std::filesystem::create_symlink("/dev/full", folder.path("full.html"));
  CHECK(folder.run({"match", "a.obj", "b.obj", "--report", "full.html"}).status == 2);
  CHECK((folder.read("a.obj") == before));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj", "full.html"});
}

TEST_CASE("merge --report shows the base beside the result, and lists who removed and who added what") {
  const Folder folder;
  const PolygonSoup shirt = shapes::shirt(shapes::Sleeves::Short).soup;
  folder.write("base.obj", shirt);
  const Expected<shapes::Edit> deleted = shapes::delete_patch(shirt, FaceId(600), 12);
  const Expected<shapes::Edit> extruded = shapes::extrude_patch(shirt, FaceId(100), 9, 0.02);
  REQUIRE((deleted.has_value() && extruded.has_value()));
  folder.write("ours.obj", shapes::renumbered(deleted->soup, 4).soup);
  folder.write("theirs.obj", shapes::renumbered(extruded->soup, 5).soup);
  const std::size_t wall = faces_of(extruded->soup) - faces_of(shirt);
  const std::vector<std::string> command{"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "out.obj"};
  std::vector<std::string> paged = command;
  paged.insert(paged.end(), {"--report", "page.html"});
  folder.run(command);
  const std::string plain = folder.read("out.obj");
  const Outcome outcome = folder.run(paged);
  CHECK(outcome.status == 0);
  CHECK(contains(outcome.out, "written    out.obj\n           page.html\n"));
  CHECK((folder.read("out.obj") == plain));
  const Json header = header_of(folder.read("page.html"));
  CHECK(header.at("title") == "base.obj and out.obj");
  CHECK(header.at("mirror") == false);
  CHECK(header.at("source").at("faces") == faces_of(shirt));
  CHECK(header.at("target").at("faces") == faces_of(shirt) - 12 + wall);
  REQUIRE(header.at("changes").size() == 2);
  CHECK(header.at("changes").at(0).at(0) == "removed by OURS");
  CHECK(header.at("changes").at(0).at(1).get<std::string>().starts_with("12 faces around f"));
  CHECK(header.at("changes").at(1).at(0) == "added by THEIRS");
  CHECK(header.at("changes").at(1).at(1).get<std::string>().starts_with(std::to_string(wall) + " faces around f"));
  std::size_t matched = 0;
  for (const Json& region : header.at("regions")) matched += region.at("faces").get<std::size_t>();
  CHECK(matched == faces_of(shirt) - 12);
  paged.emplace_back("--json");
  CHECK(Json::parse(folder.run(paged).out).at("report") == "page.html");
}

TEST_CASE("merge --report lists conflicts first, by the sentence of the summary") {
  const Folder folder;
  const PolygonSoup shirt = shapes::shirt(shapes::Sleeves::Short).soup;
  folder.write("base.obj", shirt);
  const Expected<shapes::Edit> deleted = shapes::delete_patch(shirt, FaceId(600), 12);
  const Expected<shapes::Edit> extruded = shapes::extrude_patch(shirt, FaceId(600), 9, 0.02);
  REQUIRE((deleted.has_value() && extruded.has_value()));
  folder.write("ours.obj", deleted->soup);
  folder.write("theirs.obj", extruded->soup);
  const Outcome outcome =
      folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "out.obj", "--report", "page.html"});
  CHECK(outcome.status == 1);
  const Json header = header_of(folder.read("page.html"));
  REQUIRE_FALSE(header.at("changes").empty());
  CHECK(header.at("changes").at(0).at(0) == "conflict");
  CHECK(contains(outcome.out, header.at("changes").at(0).at(1).get<std::string>()));
}

TEST_CASE("symmetry --report shows each side of the line as a region, and lists the line and what has no partner") {
  const Folder folder;
  const PolygonSoup ball = shapes::sphere(8);
  folder.write("whole.obj", ball);
  const Outcome whole = folder.run({"symmetry", "whole.obj", "--report", "whole.html", "-o", "map.json"});
  CHECK(whole.status == 0);
  CHECK(contains(whole.out, "written      map.json\n             whole.html\n"));
  const Json header = header_of(folder.read("whole.html"));
  CHECK(header.at("title") == "whole.obj and its mirror image");
  CHECK(header.at("mirror") == true);
  CHECK(header.at("changes").at(0).at(0) == "centre line");
  // Both sides of the line, part by part: as many faces left as right.
  const Json& regions = header.at("regions");
  REQUIRE(regions.size() >= 2);
  CHECK(regions.at(0).at("faces") == regions.at(1).at("faces"));
  std::size_t faces = 0;
  for (const Json& region : regions) faces += region.at("faces").get<std::size_t>();
  CHECK(faces == faces_of(ball));

  // A bear has a patch on one side of its belly.
  folder.write("bear.obj", shapes::bear().soup);
  const Outcome lopsided = folder.run({"symmetry", "bear.obj", "--report", "bear.html", "--json"});
  CHECK(lopsided.status == 1);
  const Json figures = Json::parse(lopsided.out);
  CHECK(figures.at("report") == "bear.html");
  const Json changes = header_of(folder.read("bear.html")).at("changes");
  CHECK(changes.size() == 1 + figures.at("unpaired_areas").size());
  CHECK(changes.at(1).at(0) == "no partner");
  CHECK(folder.run({"symmetry", "whole.obj", "--report", "whole.obj"}).status == 2);
  CHECK(folder.run({"symmetry", "whole.obj", "--report", "m.json", "-o", "m.json"}).status == 2);
}
