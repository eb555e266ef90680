#include <doctest/doctest.h>

#include <sstream>

#include <nlohmann/json.hpp>
#include <quadmatch/io/read_mesh.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "program.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// A model with a texture coordinate for each corner and its parts as groups.
std::string textured(const shapes::Model& model) {
  MeshFile file{.mesh = *Mesh::build(model.soup)};
  IndexedAttribute pool{2, {}, {}};
  for (const shapes::TextureCoordinate& coordinate : model.coordinates) {
    pool.corner_index.push_back(static_cast<std::uint32_t>(pool.values.size() / 2));
    pool.values.insert(pool.values.end(), coordinate.begin(), coordinate.end());
  }
  file.texture_coordinates = std::move(pool);
  for (const shapes::ModelPart& part : model.parts) file.face_records.push_back({part.first_face, "g", part.name});
  return format_mesh(file, Format::Obj);
}

/// a.obj: a textured shirt; b.obj: the same renumbered and bare; part.obj: a patch of it is missing, another is new.
void write_shirts(const Folder& folder) {
  const shapes::Model shirt = shapes::shirt(shapes::Sleeves::Short);
  folder.write("a.obj", textured(shirt));
  folder.write("b.obj", shapes::renumbered(shirt.soup, 3).soup);
  const Expected<shapes::Edit> edit = shapes::extrude_patch(shirt.soup, FaceId(600), 12, 0.2);
  REQUIRE(edit.has_value());
  folder.write("part.obj", shapes::renumbered(edit->soup, 4).soup);
}

/// Lines of a text that do not begin with these.
std::string without(const std::string& text, const std::string& beginning) {
  std::istringstream lines(text);
  std::string rest;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(beginning)) rest += line + "\n";
  }
  return rest;
}

}  // namespace

TEST_CASE("data come back onto a renumbered copy, and in order the file is the source again") {
  const Folder folder;
  write_shirts(folder);
  const Outcome outcome = folder.run({"transfer", "a.obj", "b.obj", "-o", "out.obj"});
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
  CHECK(contains(outcome.out, "source   a.obj: 1,432 faces\n"));
  CHECK(contains(outcome.out, "target   b.obj: 1,432 faces, all of it takes the source's data\n"));
  CHECK(contains(outcome.out, "carried  texture coordinates: 5,728 corners, all of them\n"));
  CHECK(contains(outcome.out, "         groups (g): 1,432 faces, all of them\n"));
  CHECK(contains(outcome.out, "written  out.obj\n"));

  const Outcome ordered = folder.run({"transfer", "a.obj", "b.obj", "-o", "ordered.obj", "--order", "--quiet"});
  CHECK(ordered.status == 0);
  CHECK(ordered.out.empty());
  CHECK(ordered.err.empty());
  CHECK((folder.read("ordered.obj") == folder.read("a.obj")));
}

TEST_CASE("where B differs from A, the status is 1 and the summary says how much was carried") {
  const Folder folder;
  write_shirts(folder);
  const Outcome outcome = folder.run({"transfer", "a.obj", "part.obj", "-o", "out.obj"});
  CHECK(outcome.status == 1);
  CHECK(contains(outcome.out, "not found in the source\n"));
  CHECK(contains(outcome.out, " corners; "));
  CHECK(contains(outcome.out, " have none\n"));
  const Outcome smooth = folder.run({"transfer", "a.obj", "part.obj", "-o", "out.obj", "--fill", "smooth", "--json"});
  CHECK(smooth.status == 1);
  const Json report = Json::parse(smooth.out);
  CHECK(report["complete"] == false);
  CHECK(report["attributes"][0]["name"] == "texture coordinates");
  CHECK(report["attributes"][0]["filled"] > 0);
  CHECK(report["attributes"][0]["without"] == 0);
  CHECK(report["settings"]["fill"] == "smooth");
  const auto result = read_mesh(folder.path("out.obj"));
  REQUIRE(result.has_value());
  for (const std::uint32_t index : result->texture_coordinates->corner_index) {
    CHECK(index != IndexedAttribute::kNoIndex);
  }
}

TEST_CASE("OUT may be B itself or A itself, and nothing is left beside it") {
  const Folder folder;
  write_shirts(folder);
  folder.run({"transfer", "a.obj", "b.obj", "-o", "out.obj"});
  const std::string expected = folder.read("out.obj");
  folder.write("a2.obj", folder.read("a.obj"));
  CHECK(folder.run({"transfer", "a.obj", "b.obj", "-o", "b.obj"}).status == 0);
  CHECK((folder.read("b.obj") == expected));
  CHECK(folder.run({"transfer", "a2.obj", "b.obj", "-o", "a2.obj"}).status == 0);
  CHECK((folder.read("a2.obj") == expected));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "a2.obj", "b.obj", "out.obj", "part.obj"});
}

