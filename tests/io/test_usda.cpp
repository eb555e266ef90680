// USD text: meshes anywhere in the scene, and what lies around them.

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

MeshFile usda(std::string_view text) { return parsed(text, Format::Usda); }
std::string usda_complaint(std::string_view text) { return complaint(text, Format::Usda); }

/// A mesh prim of one quad with more attributes.
std::string quad_usda(std::string_view attributes, std::string_view name = "quad") {
  return "#usda 1.0\ndef Mesh \"" + std::string(name) +
         "\"\n{\n"
         "    int[] faceVertexCounts = [4]\n    int[] faceVertexIndices = [0, 1, 2, 3]\n"
         "    point3f[] points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]\n" +
         std::string(attributes) + "}\n";
}

}  // namespace

TEST_CASE("USD: a mesh is found inside other prims, with its texture coordinates and normals") {
  const MeshFile file = usda(kUsda);
  CHECK(file.mesh.vertex_count() == 6);
  CHECK(face(file, 1) == Corners{1, 4, 5, 2});
  CHECK(file.mesh.positions()[5] == Point{2, 1, 1e-3});
  REQUIRE(file.texture_coordinates);
  CHECK(file.texture_coordinates->corner_index == Corners{0, 1, 2, 3, 0, 1, 2, 3});
  REQUIRE(file.normals);
  CHECK(file.normals->corner_index == Corners{0, 1, 2, 3, 1, 4, 5, 2});
  REQUIRE(file.face_records.size() == 1);
  CHECK(file.face_records[0].keyword == "o");
  CHECK(file.face_records[0].value == "body");
  CHECK(file.notes == std::vector<std::string>{"transforms (xformOp) were ignored; points are as each mesh states them",
                                               "1 'material:binding' part was passed over"});
}

TEST_CASE("USD: what is written reads the same") {
  const MeshFile file = usda(kUsda);
  const MeshFile again = usda(format_mesh(file, Format::Usda));
  check_same_mesh(file.mesh, again.mesh);
  CHECK(again.texture_coordinates->values == file.texture_coordinates->values);
  CHECK(again.texture_coordinates->corner_index == file.texture_coordinates->corner_index);
  CHECK(again.normals->corner_index == file.normals->corner_index);
  CHECK(again.notes.empty());
  CHECK(format_mesh(again, Format::Usda) == format_mesh(file, Format::Usda));
}

TEST_CASE("USD: corners without texture coordinates stay without") {
  const MeshFile obj = parsed(kFullObj, Format::Obj);
  const MeshFile file = usda(format_mesh(obj, Format::Usda));
  CHECK(file.texture_coordinates->corner_index == obj.texture_coordinates->corner_index);
  CHECK(file.comments == obj.comments);
}

TEST_CASE("USD: several meshes are joined in file order and written apart again") {
  const std::string two = quad_usda(
                              "    texCoord2f[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (\n"
                              "        interpolation = \"vertex\"\n    )\n",
                              "a") +
                          quad_usda("", "b").substr(10);
  const MeshFile file = usda(two);
  CHECK(file.mesh.vertex_count() == 8);
  CHECK(face(file, 1) == Corners{4, 5, 6, 7});
  REQUIRE(file.face_records.size() == 2);
  CHECK(file.face_records[1].first_face == 1);
  CHECK(file.face_records[1].value == "b");
  constexpr std::uint32_t kNone = IndexedAttribute::kNoIndex;
  CHECK(file.texture_coordinates->corner_index == Corners{0, 1, 2, 3, kNone, kNone, kNone, kNone});
  const std::string written = format_mesh(file, Format::Usda);
  CHECK(written.find("def Mesh \"a\"") != written.npos);
  CHECK(written.find("def Mesh \"b\"") != written.npos);
  const MeshFile again = usda(written);
  check_same_mesh(file.mesh, again.mesh);
  CHECK(again.texture_coordinates->corner_index == file.texture_coordinates->corner_index);
}

TEST_CASE("USD: objects that share vertices are written as one prim") {
  const MeshFile file = parsed("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no a\nf 1 2 3\no b\nf 1 3 4\n", Format::Obj);
  const MeshFile again = usda(format_mesh(file, Format::Usda));
  check_same_mesh(file.mesh, again.mesh);
  CHECK(again.face_records.size() == 1);
}

TEST_CASE("USD: a left-handed mesh is turned over, corner data and all") {
  const MeshFile file = usda(
      quad_usda("    uniform token orientation = \"leftHanded\"\n"
                "    float2[] primvars:st = [(0, 0), (1, 0), (1, 1), (0, 1)] (interpolation = \"faceVarying\")\n"));
  CHECK(face(file, 0) == Corners{0, 3, 2, 1});
  CHECK(file.texture_coordinates->corner_index == Corners{0, 3, 2, 1});
  CHECK(file.notes == std::vector<std::string>{"mesh 'quad' is left-handed; its faces were turned over"});
}

TEST_CASE("USD: values that do not fit their mesh are dropped with a note, the mesh is not") {
  const MeshFile file = usda(quad_usda("    normal3f[] normals = [(0, 0, 1), (0, 0, 1)]\n"));
  CHECK_FALSE(file.normals.has_value());
  CHECK(file.notes == std::vector<std::string>{"mesh 'quad': 2 'normals' do not fit its faces and were not kept"});
}

