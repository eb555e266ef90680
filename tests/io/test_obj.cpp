// OBJ: every record survives, every form of a face is read, and every complaint names its line.

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

constexpr std::uint32_t kNone = IndexedAttribute::kNoIndex;

MeshFile obj(std::string_view text) { return parsed(text, Format::Obj); }
std::string obj_complaint(std::string_view text) { return complaint(text, Format::Obj); }

constexpr std::string_view kFourVertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
std::string with_vertices(std::string_view rest) { return std::string(kFourVertices) + std::string(rest); }

}  // namespace

TEST_CASE("every record of an OBJ file is found") {
  const MeshFile file = obj(kFullObj);
  CHECK(file.mesh.vertex_count() == 6);
  CHECK(file.mesh.face_count() == 2);
  CHECK(face(file, 0) == Corners{0, 1, 2, 3});
  CHECK(face(file, 1) == Corners{1, 4, 5, 2});
  CHECK(file.mesh.positions()[5] == Point{2, 1, 1e-3});
  CHECK(file.comments == std::vector<std::string>{"two quads"});
  CHECK(file.material_libraries == std::vector<std::string>{"skin.mtl"});
  REQUIRE(file.texture_coordinates);
  CHECK(file.texture_coordinates->components == 2);
  CHECK(file.texture_coordinates->values == std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1});
  CHECK(file.texture_coordinates->corner_index == Corners{0, 1, 2, 3, kNone, kNone, 2, kNone});
  REQUIRE(file.normals);
  CHECK(file.normals->corner_index == Corners{0, 0, 0, 0, 0, kNone, kNone, kNone});
  REQUIRE(file.face_records.size() == 6);
  CHECK(file.face_records[1].keyword == "g");
  CHECK(file.face_records[1].value == "left arm");
  CHECK(file.face_records[4].value == "off");
  CHECK(file.face_records[4].first_face == 1);
  CHECK(file.face_records[5].first_face == 2);
  REQUIRE(file.carried.size() == 2);
  CHECK(file.carried[0].text == "l 1 2 3");
  CHECK(file.carried[1].text == "p 6");
  CHECK(file.notes.empty());
}

TEST_CASE("an OBJ file with every record comes back byte by byte") {
  const std::string_view canonical =
      "# two quads\n"
      "mtllib skin.mtl\n"
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0.1\nv 2 1 0.001\n"
      "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
      "vn 0 0 1\n"
      "o body\n"
      "g left arm\n"
      "usemtl skin\n"
      "s 1\n"
      "f 1/1/1 2/2/1 3/3/1 4/4/1\n"
      "l 1 2 3\n"
      "s off\n"
      "f 2//1 5 6/3 3\n"
      "p 6\n"
      "o empty\n";
  CHECK(format_mesh(obj(kFullObj), Format::Obj) == canonical);
  CHECK(format_mesh(obj(canonical), Format::Obj) == canonical);
}

TEST_CASE("triangles, quads and larger faces of one file stay what they are") {
  const MeshFile file =
      obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 2 0\nf 1 2 3 4\nf 4 3 5\nf 1 2 3 5 4\nf 1 2 3 4\n");
  REQUIRE(file.mesh.face_count() == 4);
  CHECK(face(file, 0) == Corners{0, 1, 2, 3});
  CHECK(face(file, 1) == Corners{3, 2, 4});
  CHECK(face(file, 2) == Corners{0, 1, 2, 4, 3});
  CHECK(face(file, 3) == Corners{0, 1, 2, 3});
}

TEST_CASE("faces and vertices are never dropped or merged") {
  const MeshFile file = obj("v 0 0 0\nv 0 0 0\nv 0 0 0\nv 9 9 9\nf 1 2 3\nf 1 2 3\nf 1 1 1\n");
  CHECK(file.mesh.vertex_count() == 4);
  CHECK(file.mesh.face_count() == 3);
}

TEST_CASE("negative indices count back from the latest element") {
  const MeshFile file = obj(with_vertices("vt 0 0\nf -4/-1 -3 -2 -1\nv 5 5 5\nf -1 -2 -3\n"));
  CHECK(face(file, 0) == Corners{0, 1, 2, 3});
  CHECK(face(file, 1) == Corners{4, 3, 2});
  CHECK(file.texture_coordinates->corner_index[0] == 0);
}

TEST_CASE("a face may name vertices that are defined further down") {
  const MeshFile file = obj(std::string("f 1 2 3 4\n") + std::string(kFourVertices));
  CHECK(face(file, 0) == Corners{0, 1, 2, 3});
}