TEST_CASE("a match file is taken as it is, if it is of these meshes and sound") {
  const Folder folder;
  write_shirts(folder);
  folder.run({"match", "a.obj", "b.obj", "-o", "m.json"});
  CHECK(folder.run({"transfer", "a.obj", "b.obj", "--match", "m.json", "-o", "out.obj"}).status == 0);
  CHECK(folder.run({"transfer", "a.obj", "b.obj", "-o", "other.obj"}).status == 0);
  CHECK((folder.read("out.obj") == folder.read("other.obj")));

  const Outcome wrong = folder.run({"transfer", "a.obj", "part.obj", "--match", "m.json", "-o", "new.obj"});
  CHECK(wrong.status == 2);
  CHECK(wrong.err.starts_with("quadmatch: m.json: "));
  CHECK(line_count(wrong.err) == 1);

  Json match = Json::parse(folder.read("m.json"));
  match["regions"][0]["faces"][3][2] = (match["regions"][0]["faces"][3][2].get<int>() + 1) % 4;
  folder.write("unsound.json", match.dump());
  const Outcome unsound = folder.run({"transfer", "a.obj", "b.obj", "--match", "unsound.json", "-o", "new.obj"});
  CHECK(unsound.status == 2);
  CHECK(unsound.err.starts_with("quadmatch: unsound.json: the match is not sound for these meshes: region 0"));
  CHECK(folder.run({"transfer", "a.obj", "b.obj", "--match", "m.json", "-o", "m.json"}).status == 2);
  CHECK_FALSE(folder.has("new.obj"));
}

TEST_CASE("parts that could lie in several ways are named and not carried, unless that is allowed") {
  const Folder folder;
  // A shirt, and four cubes that nothing tells apart once positions are out of play.
  const shapes::Model shirt = shapes::shirt(shapes::Sleeves::Short);
  const PolygonSoup all =
      shapes::disjoint_union({shirt.soup, shapes::cube(), shapes::cube(), shapes::cube(), shapes::cube()});
  std::string text = obj_of(all) + "vt 0.25 0.75\n";
  for (std::size_t at = text.find("\nf "); at != std::string::npos; at = text.find("\nf ", at + 1)) {
    const std::size_t end = text.find('\n', at + 1);
    std::istringstream words(text.substr(at + 3, end - at - 3));
    std::string line = "\nf";
    for (std::string word; words >> word;) line += " " + word + "/1";
    text.replace(at, end - at, line);
  }
  folder.write("a.obj", text);
  folder.write("b.obj", shapes::renumbered(all, 8).soup);
  const Outcome cautious = folder.run({"transfer", "a.obj", "b.obj", "-o", "out.obj", "--no-positions"});
  CHECK(cautious.status == 1);
  CHECK(contains(cautious.out, "left out  6 faces of the target from f"));
  CHECK(contains(cautious.out, " of the source: one of "));
  CHECK(contains(cautious.out, "--allow-ambiguous carries all the same\n"));
  CHECK(contains(cautious.out, "texture coordinates: 5,728 of 5,824 corners; 96 have none\n"));
  const Outcome bold =
      folder.run({"transfer", "a.obj", "b.obj", "-o", "out.obj", "--no-positions", "--allow-ambiguous"});
  CHECK(bold.status == 0);
  CHECK_FALSE(contains(bold.out, "left out"));

  // Nothing but cubes: nothing is certain, so nothing is written.
  folder.write("cubes.obj", shapes::disjoint_union({shapes::cube(), shapes::cube()}));
  const Outcome nothing =
      folder.run({"transfer", "cubes.obj", "cubes.obj", "-o", "none.obj", "--only", "positions", "--no-positions"});
  CHECK(nothing.status == 2);
  CHECK(contains(nothing.err, "quadmatch: cubes.obj: all that was found of cubes.obj is doubtful"));
  CHECK(contains(nothing.err, "quadmatch: 6 faces of the target from f0 on, f0 of the source: one of "));
  CHECK_FALSE(folder.has("none.obj"));
}

