// Bad input: one line, path:line: what is wrong, and what to do; exit status 2; an existing output left as it was.

#include <doctest/doctest.h>

#include <quadmatch/shapes/dirty_zoo.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include <unistd.h>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

const std::string kPoints = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string kPlyHeader =
    "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

struct BadFile {
  std::string name, bytes, complaint;
};

const std::vector<BadFile> kBadMeshes{
    {"missing_vertex.obj", kPoints + "f 1 2 3 9\n",
     "missing_vertex.obj:5: vertex 9 is named, but the file has only 4 vertices; correct it or export the mesh again"},
    {"two_corners.obj", kPoints + "f 1 2\n",
     "two_corners.obj:5: a face needs at least three corners, but this one has 2; correct it or export the mesh again"},
    {"no_number.obj", "v 0 0 0\nv 1 x 0\nv 1 1 0\nf 1 2 3\n",
     "no_number.obj:2: 'x' is not a finite number; correct it or export the mesh again"},
    {"no_faces.obj", kPoints, "no_faces.obj: the file has no faces; export the mesh with its faces"},
    {"nothing.obj", "", "nothing.obj: the file is empty; export the mesh again"},
    {"cut.ply", kPlyHeader + "\1\2\3", "cut.ply: the file ends within vertex 1 of 4; export the mesh again"},
    {"bad.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 7\n",
     "bad.off:6: vertex 7 is named, but the file has only 3 vertices, counted from 0; correct it or export the mesh "
     "again"},
    {"what.xyz", "hello",
     "what.xyz: neither the name nor the first word tells the format; give it one of the endings .obj, .ply, .off, "
     ".usda"},
};

const std::vector<BadFile> kBadMatches{
    {"cut.json", "{\"format\": \"quadmatch.match/1\"",
     "cut.json:1: the match file ends too early; match the meshes again"},
    {"bare.json", "{\"format\": \"quadmatch.match/1\"}",
     "bare.json: the field 'source' is missing; match the meshes again"},
    {"mesh.json", kPoints, "mesh.json:1: this is not JSON at 'v'; match the meshes again"},
};

void check_complaint(const Outcome& outcome, const std::string& complaint) {
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.err == "quadmatch: " + complaint + "\n");
}

}  // namespace

TEST_CASE("a bad mesh is named with its line, whichever verb reads it, and an existing output stays") {
  const Folder folder;
  folder.write("good.obj", shapes::grid(2, 2));
  folder.write("old.json", "precious");
  for (const BadFile& bad : kBadMeshes) {
    CAPTURE(bad.name);
    folder.write(bad.name, bad.bytes);
    check_complaint(folder.run({"match", "good.obj", bad.name, "-o", "old.json"}), bad.complaint);
    check_complaint(folder.run({"match", bad.name, "good.obj", "-o", "old.json"}), bad.complaint);
    check_complaint(folder.run({"match", bad.name, "good.obj", "--quiet"}), bad.complaint);
    check_complaint(folder.run({"check", bad.name}), bad.complaint);
    check_complaint(folder.run({"skeleton", bad.name, "-o", "old.json"}), bad.complaint);
    check_complaint(folder.run({"verify", "good.obj", bad.name, "old.json"}), bad.complaint);
  }
  CHECK(folder.read("old.json") == "precious");
}

TEST_CASE("a missing file, a folder and a file one may not read are told apart") {
  const Folder folder;
  std::filesystem::create_directory(folder.path("models"));
  check_complaint(folder.run({"check", "absent.obj"}),
                  "absent.obj: there is no such file; check the name and the folder");
  check_complaint(folder.run({"check", "models"}), "models: this is a folder; name a file in it");
  folder.write("secret.obj", shapes::grid(1, 1));
  std::filesystem::permissions(folder.path("secret.obj"), std::filesystem::perms::none);
  if (::access(folder.path("secret.obj").c_str(), R_OK) != 0) {  // the superuser may read everything
    check_complaint(folder.run({"check", "secret.obj"}),
                    "secret.obj: the file may not be read (permission denied); ask its owner for permission");
  }
}

TEST_CASE("more corners than a 32-bit number counts are refused before they are read") {
  const Folder folder;
  folder.write("huge.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
               "element face 9000000000\nproperty list uchar int vertex_indices\nend_header\n");
  const Outcome outcome = folder.run({"check", "huge.ply"});
  CHECK(outcome.status == 2);
  CHECK(outcome.err ==
        "quadmatch: huge.ply:7: 9000000000 elements 'face' are more than 4,294,967,294; split the mesh\n");
}

