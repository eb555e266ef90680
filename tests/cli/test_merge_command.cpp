#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <quadmatch/analysis/isomorphism.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// base.obj; ours.obj, with a patch lifted; theirs.obj, with another patch cut out, renumbered; near.obj, with one cut
/// out where ours.obj lifts one; both.obj, lifted and cut.
void write_bears(const Folder& folder) {
  const PolygonSoup bear = shapes::bear().soup;
  const auto lifted = shapes::extrude_patch(bear, FaceId(40), 6, 0.1);
  const auto cut = shapes::delete_patch(bear, FaceId(2000), 9);
  const auto near = shapes::delete_patch(bear, FaceId(40), 9);
  REQUIRE((lifted.has_value() && cut.has_value() && near.has_value()));
  folder.write("base.obj", bear);
  folder.write("ours.obj", lifted->soup);
  folder.write("theirs.obj", shapes::renumbered(cut->soup, 1).soup);
  folder.write("near.obj", near->soup);
  const auto both = shapes::delete_patch(lifted->soup, FaceId(2000), 9);  // a patch keeps its faces where they are
  REQUIRE(both.has_value());
  folder.write("both.obj", both->soup);
}

bool is_same(const Folder& folder, std::string_view one, std::string_view other) {
  const auto a = read_mesh(folder.path(one)), b = read_mesh(folder.path(other));
  REQUIRE((a.has_value() && b.has_value()));
  return find_isomorphism(a->mesh, b->mesh, IsomorphismKind::Preserving).isomorphism.has_value();
}

}  // namespace

TEST_CASE("merge brings disjoint edits together, and says what each side did") {
  const Folder folder;
  write_bears(folder);
  const Outcome outcome = folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "out.obj"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "base       base.obj: 2,944 faces\n"));
  CHECK(contains(outcome.out, "theirs     theirs.obj: 2,935 faces; 9 faces removed\n"));
  CHECK(contains(outcome.out, " faces added"));
  CHECK(contains(outcome.out, "conflicts  none\n"));
  CHECK(contains(outcome.out, "written    out.obj\n"));
  CHECK(is_same(folder, "out.obj", "both.obj"));

  // A side that changed nothing, whatever the other is.
  CHECK(folder.run({"merge", "base.obj", "ours.obj", "base.obj", "-o", "out.obj", "--quiet"}).status == 0);
  CHECK((folder.read("out.obj") == folder.read("ours.obj")));
  CHECK(folder.run({"merge", "base.obj", "base.obj", "theirs.obj", "-o", "out.obj", "--quiet"}).status == 0);
  CHECK((folder.read("out.obj") == folder.read("theirs.obj")));
}

TEST_CASE("merge names edits that meet, holds the preferred side there, and ends with status 1") {
  const Folder folder;
  write_bears(folder);
  const Outcome outcome = folder.run({"merge", "base.obj", "ours.obj", "near.obj", "-o", "out.obj"});
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "conflicts  1 area where edits meet; there OUT holds OURS\n"));
  CHECK(contains(outcome.out, " of BASE removed by one side; "));
  CHECK(is_same(folder, "out.obj", "ours.obj"));
  const Outcome other = folder.run(
      {"merge", "base.obj", "ours.obj", "near.obj", "-o", "out.obj", "--prefer", "theirs", "--json", "--origins"});
  CHECK(other.status == 1);
  CHECK(is_same(folder, "out.obj", "near.obj"));
  const Json report = Json::parse(other.out);
  CHECK(report["clean"] == false);
  CHECK(report["prefer"] == "theirs");
  REQUIRE(report["areas"].size() == 1);
  CHECK(report["areas"][0]["base_faces"].size() == 9);
  CHECK(report["areas"][0]["ours_faces"].size() > 0);
  CHECK(report["areas"][0]["theirs_faces"].empty());
  REQUIRE(report["origins"].size() == report["merged"]["faces"]);
  for (const Json& origin : report["origins"]) {
    CHECK_FALSE((origin[0].is_null() && origin[1].is_null() && origin[2].is_null()));
  }
}