TEST_CASE("USD: one value for all corners, or for each face, is understood") {
  CHECK(
      usda(quad_usda("    normal3f[] normals = [(0, 0, 1)] (interpolation = \"constant\")\n")).normals->corner_index ==
      Corners{0, 0, 0, 0});
  CHECK(usda(quad_usda("    normal3f[] normals = [(0, 0, 1)] (interpolation = \"uniform\")\n")).normals->corner_index ==
        Corners{0, 0, 0, 0});
}

TEST_CASE("USD: the grammar around meshes is passed over") {
  const MeshFile file = usda(
      "#usda 1.0\n(\n  customLayerData = {\n    string a = \"}\"\n    dictionary b = { int c = 1 }\n  }\n)\n"
      "over \"x\" (\n  references = @a.usda@</b> (offset = 1)\n  variants = { string look = \"red\" }\n)\n{\n"
      "  variantSet \"look\" = {\n    \"red\" {\n      def Mesh \"hidden\" { }\n    }\n  }\n"
      "  reorder nameChildren = [\"b\", \"a\"]\n  custom double unset\n  token outputs:surface.connect = </m.out>\n"
      "  asset file = @@@odd@name@@@\n  string text = '''a\n#no comment\n'''\n  rel all = [</a>, </b>]\n"
      "  float x.timeSamples = {\n 0: 1,\n 1: (2, 3),\n }\n"
      "  class Mesh \"abstract\" { int[] faceVertexCounts = [9] }\n"
      "  def Mesh \"m\" (kind = \"component\"; doc = 'a ) in a string')\n  {\n"
      "    int[] faceVertexCounts = [3]; int[] faceVertexIndices = [0, 1, 2]\n"
      "    point3f[] points.timeSamples = {\n      1: [(0, 0, 0), (1, 0, 0), (1, 1, 0)],\n      2: [(9, 9, 9)],\n    "
      "}\n"
      "    color3f[] primvars:displayColor = [(1, 0, 0)] ( interpolation = \"constant\" )\n"
      "    point3f[] velocities = None\n"
      "    def GeomSubset \"s\" { int[] indices = [0] }\n  }\n}\n");
  CHECK(file.mesh.face_count() == 1);
  CHECK(file.mesh.positions()[1] == Point{1, 0, 0});
  CHECK(file.notes == std::vector<std::string>{"of points that move only the first time sample was read",
                                               "1 'variantSet' part was passed over",
                                               "1 'displayColor' part was passed over",
                                               "1 'GeomSubset' part was passed over"});
}

TEST_CASE("USD: binary files are refused with the way out") {
  CHECK(usda_complaint("PXR-USDC\0\0") == "mesh: this is a binary USD file; export it as .usda text");
  CHECK(usda_complaint("PK\x03\x04") == "mesh: this is a binary USD file; export it as .usda text");
  CHECK(usda_complaint("ply\n") ==
        "mesh:1: a USD text file begins with '#usda 1.0'; check the name or export the mesh as .usda");
}

TEST_CASE("USD: what is wrong is named with its line and its mesh") {
  const auto with = [](std::string_view from, std::string_view to) {
    std::string text = quad_usda("");
    text.replace(text.find(from), from.size(), to);
    return text;
  };
  CHECK(
      usda_complaint(with("[0, 1, 2, 3]", "[0, 1, 2, 4]")) ==
      "mesh:5: mesh 'quad': face 0 names point 4, but there are only 4, counted from 0; correct it or export the mesh "
      "again");
  CHECK(usda_complaint(with("[0, 1, 2, 3]", "[0, 1, 2]")) ==
        "mesh:4: mesh 'quad': faceVertexCounts asks for 4 corners, but faceVertexIndices has 3; correct it or export "
        "the mesh again");
  CHECK(usda_complaint(with("[4]", "[2, 2]")) ==
        "mesh:4: mesh 'quad': a face needs at least three corners, but face 0 has 2; correct it or export the mesh "
        "again");
  CHECK(error_of(with("[4]", "[9000000000, 9000000000]"), Format::Usda).code == ErrorCode::TooLarge);
  CHECK(usda_complaint(with("(1, 1, 0)", "(1, nan, 0)")) ==
        "mesh:6: 'nan, 0), (0, 1, 0)]' does not begin with a finite number of its type; correct it or export the mesh "
        "again");
  CHECK(usda_complaint(with("(1, 1, 0)", "(1, 1)")) ==
        "mesh:6: there should be ',' at '), (0, 1, 0)]'; correct it or export the mesh again");
  CHECK(usda_complaint(with("[4]", "4")) == "mesh:4: there should be '[' at '4'; correct it or export the mesh again");
  const std::string whole = quad_usda("");
  CHECK(usda_complaint(std::string_view(whole).substr(0, whole.size() - 2)) ==
        "mesh:7: the file ends within prim 'quad'; export the mesh again");
  CHECK(error_of("#usda 1.0\n", Format::Usda).code == ErrorCode::Empty);
}
