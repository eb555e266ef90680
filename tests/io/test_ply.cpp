// PLY: three encodings of one mesh are one mesh, and all properties survive.

#include <cmath>
#include <cstring>

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

MeshFile ply(std::string_view text) { return parsed(text, Format::Ply); }
std::string ply_complaint(std::string_view text) { return complaint(text, Format::Ply); }
std::string in(const MeshFile& file, PlyEncoding encoding) { return format_mesh(file, Format::Ply, {.ply = encoding}); }

void check_same_column(const Property& one, const Property& other) {
  CAPTURE(one.name);
  CHECK(one.name == other.name);
  CHECK(one.domain == other.domain);
  CHECK(one.type == other.type);
  CHECK(one.count_type == other.count_type);
  CHECK(one.list_starts == other.list_starts);
  CHECK(one.values == other.values);
}

void check_same_columns(const std::vector<Property>& one, const std::vector<Property>& other) {
  REQUIRE(one.size() == other.size());
  for (std::size_t i = 0; i < one.size(); ++i) check_same_column(one[i], other[i]);
}

/// A header of four vertices and some faces; `faces` stands behind `element face`.
std::string quad_ply(std::string_view faces, std::string_view rows) {
  return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement "
         "face " +
         std::string(faces) + "\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n" +
         std::string(rows);
}

/// The same in little-endian bytes: four vertices, one face.
std::string binary_quad() { return in(ply(quad_ply("1", "4 0 1 2 3\n")), PlyEncoding::LittleEndian); }

}  // namespace

TEST_CASE("PLY: vertices, faces, properties and further elements are found") {
  const MeshFile file = ply(kPly);
  CHECK(file.mesh.vertex_count() == 6);
  CHECK(face(file, 0) == Corners{0, 1, 2, 3});
  CHECK(face(file, 1) == Corners{1, 4, 5, 2});
  CHECK(file.position_type == ScalarType::Float32);
  CHECK(file.mesh.positions()[4][2] == static_cast<double>(0.1F));
  CHECK(file.comments == std::vector<std::string>{"two quads"});
  REQUIRE(file.properties.size() == 3);
  CHECK(file.properties[0].name == "red");
  CHECK(file.properties[0].values == std::vector<double>{0, 10, 20, 30, 40, 255});
  CHECK(file.properties[1].domain == Domain::Face);
  CHECK(file.properties[1].values == std::vector<double>{-7, 300});
  CHECK(file.properties[2].list_starts == std::vector<std::uint32_t>{0, 8, 8});
  REQUIRE(file.further_elements.size() == 1);
  CHECK(file.further_elements[0].name == "edge");
  CHECK(file.further_elements[0].properties[2].values == std::vector<double>{0.25, 1e300});
  CHECK(file.notes.empty());
}

TEST_CASE("PLY: ascii, little-endian and big-endian files of one mesh read the same") {
  const MeshFile original = ply(kPly);
  const std::string ascii = in(original, PlyEncoding::Ascii);
  for (const PlyEncoding encoding : {PlyEncoding::Ascii, PlyEncoding::LittleEndian, PlyEncoding::BigEndian}) {
    const MeshFile again = ply(in(original, encoding));
    check_same_mesh(original.mesh, again.mesh);
    CHECK(again.position_type == original.position_type);
    check_same_columns(original.properties, again.properties);
    REQUIRE(again.further_elements.size() == 1);
    check_same_columns(original.further_elements[0].properties, again.further_elements[0].properties);
    CHECK(in(again, PlyEncoding::Ascii) == ascii);
  }
  CHECK(in(original, PlyEncoding::LittleEndian) != in(original, PlyEncoding::BigEndian));
}

TEST_CASE("PLY: every type of number keeps its extremes in every encoding") {
  const MeshFile original =
      ply("ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
          "property char a\nproperty uint8 b\nproperty int16 c\nproperty ushort d\nproperty int e\nproperty uint32 f\n"
          "property float g\nproperty float64 h\nelement face 1\nproperty list int uint vertex_index\nend_header\n"
          "0 0 0 -128 255 -32768 65535 -2147483648 4294967295 3.4028235e38 1.7976931348623157e308\n"
          "1 0 0 127 0 32767 0 2147483647 0 1e-45 5e-324\n"
          "1 1 0 0 1.0 2e2 3 4 5 nan -inf\n"
          "3 0 1 2\n");
  CHECK(find_property(original, "f")->values[0] == 4294967295.0);
  CHECK(find_property(original, "c")->values[2] == 200);
  for (const PlyEncoding encoding : {PlyEncoding::Ascii, PlyEncoding::LittleEndian, PlyEncoding::BigEndian}) {
    const MeshFile again = ply(in(original, encoding));
    REQUIRE(again.properties.size() == original.properties.size());
    for (std::size_t i = 0; i < 6; ++i) check_same_column(original.properties[i], again.properties[i]);
    CHECK(std::isnan(find_property(again, "g")->values[2]));
    CHECK(find_property(again, "g")->values[0] == find_property(original, "g")->values[0]);
    CHECK(find_property(again, "h")->values == find_property(original, "h")->values);
  }
}