TEST_CASE("carried lines keep their vertices and their place when the file is written again") {
  const MeshFile file = obj(with_vertices("o a\nl -4 -3/1\nvt 0 0\nv 7 7 7\no b\nl -1 1\nf 1 2 3 4\np -1\n"));
  const std::string written = format_mesh(file, Format::Obj);
  CHECK(written.substr(written.find("o a")) == "o a\nl 1 2/1\no b\nl 5 1\nf 1 2 3 4\np 5\n");
}

TEST_CASE("CR LF, CR, tabs, leading blanks and a missing last line break change nothing") {
  const MeshFile plain = obj(kFullObj);
  for (const std::string_view line_end : {"\r\n", "\r"}) {
    std::string text;
    for (const char c : kFullObj) {
      if (c == '\n') {
        text += line_end;
      } else {
        text += c;
      }
    }
    const MeshFile file = obj(text);
    check_same_mesh(plain.mesh, file.mesh);
    CHECK(file.face_records.size() == plain.face_records.size());
    CHECK(file.comments == plain.comments);
  }
  const MeshFile odd = obj("  v\t0 0\t 0 \nv 1 0 0\t\n\tv 1 1 0\n\n \nv 0 1 0\n  f 1  2\t3 4");
  CHECK(face(odd, 0) == Corners{0, 1, 2, 3});
}

TEST_CASE("a backslash continues a line, and lines are still counted") {
  CHECK(face(obj("v 0 0 0\nv 1 0 \\\n0\nv 1 1 0\nv 0 1 0\nf 1 2\\\r\n 3 \\\n \\\n4\n"), 0) == Corners{0, 1, 2, 3});
  CHECK(obj("v 0 0 0\nv 1 0 0\nv 1 1 0\ng a \\\n b\nf 1 2 3\n").face_records[0].value == "a b");
  CHECK(obj_complaint("v 0 0 \\\n0\nv 1 0 0\nf 1 2 \\\n\\\nx\n") ==
        "mesh:6: 'x' is not a corner; write v, v/vt, v//vn or v/vt/vn");
  CHECK(error_of("v 0 0 0\\", Format::Obj).code == ErrorCode::Empty);
}

TEST_CASE("a name that ends with a backslash does not swallow the next line when it is written again") {
  const MeshFile file = obj(with_vertices("mtllib odd\\ \ng left\\ \nf 1 2 3 4\n"));
  CHECK(file.material_libraries == std::vector<std::string>{"odd\\"});
  const MeshFile again = obj(format_mesh(file, Format::Obj));
  CHECK(again.material_libraries == file.material_libraries);
  REQUIRE(again.face_records.size() == 1);
  CHECK(again.face_records[0].value == "left\\");
  CHECK(again.mesh.face_count() == 1);
}

TEST_CASE("a comment is not continued by a backslash at its end") {
  const MeshFile file = obj(with_vertices("# C:\\meshes\\\nf 1 2 3 4\n"));
  CHECK(file.comments == std::vector<std::string>{"C:\\meshes\\"});
  CHECK(file.mesh.face_count() == 1);
}

TEST_CASE("comments are kept wherever they stand") {
  const MeshFile file = obj("#first\n" + with_vertices("f 1 2 3 4 # second\nv 1 2 3#third\n#\n"));
  CHECK(file.comments == std::vector<std::string>{"first", "second", "third", ""});
}

TEST_CASE("numbers may have a plus sign, an exponent, no digit before or after the point") {
  const MeshFile file = obj("v +1.5 -2. .25\nv 1e2 1E-2 +1.e+1\nv 12345678901234567890 0.1 1e-400\nf 1 2 3\n");
  CHECK(file.mesh.positions()[0] == Point{1.5, -2, 0.25});
  CHECK(file.mesh.positions()[1] == Point{100, 0.01, 10});
  CHECK(file.mesh.positions()[2] == Point{12345678901234567890.0, 0.1, 0});
}