TEST_CASE("a bad match file is named with its line") {
  const Folder folder;
  folder.write("quad.obj", shapes::grid(1, 1));
  for (const BadFile& bad : kBadMatches) {
    CAPTURE(bad.name);
    folder.write(bad.name, bad.bytes);
    check_complaint(folder.run({"verify", "quad.obj", "quad.obj", bad.name}), bad.complaint);
  }
  check_complaint(folder.run({"verify", "quad.obj", "quad.obj", "absent.json"}),
                  "absent.json: there is no such file; check the name and the folder");
}

TEST_CASE("a match file for other meshes is refused, saying which side differs") {
  const Folder folder;
  folder.write("small.obj", shapes::grid(2, 2));
  folder.write("large.obj", shapes::grid(3, 2));
  REQUIRE(folder.run({"match", "small.obj", "small.obj", "-o", "m.json"}).status == 0);
  check_complaint(folder.run({"verify", "small.obj", "large.obj", "m.json"}),
                  "m.json: the match was made for a target of 4 faces, but large.obj has 6; match the meshes again");
}

TEST_CASE("an output that cannot be written is named, and nothing is left behind") {
  const Folder folder;
  folder.write("a.obj", shapes::grid(1, 1));
  std::filesystem::create_directory(folder.path("folder"));
  check_complaint(folder.run({"match", "a.obj", "a.obj", "-o", "folder"}),
                  "folder: this is a folder; name a file in it");
  check_complaint(folder.run({"match", "a.obj", "a.obj", "-o", "no/m.json"}),
                  "no/m.json: there is no such folder; create it or choose another place");
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "folder"});
}

TEST_CASE("an input is not overwritten, by whatever name") {
  const Folder folder;
  folder.write("a.obj", shapes::grid(1, 1));
  const std::string bytes = folder.read("a.obj");
  std::filesystem::create_symlink("a.obj", folder.path("link.obj"));
  for (const std::string output : {"a.obj", "./a.obj", "link.obj"}) {
    const std::string complaint = output + ": this is an input and would be overwritten; choose another name for -o";
    check_complaint(folder.run({"match", "a.obj", "a.obj", "-o", output}), complaint);
    check_complaint(folder.run({"skeleton", "a.obj", "-o", output}), complaint);
  }
  CHECK(folder.read("a.obj") == bytes);
}

TEST_CASE("standard input cannot be read twice") {
  const std::string complaint = "standard input (-) can be read only once; write one of the meshes to a file";
  check_complaint(Folder().run({"match", "-", "-"}, obj_of(shapes::grid(1, 1))), complaint);
  check_complaint(Folder().run({"check", "-", "-"}, obj_of(shapes::grid(1, 1))), complaint);
}

TEST_CASE("bad standard input is named as such, with its line") {
  check_complaint(Folder().run({"check", "-"}, kPoints + "f 1 2 3 9\n"),
                  "standard input:5: vertex 9 is named, but the file has only 4 vertices; correct it or export the "
                  "mesh again");
}

TEST_CASE("a dirty mesh is a warning with counts, never a refusal") {
  struct Case {
    std::string name;
    PolygonSoup soup;
    std::string counts;
  };
  const std::string across = ", faces are not adjacent across such edges";
  const std::vector<Case> cases{
      {"book.obj", shapes::book(), "1 non-manifold edge, 2 non-manifold vertices; matching goes on" + across},
      {"hourglass.obj", shapes::hourglass(), "1 non-manifold vertex; matching goes on"},
      {"wound.obj", shapes::wrongly_wound(), "1 wrongly wound edge; matching goes on" + across},
      {"unused.obj", shapes::unused_vertices(), "6 unused vertices; matching goes on"},
  };
  const Folder folder;
  folder.write("clean.obj", shapes::grid(3, 3));
  for (const Case& dirty : cases) {
    CAPTURE(dirty.name);
    folder.write(dirty.name, dirty.soup);
    const Outcome outcome =
        folder.run({"match", "clean.obj", dirty.name, "-o", "m.json", "--algorithm", "lazy-greedy"});
    CHECK(outcome.status == 0);
    CHECK(outcome.err == "quadmatch: warning: " + dirty.name + ": " + dirty.counts + "\n");
    CHECK(folder.run({"match", dirty.name, dirty.name, "-o", "m.json", "--quiet"}).err.empty());
    CHECK(folder.run({"verify", dirty.name, dirty.name, "m.json"}).status == 0);
  }
}

TEST_CASE("degenerate and duplicate faces are counted in the warning") {
  const Folder folder;
  folder.write("degenerate.obj", shapes::degenerate_face());
  folder.write("duplicate.obj", shapes::duplicate_faces());
  const Outcome outcome = folder.run({"match", "degenerate.obj", "duplicate.obj", "-o", "m.json"});
  CHECK(outcome.status != 2);
  CHECK(line_count(outcome.err) == 2);
  CHECK(contains(outcome.err, "degenerate.obj: "));
  CHECK(contains(outcome.err, "1 degenerate face"));
  CHECK(contains(outcome.err, "1 duplicate face"));
}
