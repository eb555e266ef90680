// OFF with and without what its keyword announces.

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

MeshFile off(std::string_view text) { return parsed(text, Format::Off); }
std::string off_complaint(std::string_view text) { return complaint(text, Format::Off); }

}  // namespace

TEST_CASE("OFF: vertices, faces and comments are found, and come back byte by byte") {
  const MeshFile file = off(kOff);
  CHECK(face(file, 1) == Corners{1, 4, 5, 2});
  CHECK(file.mesh.positions()[5] == Point{2, 1, 1e-3});
  CHECK(file.comments == std::vector<std::string>{"two quads"});
  const std::string written = format_mesh(file, Format::Off);
  CHECK(written == "OFF\n# two quads\n6 2 7\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0.1\n2 1 0.001\n4 0 1 2 3\n4 1 4 5 2\n");
  check_same_mesh(off(written).mesh, file.mesh);
}

TEST_CASE("OFF: the keyword may share its line with the counts, or be missing") {
  const std::string_view rest = "0 0 0\n1 0 0\n1 1 0\n3 0 1 2\n";
  CHECK(off("OFF 3 1 0\n" + std::string(rest)).mesh.face_count() == 1);
  CHECK(off("3 1\n" + std::string(rest)).mesh.face_count() == 1);
  CHECK(off("# first\n\nOFF # keyword\n\n3 1 0 # counts\n" + std::string(rest)).comments.size() == 3);
}

TEST_CASE("OFF: normals, colours and texture coordinates of vertices are kept") {
  const std::string text =
      "STCNOFF\n3 1 3\n0 0 0 0 0 1 1 0.5 0 1 0 0\n1 0 0 0 0 1 0 0 0 1 1 0\n"
      "1 1 0 0 0 1 0 0 0.25 1 1 1\n3 0 1 2\n";
  const MeshFile file = off(text);
  CHECK(find_property(file, "nz")->values == std::vector<double>{1, 1, 1});
  CHECK(find_property(file, "green")->values == std::vector<double>{0.5, 0, 0});
  CHECK(find_property(file, "alpha")->values == std::vector<double>{1, 1, 1});
  CHECK(find_property(file, "t")->values == std::vector<double>{0, 0, 1});
  CHECK(format_mesh(file, Format::Off) == text);
}

TEST_CASE("OFF: colours in whole numbers above 1 are bytes, and missing ones white") {
  const MeshFile file = off("COFF\n3 1 0\n0 0 0\n1 0 0 255 128 0\n1 1 0\n3 0 1 2\n");
  CHECK(find_property(file, "red")->type == ScalarType::UInt8);
  CHECK(find_property(file, "green")->values == std::vector<double>{255, 128, 255});
}

TEST_CASE("OFF: colours of faces are passed over with a note") {
  const MeshFile file = off("OFF\n3 2 0\n0 0 0\n1 0 0\n1 1 0\n3 0 1 2 255 0 0\n3 2 1 0\n");
  CHECK(file.mesh.face_count() == 2);
  CHECK(file.notes == std::vector<std::string>{"the colours of 1 faces were not kept"});
}

TEST_CASE("OFF: what is wrong is named with its line") {
  CHECK(off_complaint("solid\n") ==
        "mesh:1: an OFF file begins with the word 'OFF'; check the name or export the mesh again");
  CHECK(off_complaint("4OFF\n") ==
        "mesh:1: '4OFF' files are not understood; export the mesh with three coordinates as OFF, COFF or NOFF");
  CHECK(off_complaint("OFF BINARY\n") == "mesh:1: this is a binary OFF file; export it as text");
  CHECK(off_complaint("OFF\n") == "mesh:2: the file ends before its counts; export the mesh again");
  CHECK(off_complaint("OFF\n3 x 0\n") ==
        "mesh:2: 'x' is not a count of vertices or faces; correct it or export the mesh again");
  CHECK(error_of("OFF\n-3 1 0\n", Format::Off).code == ErrorCode::BadNumber);
  CHECK(error_of("OFF\n5000000000 1 0\n", Format::Off).code == ErrorCode::TooLarge);
  CHECK(off_complaint("OFF\n4000000000 1 0\n0 0 0\n") ==
        "mesh:4: the file ends before vertex 2 of 4000000000; export the mesh again");
  const std::string vertices = "OFF\n3 1 0\n0 0 0\n1 0 0\n1 1 0\n";
  CHECK(off_complaint(vertices) == "mesh:6: the file ends before face 1 of 1; export the mesh again");
  CHECK(off_complaint(vertices + "3 0 1 3\n") ==
        "mesh:6: vertex 3 is named, but the file has only 3 vertices, counted from 0; correct it or export the mesh "
        "again");
  CHECK(off_complaint(vertices + "2 0 1\n") ==
        "mesh:6: a face needs at least three corners, but this one has 2; correct it or export the mesh again");
  CHECK(off_complaint(vertices + "4 0 1 2\n") ==
        "mesh:6: the face has only 3 of its 4 corners; correct it or export the mesh again");
  CHECK(off_complaint(vertices + "3 0 1 b\n") ==
        "mesh:6: 'b' is not the number of a vertex; correct it or export the mesh again");
  CHECK(off_complaint("OFF\n3 1 0\n0 0 0\n1 0\n") ==
        "mesh:4: vertex 2 of 3 has too few numbers; correct it or export the mesh again");
  CHECK(off_complaint("OFF\n3 1 0\n0 0 inf\n") ==
        "mesh:3: 'inf' is not a finite number; correct it or export the mesh again");
  CHECK(error_of("OFF\n3 1 0\n0 0 0 1 2\n", Format::Off).code == ErrorCode::Syntax);
  CHECK(error_of("OFF\n3 1 0\n0 0 0 1 2 3 4 5\n", Format::Off).code == ErrorCode::Syntax);
  CHECK(error_of("OFF\n0 0 0\n", Format::Off).code == ErrorCode::Empty);
}