TEST_CASE("weights and colours of vertices are kept") {
  const std::string weights = "v 0 0 0 2\nv 1 0 0 1\nv 1 1 0 0.5\nf 1 2 3\n";
  CHECK(find_property(obj(weights), "w")->values == std::vector<double>{2, 1, 0.5});
  CHECK(format_mesh(obj(weights), Format::Obj) == weights);
  const std::string colours = "v 0 0 0 1 0.5 0\nv 1 0 0 0 0 0\nv 1 1 0 1 1 0.25\nf 1 2 3\n";
  CHECK(find_property(obj(colours), "blue")->values == std::vector<double>{0, 0, 0.25});
  CHECK(format_mesh(obj(colours), Format::Obj) == colours);
  const std::string alphas = "v 0 0 0 1 0.5 0 1\nv 1 0 0 0 0 0 0\nv 1 1 0 1 1 0.25 1\nf 1 2 3\n";
  CHECK(format_mesh(obj(alphas), Format::Obj) == alphas);
}

TEST_CASE("a vertex without a colour among coloured ones is white, and a note says so") {
  const MeshFile file = obj("v 0 0 0\nv 1 0 0 0 0 0\nv 1 1 0\nf 1 2 3\n");
  CHECK(find_property(file, "red")->values == std::vector<double>{1, 0, 1});
  CHECK(file.notes == std::vector<std::string>{"2 of 3 vertices have no colour and are taken as white"});
}

TEST_CASE("texture coordinates of one, two or three numbers share a pool, in file order") {
  const MeshFile file = obj(with_vertices("vt 0.5\nvt 0.25 0.75\nvt 1 2 3\nf 1/3 2/2 3/1 4/1\n"));
  CHECK(file.texture_coordinates->components == 3);
  CHECK(file.texture_coordinates->values == std::vector<double>{0.5, 0, 0, 0.25, 0.75, 0, 1, 2, 3});
  CHECK(file.texture_coordinates->corner_index == Corners{2, 1, 0, 0});
}

TEST_CASE("pools that no corner uses are kept") {
  const MeshFile file = obj(with_vertices("vt 0.5 1\nvn 0 0 1\nf 1 2 3 4\n"));
  CHECK(file.texture_coordinates->corner_index == Corners{kNone, kNone, kNone, kNone});
  CHECK(file.normals->values == std::vector<double>{0, 0, 1});
}

TEST_CASE("a slash with nothing behind it is no index") {
  const MeshFile file = obj(with_vertices("vt 0 0\nf 1/ 2/1/ 3// 4\n"));
  CHECK(file.texture_coordinates->corner_index == Corners{kNone, 0, kNone, kNone});
}

TEST_CASE("records of other keywords are counted in a note") {
  const MeshFile file = obj(with_vertices("vp 1\nvp 1\nvp \\\n1\ncurv 0 1 2\nf 1 2 3 4\n"));
  CHECK(file.notes == std::vector<std::string>{"3 'vp' records were passed over", "1 'curv' record was passed over"});
}

TEST_CASE("a byte order mark in front of the first record is no part of it") {
  CHECK(obj("\xef\xbb\xbf" + with_vertices("f 1 2 3 4\n")).mesh.vertex_count() == 4);
}

TEST_CASE("an OBJ face that names what is not there is refused at its own line") {
  CHECK(obj_complaint(with_vertices("f 1 2 3 4\nf 1 2 9\nf 1 2 10\n")) ==
        "mesh:6: vertex 9 is named, but the file has only 4 vertices; correct it or export the mesh again");
  CHECK(obj_complaint(with_vertices("f 1 2 -5\n")) ==
        "mesh:5: vertex -5 is named, but only 4 vertices stand above this line; correct it or export the mesh again");
  CHECK(obj_complaint(with_vertices("f 0 1 2\n")) ==
        "mesh:5: vertex 0 is named, but OBJ counts from 1; correct it or export the mesh again");
  CHECK(obj_complaint(with_vertices("vt 0 0\nf 1/2 2 3\n")) ==
        "mesh:6: texture coordinate 2 is named, but the file has only 1 texture coordinates; correct it or export the "
        "mesh again");
  CHECK(obj_complaint(with_vertices("f 1//1 2 3\n")) ==
        "mesh:5: normal 1 is named, but the file has only 0 normals; correct it or export the mesh again");
  CHECK(error_of(with_vertices("f 1 2 3 4294967297\n"), Format::Obj).code == ErrorCode::BadIndex);
  CHECK(error_of(with_vertices("f 1 2 3 99999999999999999999\n"), Format::Obj).code == ErrorCode::BadIndex);
  CHECK(error_of(with_vertices("f 1 2 3 4\nl 1 7\n"), Format::Obj).line == 6);
}