TEST_CASE("PLY: a big-endian file is read as its bytes say") {
  std::string text =
      "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty short x\nproperty short y\nproperty short z\n"
      "element face 1\nproperty list uchar ushort vertex_indices\nend_header\n";
  text += std::string(
      "\0\0\0\0\0\0"
      "\1\0\0\0\0\0"
      "\xff\xff\0\2\0\0"
      "\3\0\0\0\1\0\2",
      25);
  const MeshFile file = ply(text);
  CHECK(file.mesh.positions()[1] == Point{256, 0, 0});
  CHECK(file.mesh.positions()[2] == Point{-1, 2, 0});
  CHECK(face(file, 0) == Corners{0, 1, 2});
}

TEST_CASE("PLY: texture coordinates of an OBJ become a list for each face") {
  const MeshFile file = ply(format_mesh(parsed(kFullObj, Format::Obj), Format::Ply));
  const Property* const list = find_property(file, "texcoord");
  REQUIRE(list != nullptr);
  CHECK(list->domain == Domain::Face);
  CHECK(list->list_starts == std::vector<std::uint32_t>{0, 8, 16});
  CHECK(list->values == std::vector<double>{0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0});
}

TEST_CASE("PLY: colours in bytes become colours from 0 to 1 in OBJ") {
  const MeshFile file = ply(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
      "red\n"
      "property uchar green\nproperty uchar blue\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0 255 0 51\n1 0 0 0 0 0\n1 1 0 0 0 0\n3 0 1 2\n");
  CHECK(format_mesh(file, Format::Obj).find("v 0 0 0 1 0 0.2\n") == 0);
}

TEST_CASE("PLY: faces may stand before vertices, and lines may end in CR LF") {
  const MeshFile file =
      ply("ply\r\nformat ascii 1.0\r\nelement face 1\r\nproperty list uchar int vertex_index\r\nelement vertex 3\r\n"
          "property float y\r\nproperty float x\r\nproperty float z\r\nend_header\r\n3 0 1 2\r\n1 0 0\r\n\r\n2 0 "
          "0\r\n3 0 0\r\n");
  CHECK(face(file, 0) == Corners{0, 1, 2});
  CHECK(file.mesh.positions()[1] == Point{0, 2, 0});
}

TEST_CASE("PLY: a mesh without positions is a mesh") {
  const MeshFile file = ply(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty int id\nelement face 1\nproperty list uchar int vertex_index\n"
      "end_header\n7\n8\n9\n3 0 1 2\n");
  CHECK(file.mesh.positions().empty());
  CHECK(file.notes == std::vector<std::string>{"the vertices have no positions"});
}

TEST_CASE("PLY: data beyond what the header declares is passed over with a note") {
  const MeshFile file = ply(quad_ply("1", "4 0 1 2 3\n3 0 1 2\n"));
  CHECK(file.mesh.face_count() == 1);
  CHECK(file.notes == std::vector<std::string>{"there is more data than the header declares; it was passed over"});
}

TEST_CASE("PLY: faces that name missing vertices or have too few corners are refused at their line") {
  CHECK(
      ply_complaint(quad_ply("2", "4 0 1 2 3\n\n3 0 1 4\n")) ==
      "mesh:16: face 1 names vertex 4, but the file has only 4 vertices, counted from 0; correct it or export the mesh "
      "again");
  CHECK(error_of(quad_ply("1", "3 0 1 -1\n"), Format::Ply).code == ErrorCode::BadIndex);
  CHECK(ply_complaint(quad_ply("1", "2 0 1\n")) ==
        "mesh:14: a face needs at least three corners, but face 0 has 2; correct it or export the mesh again");
  std::string binary = binary_quad();
  binary[binary.size() - 4] = 9;
  CHECK(ply_complaint(binary) ==
        "mesh: face 0 names vertex 9, but the file has only 4 vertices, counted from 0; correct it or export the mesh "
        "again");
}

TEST_CASE("PLY: lists that are shorter or longer than their count are refused") {
  CHECK(ply_complaint(quad_ply("1", "4 0 1 2\n")) ==
        "mesh:14: face 1 of 1 has fewer numbers than the header and its list counts ask for; correct it or export the "
        "mesh again");
  CHECK(
      ply_complaint(quad_ply("1", "3 0 1 2 3\n")) ==
      "mesh:14: face 1 of 1 has more numbers than the header and its list counts allow; correct it or export the mesh "
      "again");
  CHECK(ply_complaint(quad_ply("1", "300 0 1 2 3\n")) ==
        "mesh:14: '300' does not fit its type in the header; correct it or export the mesh again");
}