TEST_CASE("OUT of a merge may be an input, and nothing is left beside it") {
  const Folder folder;
  write_bears(folder);
  folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "out.obj"});
  const std::string expected = folder.read("out.obj");
  for (const char* const input : {"base.obj", "ours.obj", "theirs.obj"}) {
    const std::string before = folder.read(input);
    CHECK(folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", input}).status == 0);
    CHECK((folder.read(input) == expected));
    folder.write(input, before);
  }
  CHECK(folder.names().size() == 6);
}

TEST_CASE("merge takes match files of its meshes, and refuses others") {
  const Folder folder;
  write_bears(folder);
  folder.run({"match", "base.obj", "ours.obj", "-o", "o.json"});
  folder.run({"match", "base.obj", "theirs.obj", "-o", "t.json"});
  CHECK(folder
            .run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "out.obj", "--match-ours", "o.json",
                  "--match-theirs", "t.json"})
            .status == 0);
  CHECK(is_same(folder, "out.obj", "both.obj"));
  const Outcome wrong =
      folder.run({"merge", "base.obj", "near.obj", "ours.obj", "-o", "new.obj", "--match-theirs", "t.json"});
  CHECK(wrong.status == 2);
  CHECK(wrong.err.starts_with("quadmatch: t.json: "));
  CHECK(line_count(wrong.err) == 1);
  CHECK_FALSE(folder.has("new.obj"));
}

TEST_CASE("what a merge cannot do is said in one line, and nothing is written") {
  const Folder folder;
  write_bears(folder);
  folder.write("cube.obj", shapes::cube());
  folder.write("prism.obj", shapes::prism(5));
  folder.write("broken.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 9\n");
  folder.write("old.obj", "precious");
  check_refused(
      folder, {"merge"},
      {{{"base.obj", "cube.obj", "prism.obj", "-o", "old.obj"},
        "cube.obj: it has no part in common with base.obj, so there is nothing to merge by; name the mesh that "
        "both "
        "sides were made from"},
       {{"base.obj", "ours.obj", "broken.obj", "-o", "old.obj"},
        "broken.obj:4: vertex 9 is named, but the file has only 3 vertices; correct it or export the mesh again"},
       {{"base.obj", "ours.obj", "missing.obj", "-o", "old.obj"},
        "missing.obj: there is no such file; check the name and the folder"},
       {{"base.obj", "ours.obj", "theirs.obj", "-o", "out.xyz"},
        "out.xyz: the name does not tell the format; end it in .obj, .ply, .off or .usda, or say --as NAME"},
       {{"base.obj", "ours.obj", "theirs.obj", "-o", "old.obj", "--as", "model"},
        "model: the name does not tell the format; end it in .obj, .ply, .off or .usda"},
       {{"-", "ours.obj", "-", "-o", "old.obj"},
        "standard input (-) can be read only once; write one of the meshes to a file"},
       {{"base.obj", "ours.obj", "theirs.obj", "-o", "-", "--json"},
        "--json and -o - would mix figures and the mesh on standard output; write the mesh to a file"}});
  CHECK(folder.run({"merge", "base.obj", "ours.obj", "-o", "old.obj"}).status == 2);
  CHECK(folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "old.obj", "--prefer", "mine"}).status == 2);
  CHECK(folder.read("old.obj") == "precious");

  std::filesystem::create_symlink("/dev/full", folder.path("full.obj"));
  const Outcome full = folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "full.obj"});
  CHECK(full.status == 2);
  CHECK(full.out.empty());
  CHECK(contains(full.err, "full.obj: "));
}

TEST_CASE("merge reads standard input, writes standard output, and says where another format loses something") {
  const Folder folder;
  write_bears(folder);
  folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "out.obj"});
  const Outcome piped = folder.run({"merge", "-", "ours.obj", "theirs.obj", "-o", "-"}, folder.read("base.obj"));
  CHECK(piped.status == 0);
  CHECK((piped.out == folder.read("out.obj")));
  CHECK(contains(piped.err, "base       standard input: 2,944 faces\n"));
  const Outcome ply = folder.run({"merge", "base.obj", "ours.obj", "theirs.obj", "-o", "out.ply"});
  CHECK(ply.status == 0);
  CHECK(contains(ply.err, "out.ply: another format than that of OURS"));
  CHECK(is_same(folder, "out.ply", "both.obj"));
}