TEST_CASE("of several dangling indices the first in the file is named") {
  const Error error = error_of(with_vertices("vt 0 0\nf 1 2 3/9\nf 1 2 77\n"), Format::Obj);
  CHECK(error.line == 6);
  CHECK(error.code == ErrorCode::BadIndex);
}

TEST_CASE("an OBJ face of fewer than three corners is refused") {
  CHECK(obj_complaint(with_vertices("f 1 2\n")) ==
        "mesh:5: a face needs at least three corners, but this one has 2; correct it or export the mesh again");
  CHECK(error_of(with_vertices("f\n"), Format::Obj).code == ErrorCode::TooFewCorners);
}

TEST_CASE("what is not a finite number is refused, in its own words") {
  CHECK(obj_complaint("v 0 nan 0\n") == "mesh:1: 'nan' is not a finite number; correct it or export the mesh again");
  CHECK(obj_complaint("v 0 0 -inf\n") == "mesh:1: '-inf' is not a finite number; correct it or export the mesh again");
  for (const char* const bad : {"1e999", "1.5x", "1,5", "--1", "1e", "0x10", ".", "-", "+", "1.2.3", "1-2"}) {
    CAPTURE(bad);
    const Error error = error_of("v 0 0 " + std::string(bad) + "\n", Format::Obj);
    CHECK(error.code == ErrorCode::BadNumber);
    CHECK(error.message.find('\'' + std::string(bad) + '\'') == 0);
  }
  for (const char* const bad : {"a", "1/a", "1/1/a", "1//a", "1.5", "1/2/3/4", "/1"}) {
    CAPTURE(bad);
    const Error error = error_of(with_vertices("f 1 2 " + std::string(bad) + "\n"), Format::Obj);
    CHECK(error.code == ErrorCode::BadNumber);
    CHECK(error.message == '\'' + std::string(bad) + "' is not a corner; write v, v/vt, v//vn or v/vt/vn");
  }
}

TEST_CASE("records of too few or too many numbers are refused") {
  CHECK(obj_complaint("v 1 2\n") ==
        "mesh:1: a vertex needs three coordinates, but this line has only 2; correct it or export the mesh again");
  CHECK(
      obj_complaint("v 1 2 3 4 5\n") ==
      "mesh:1: a vertex has 3 numbers, 4 with a weight, 6 with a colour or 7 with an alpha too, but not 5; correct it "
      "or export the mesh again");
  CHECK(error_of("v 1 2 3 4 5 6 7 8\n", Format::Obj).code == ErrorCode::Syntax);
  CHECK(error_of("vt\n", Format::Obj).code == ErrorCode::Syntax);
  CHECK(error_of("vt 1 2 3 4\n", Format::Obj).code == ErrorCode::Syntax);
  CHECK(error_of("vn 1 2\n", Format::Obj).code == ErrorCode::Syntax);
  CHECK(error_of("vn 1 2 3 4\n", Format::Obj).code == ErrorCode::Syntax);
}

TEST_CASE("a mesh without a face is refused as empty") {
  CHECK(obj_complaint("") == "mesh: the file is empty; export the mesh again");
  CHECK(obj_complaint(kFourVertices) == "mesh: the file has no faces; export the mesh with its faces");
  CHECK(error_of("\n\n", Format::Obj).code == ErrorCode::Empty);
}

TEST_CASE("bytes that no terminal can show do not reach a message") {
  const Error error = error_of("v 0 0 \x01\x80\x1b[31m\n", Format::Obj);
  CHECK(error.message == "'???[31m' is not a finite number; correct it or export the mesh again");
}

TEST_CASE("the first word tells the format where the name does not") {
  const auto format_of = [](std::string_view text) {
    const Expected<MeshFile> file = parse_mesh(text, "mesh");
    REQUIRE(file.has_value());
    return file->format;
  };
  CHECK(format_of(kFullObj) == Format::Obj);
  CHECK(format_of(kPly) == Format::Ply);
  CHECK(format_of(kOff) == Format::Off);
  CHECK(format_of(kUsda) == Format::Usda);
  const Expected<MeshFile> unknown = parse_mesh("solid cube\n", "mesh");
  REQUIRE_FALSE(unknown.has_value());
  CHECK(
      unknown.error().describe() ==
      "mesh: neither the name nor the first word tells the format; give it one of the endings .obj, .ply, .off, .usda");
  CHECK(format_of_path("a/b.c/Body.OBJ") == Format::Obj);
  CHECK(format_of_path("scene.usd") == Format::Usda);
  CHECK_FALSE(format_of_path("a.b/c").has_value());
}