TEST_CASE("PLY: a file that ends too early is refused, and huge counts take no memory") {
  CHECK(ply_complaint(quad_ply("2", "4 0 1 2 3\n")) ==
        "mesh:15: the file ends before face 2 of 2; export the mesh again");
  const std::string binary = binary_quad();
  CHECK(ply_complaint(std::string_view(binary).substr(0, binary.size() - 1)) ==
        "mesh: the file ends within face 1 of 1; export the mesh again");
  CHECK(error_of(quad_ply("4000000000", "4 0 1 2 3\n"), Format::Ply).code == ErrorCode::Truncated);
  CHECK(error_of(quad_ply("5000000000", "4 0 1 2 3\n"), Format::Ply).code == ErrorCode::TooLarge);
  std::string huge_list = binary;
  huge_list[huge_list.size() - 17] = static_cast<char>(255);
  CHECK(error_of(huge_list, Format::Ply).code == ErrorCode::Truncated);
}

TEST_CASE("PLY: numbers that are not numbers are refused at their line") {
  std::string text = quad_ply("1", "4 0 1 2 3\n");
  text.replace(text.find("1 1 0"), 5, "1 x 0");
  CHECK(ply_complaint(text) == "mesh:12: 'x' does not fit its type in the header; correct it or export the mesh again");
  text.replace(text.find("1 x 0"), 5, "nan 1 0");
  CHECK(ply_complaint(text) ==
        "mesh:12: a coordinate of vertex 2 is not a finite number; correct it or export the mesh again");
}

TEST_CASE("PLY: headers that make no sense are refused at their line") {
  const auto header = [](std::string_view lines) { return "ply\n" + std::string(lines) + "end_header\n"; };
  CHECK(ply_complaint("solid\n") ==
        "mesh:1: a PLY file begins with the line 'ply'; check the name or export the mesh again");
  CHECK(ply_complaint("ply\nformat ascii 1.0\n") == "mesh:3: the file ends before 'end_header'; export the mesh again");
  CHECK(ply_complaint(header("format text 1.0\n")) ==
        "mesh:2: the format 'text' is not known; export the mesh as ascii, binary_little_endian or binary_big_endian");
  CHECK(error_of(header("format ascii 2.0\n"), Format::Ply).code == ErrorCode::Syntax);
  CHECK(error_of(header(""), Format::Ply).message ==
        "the header has no line 'format'; correct it or export the mesh again");
  const std::string ascii = "format ascii 1.0\n";
  CHECK(ply_complaint(header(ascii + "property int x\n")) ==
        "mesh:3: a property stands before the first element; correct it or export the mesh again");
  CHECK(ply_complaint(header(ascii + "element vertex -1\n")) ==
        "mesh:3: an element needs a name and a count from 0; correct it or export the mesh again");
  CHECK(ply_complaint(header(ascii + "element vertex 1\nproperty quad x\n")) ==
        "mesh:4: 'quad' is not a type of numbers; correct it or export the mesh again");
  CHECK(ply_complaint(header(ascii + "elephant\n")) ==
        "mesh:3: the header has no lines 'elephant'; correct it or export the mesh again");
  CHECK(error_of(header(ascii + "element vertex 1\n"), Format::Ply).message ==
        "element 'vertex' has no properties; correct it or export the mesh again");
  CHECK(error_of(header(ascii + "element a 0\nproperty int x\nproperty int x\n"), Format::Ply).message ==
        "property 'x' of element 'a' is declared twice; correct it or export the mesh again");
  CHECK(error_of(header(ascii + "element a 0\nelement a 0\n"), Format::Ply).message ==
        "element 'a' is declared twice; correct it or export the mesh again");
  CHECK(error_of(header(ascii + "element face 1\nproperty list float int vertex_indices\n"), Format::Ply).message ==
        "a list is counted in whole numbers; correct it or export the mesh again");
  CHECK(error_of(header(ascii + "element face 1\nproperty int vertex_indices\n") + "1\n", Format::Ply).message ==
        "the faces have no list 'vertex_indices' of whole numbers; correct it or export the mesh again");
}

TEST_CASE("PLY: a file without faces is empty, and triangle strips are named") {
  CHECK(ply_complaint(quad_ply("0", "")) == "mesh: the file has no faces; export the mesh with its faces");
  CHECK(ply_complaint("ply\nformat ascii 1.0\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                      "3 0 1 2\n") == "mesh: the file has triangle strips but no faces; export the mesh with polygons");
}