TEST_CASE("what cannot be done is said in one line, and nothing is written") {
  const Folder folder;
  write_shirts(folder);
  folder.write("triangle.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  folder.write("old.obj", "precious");
  check_refused(
      folder, {"transfer"},
      {{{"a.obj", "b.obj", "-o", "out.xyz"},
        "out.xyz: the name does not tell the format; end it in .obj, .ply, .off or .usda"},
       {{"b.obj", "a.obj", "-o", "old.obj"},
        "b.obj: it has none of the data that are to be carried; ask for what it has, or for its order"},
       {{"a.obj", "b.obj", "-o", "old.obj", "--only", "none"},
        "a.obj: it has none of the data that are to be carried; ask for what it has, or for its order"},
       {{"a.obj", "triangle.obj", "-o", "old.obj"},
        "triangle.obj: nothing of a.obj was found in it, so nothing is carried and nothing written; quadmatch "
        "match "
        "shows more"},
       {{"a.obj", "missing.obj", "-o", "old.obj"}, "missing.obj: there is no such file; check the name and the folder"},
       {{"-", "-", "-o", "old.obj"}, "standard input (-) can be read only once; write one of the meshes to a file"},
       {{"a.obj", "b.obj", "-o", "-", "--json"},
        "--json and -o - would mix figures and the mesh on standard output; write the mesh to a file"},
       {{"a.obj", "b.obj", "-o", "old.obj", "--match", "m.json", "--no-positions"},
        "--no-positions is about matching, but --match gives the match; leave one of them out"}});
  CHECK(folder.run({"transfer", "a.obj", "b.obj", "-o", "old.obj", "--only", "hair"}).status == 2);
  CHECK(folder.run({"transfer", "a.obj", "b.obj"}).status == 2);
  CHECK(folder.read("old.obj") == "precious");
  CHECK_FALSE(folder.has("out.xyz"));
}

TEST_CASE("a full disk is trouble, and leaves no file half written") {
  const Folder folder;
  write_shirts(folder);
  std::filesystem::create_symlink("/dev/full", folder.path("full.obj"));
  const Outcome full = folder.run({"transfer", "a.obj", "b.obj", "-o", "full.obj"});
  CHECK(full.status == 2);
  CHECK(full.out.empty());
  CHECK(contains(full.err, "full.obj: "));
  CHECK(folder.names() == std::vector<std::string>{"a.obj", "b.obj", "full.obj", "part.obj"});
}

TEST_CASE("to standard output goes the mesh alone; another format says what it has no place for") {
  const Folder folder;
  write_shirts(folder);
  folder.run({"transfer", "a.obj", "b.obj", "-o", "out.obj"});
  const Outcome piped = folder.run({"transfer", "-", "b.obj", "-o", "-"}, folder.read("a.obj"));
  CHECK(piped.status == 0);
  CHECK((piped.out == folder.read("out.obj")));
  CHECK(contains(piped.err, "source   standard input: 1,432 faces\n"));

  const Outcome ply = folder.run({"transfer", "a.obj", "b.obj", "-o", "out.ply"});
  CHECK(ply.status == 1);
  CHECK(contains(ply.out, "not kept  PLY has no place for groups (g); choose another format\n"));
  CHECK(folder.run({"transfer", "a.obj", "b.obj", "-o", "out.ply", "--only", "uv"}).status == 0);

  // And back from PLY, onto the bare mesh: the same coordinates, now shared where they are the same.
  CHECK(folder.run({"transfer", "out.ply", "b.obj", "-o", "back.obj"}).status == 0);
  const auto there = read_mesh(folder.path("out.obj")), here = read_mesh(folder.path("back.obj"));
  REQUIRE((there.has_value() && here.has_value()));
  for (std::uint32_t h = 0; h < there->mesh.halfedge_count(); ++h) {
    for (std::size_t c = 0; c < 2; ++c) {
      const std::size_t from = there->texture_coordinates->corner_index[h];
      const std::size_t to = here->texture_coordinates->corner_index[h];
      CHECK(there->texture_coordinates->values[2 * from + c] == here->texture_coordinates->values[2 * to + c]);
    }
  }
}

TEST_CASE("--only none --order renumbers and carries nothing else; --only positions moves vertices") {
  const Folder folder;
  write_shirts(folder);
  CHECK(folder.run({"transfer", "a.obj", "b.obj", "-o", "key.obj", "--only", "none", "--order"}).status == 0);
  const auto source = read_mesh(folder.path("a.obj")), key = read_mesh(folder.path("key.obj"));
  REQUIRE((source.has_value() && key.has_value()));
  CHECK(std::equal(source->mesh.corners().begin(), source->mesh.corners().end(), key->mesh.corners().begin()));
  CHECK_FALSE(key->texture_coordinates.has_value());

  folder.write("flat.obj", without(folder.read("b.obj"), "#"));
  CHECK(folder.run({"transfer", "a.obj", "flat.obj", "-o", "moved.obj", "--only", "positions,uv"}).status == 0);
  CHECK(read_mesh(folder.path("moved.obj"))->texture_coordinates.has_value());
}
