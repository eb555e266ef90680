#include <quadmatch/use/transfer.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/shirt.hpp>

#include "io/io_support.hpp"
#include "mesh/named_meshes.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

constexpr std::uint32_t kNoIndex = IndexedAttribute::kNoIndex;

/// A model as a file: groups, materials, smoothing, texture coordinates shared by corners at one place of the texture.
MeshFile file_of(const shapes::Model& model) {
  MeshFile file{.mesh = build(model.soup)};
  file.material_libraries = {"model.mtl"};
  file.face_records = {{0, "o", "model"}, {0, "s", "1"}};
  for (const shapes::ModelPart& part : model.parts) {
    file.face_records.push_back({part.first_face, "g", part.name});
    file.face_records.push_back({part.first_face, "usemtl", part.material});
  }
  IndexedAttribute pool{2, {}, {}};
  std::map<shapes::TextureCoordinate, std::uint32_t> index_of;
  for (const shapes::TextureCoordinate& coordinate : model.coordinates) {
    const auto [place, is_new] = index_of.emplace(coordinate, static_cast<std::uint32_t>(index_of.size()));
    if (is_new) pool.values.insert(pool.values.end(), coordinate.begin(), coordinate.end());
    pool.corner_index.push_back(place->second);
  }
  file.texture_coordinates = std::move(pool);
  return file;
}

MeshFile bare(const PolygonSoup& soup) { return {.mesh = build(soup)}; }

/// The same, moved up.
PolygonSoup lifted(PolygonSoup soup) {
  for (Point& position : soup.positions) position[2] += 1;
  return soup;
}

Match found(const MeshFile& source, const MeshFile& target, const MatchOptions& options = {}) {
  return match(source.mesh, target.mesh, options).match;
}

Transferred transferred(const MeshFile& source, const MeshFile& target, const Match& match,
                        const TransferOptions& options = {}) {
  Expected<Transferred> result = transfer(source, target, match, options);
  if (!result) FAIL(result.error().describe());
  return *std::move(result);
}

/// Corner pairs of true face pairs, orientation preserving.
std::vector<std::pair<HalfedgeId, HalfedgeId>> corner_pairs(const Mesh& source, const Mesh& target,
                                                            const std::vector<FacePair>& faces,
                                                            Orientation orientation = Orientation::Preserving) {
  std::vector<std::pair<HalfedgeId, HalfedgeId>> pairs;
  for (const FacePair& pair : faces) {
    const std::uint32_t size = source.size(pair.source);
    for (std::uint32_t i = 0; i < size; ++i) {
      const std::uint32_t image = image_corner(orientation, pair.rotation, i, size);
      pairs.emplace_back(source.first(pair.source).value + i, target.first(pair.target).value + image);
    }
  }
  return pairs;
}

std::vector<double> tuple_at(const IndexedAttribute& pool, HalfedgeId corner) {
  const std::uint32_t index = pool.corner_index[corner.value];
  if (index == kNoIndex) return {};
  const auto begin = pool.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{index} * pool.components);
  return {begin, begin + pool.components};
}

/// How many of the true corners have another value than in the source, and whether the same corners share an entry.
std::size_t count_wrong(const MeshFile& source, const MeshFile& result,
                        const std::vector<std::pair<HalfedgeId, HalfedgeId>>& pairs) {
  std::size_t wrong = 0;
  std::map<std::uint32_t, std::uint32_t> image_of, origin_of;
  for (const auto& [there, here] : pairs) {
    if (tuple_at(*source.texture_coordinates, there) != tuple_at(*result.texture_coordinates, here)) ++wrong;
    const std::uint32_t from = source.texture_coordinates->corner_index[there.value];
    const std::uint32_t to = result.texture_coordinates->corner_index[here.value];
    CHECK(image_of.emplace(from, to).first->second == to);
    CHECK(origin_of.emplace(to, from).first->second == from);
  }
  return wrong;
}

const TransferredAttribute& entry(const Transferred& result, std::string_view name) {
  for (const TransferredAttribute& attribute : result.report.attributes) {
    if (attribute.name == name) return attribute;
  }
  FAIL("nothing is reported of " << name);
  return result.report.attributes.front();
}

/// What holds at each face: "body|skin".
std::vector<std::string> states(const MeshFile& file, std::string_view keyword) {
  std::vector<std::string> result(file.mesh.face_count());
  for (const FaceRecord& record : file.face_records) {
    if (record.keyword == keyword) {
      std::fill(result.begin() + record.first_face, result.end(), record.value);
    }
  }
  return result;
}

/// OBJ without the lines of vertices and without comments.
std::string all_but_vertices(const MeshFile& file) {
  const std::string text = format_mesh(file, Format::Obj);
  std::string rest;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at) + 1;
    const std::string line = text.substr(at, end - at);
    if (!line.starts_with("v ") && !line.starts_with("#")) rest += line;
    at = end;
  }
  return rest;
}

/// A flat grid of m by n unit quads, with texture coordinates like its positions.
MeshFile flat(std::uint32_t m, std::uint32_t n) {
  MeshFile file = bare(shapes::grid(m, n));
  IndexedAttribute pool{2, {}, {}};
  for (const Point& point : file.mesh.positions()) {
    pool.values.push_back(3 * point[0] + 1);
    pool.values.push_back(point[0] - 2 * point[1]);
  }
  for (const VertexId v : file.mesh.corners()) pool.corner_index.push_back(v.value);
  file.texture_coordinates = std::move(pool);
  return file;
}

/// A mesh on itself face by face, but for some faces.
Match identity_without(const Mesh& mesh, const std::set<std::uint32_t>& left_out) {
  Match match;
  match.regions.emplace_back();
  std::set<std::uint32_t> vertices;
  for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
    if (left_out.contains(f)) continue;
    match.regions.front().faces.push_back({FaceId(f), FaceId(f), 0});
    for (const HalfedgeId h : mesh.halfedges(FaceId(f))) vertices.insert(mesh.origin(h).value);
  }
  for (const std::uint32_t v : vertices) match.vertices.push_back({VertexId(v), VertexId(v)});
  return match;
}

/// The middle of a grid of 9 by 9, five by five faces.
std::set<std::uint32_t> middle_of_nine() {
  std::set<std::uint32_t> faces;
  for (std::uint32_t row = 2; row < 7; ++row) {
    for (std::uint32_t column = 2; column < 7; ++column) faces.insert(9 * row + column);
  }
  return faces;
}

}  // namespace

TEST_CASE("texture coordinates stripped from a renumbered copy come back exactly, and seams stay seams") {
  for (const shapes::Model& model : {shapes::shirt(shapes::Sleeves::Long), shapes::bear()}) {
    const MeshFile source = file_of(model);
    const shapes::Renumbered copy = shapes::renumbered(model.soup, 5);
    const MeshFile target = bare(copy.soup);
    const Transferred result = transferred(source, target, found(source, target));
    CHECK(result.report.complete());
    CHECK(count_wrong(source, result.file, corner_pairs(source.mesh, target.mesh, copy.faces)) == 0);
    CHECK(result.file.texture_coordinates->values == source.texture_coordinates->values);
    CHECK(entry(result, "texture coordinates").carried == target.mesh.halfedge_count());
    const std::vector<std::string> groups = states(source, "g"), carried = states(result.file, "g");
    for (const FacePair& pair : copy.faces) CHECK(carried[pair.target.value] == groups[pair.source.value]);
    CHECK(result.file.material_libraries == source.material_libraries);
  }
}

TEST_CASE("after an edit the surviving corners have exactly what they had, and the new ones nothing") {
  const shapes::Model model = shapes::shirt(shapes::Sleeves::Short);
  const MeshFile source = file_of(model);
  const Mesh& mesh = source.mesh;
  for (const Expected<shapes::Edit>& edit :
       {shapes::delete_patch(model.soup, FaceId(700), 30), shapes::insert_edge_loop(model.soup, mesh.first(FaceId(90))),
        shapes::rip_edges(model.soup, mesh.first(FaceId(400)), 4)}) {
    REQUIRE(edit.has_value());
    const shapes::Renumbered copy = shapes::renumbered(edit->soup, 2);
    const MeshFile target = bare(copy.soup);
    const std::vector<FacePair> truth = shapes::chained(edit->truth, copy.faces, copy.soup);
    const Match match = found(source, target);
    const Transferred result = transferred(source, target, match);
    const auto pairs = corner_pairs(source.mesh, target.mesh, truth);
    CHECK(count_wrong(source, result.file, pairs) == 0);
    const TransferredAttribute& report = entry(result, "texture coordinates");
    CHECK(report.carried + report.without == target.mesh.halfedge_count());
    CHECK(report.carried == 4 * result.report.matched_faces);
    // Of a row that was split, which half is the old one cannot be known.
    CHECK(result.report.matched_faces >= truth.size());
    CHECK(result.report.left_out.empty() == (edit->soup.corners.size() <= model.soup.corners.size()));
  }
}

TEST_CASE("onto a mirror image data are carried the other way round") {
  const shapes::Model model = shapes::bear();
  const MeshFile source = file_of(model);
  const MeshFile target{.mesh = source.mesh.mirrored()};
  const Match match = found(source, target, {.orientation = OrientationChoice::Reversing, .positions = false});
  REQUIRE(match.matched_faces() == source.mesh.face_count());
  const Transferred result = transferred(source, target, match);
  CHECK(result.report.reversing);
  std::vector<std::pair<HalfedgeId, HalfedgeId>> pairs;
  for (std::uint32_t h = 0; h < source.mesh.halfedge_count(); ++h) {
    const HalfedgeId here(h / 4 * 4 + 3 - h % 4);  // corner k became corner n - 1 - k
    pairs.emplace_back(HalfedgeId(h), here);
  }
  CHECK(count_wrong(source, result.file, pairs) == 0);

  // In the source's order faces begin where the source's do, and run the other way.
  const MeshFile ordered = transferred(source, target, match, {.order = true}).file;
  for (std::uint32_t f = 0; f < source.mesh.face_count(); ++f) {
    for (std::uint32_t i = 0; i < 4; ++i) {
      const HalfedgeId there(4 * f + i), here(4 * f + (4 - i) % 4);
      CHECK(ordered.mesh.origin(here) == source.mesh.origin(there));
      CHECK(tuple_at(*ordered.texture_coordinates, here) == tuple_at(*source.texture_coordinates, there));
    }
  }
}

TEST_CASE("PLY's texture lists turn with their faces, of any number of corners") {
  const std::string_view source_text =
      "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nproperty list uchar float texcoord\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n3 1 0\n2 2 0\n"
      "4 0 1 2 3 8 0 0 1 0 1 1 0 1\n5 1 4 5 6 2 10 5 5 6 5 7 6 6 7 1 1\n";
  // The same faces, the pentagon first and from its third corner, the quad from its last.
  const std::string_view target_text =
      "ply\nformat ascii 1.0\nelement vertex 7\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n3 1 0\n2 2 0\n"
      "5 5 6 2 1 4\n4 3 0 1 2\n";
  const MeshFile source = parsed(source_text, Format::Ply);
  const MeshFile target = parsed(target_text, Format::Ply);
  Match match;
  match.regions.push_back({.faces = {{FaceId(0), FaceId(1), 1}, {FaceId(1), FaceId(0), 3}}});
  for (std::uint32_t v = 0; v < 7; ++v) match.vertices.push_back({VertexId(v), VertexId(v)});
  const MeshFile result = transferred(source, target, match).file;
  const Property* const list = find_property(result, "texcoord");
  REQUIRE(list != nullptr);
  CHECK(list->type == ScalarType::Float32);
  CHECK(list->list_starts == std::vector<std::uint32_t>{0, 10, 18});
  CHECK(list->values == std::vector<double>{7, 6, 6, 7, 1, 1, 5, 5, 6, 5, 0, 1, 0, 0, 1, 0, 1, 1});
  // At vertex 2 both faces say 1 1 and share it; at vertex 1 they differ: a seam.
  CHECK(result.texture_coordinates->values.size() == 16);

  const std::string ordered =
      format_mesh(transferred(source, target, match, {.order = true}).file, Format::Ply, {.ply = PlyEncoding::Ascii});
  CHECK(ordered == format_mesh(source, Format::Ply, {.ply = PlyEncoding::Ascii}));
}

TEST_CASE("properties of vertices and faces are carried by name, lists too; the target keeps those of its own") {
  MeshFile source = bare(shapes::grid(1, 2));
  source.properties = {
      {.name = "weights",
       .type = ScalarType::Float32,
       .count_type = ScalarType::UInt8,
       .list_starts = {0, 1, 1, 3, 3, 3, 4},
       .values = {0.5, 0.25, 0.75, 1}},
      {.name = "part", .domain = Domain::Face, .type = ScalarType::UInt8, .values = {7, 9}},
      {.name = "crease", .domain = Domain::Corner, .type = ScalarType::Float32, .values = {1, 2, 3, 4, 5, 6, 7, 8}}};
  MeshFile target = bare(shapes::grid(1, 2));
  target.properties = {{.name = "part", .domain = Domain::Face, .type = ScalarType::Int16, .values = {-300, 300}},
                       {.name = "own", .type = ScalarType::Float32, .values = {1, 2, 3, 4, 5, 6}},
                       {.name = "weights", .type = ScalarType::Float32, .values = {1, 1, 1, 1, 1, 1}}};
  Match match = identity_without(source.mesh, {1});
  const Transferred result = transferred(source, target, match);
  const Property* const part = find_property(result.file, "part");
  CHECK(part->values == std::vector<double>{7, 300});
  CHECK(part->type == ScalarType::Int16);
  CHECK(entry(result, "part").kept == 1);
  CHECK(entry(result, "part").remarks ==
        std::vector<std::string>{"the source stores uchar and the target short; the result stores short"});
  CHECK(find_property(result.file, "own")->values == target.properties[1].values);
  const Property* const weights = find_property(result.file, "weights");
  REQUIRE(weights->count_type.has_value());
  CHECK(weights->list_starts.size() == 7);
  for (const VertexPair& pair : match.vertices) {
    const std::uint32_t v = pair.source.value;
    CHECK(weights->list_starts[v + 1] - weights->list_starts[v] ==
          source.properties[0].list_starts[v + 1] - source.properties[0].list_starts[v]);
  }
  CHECK(entry(result, "weights").without == 2);
  CHECK(entry(result, "weights").remarks.size() == 1);
  CHECK(find_property(result.file, "crease")->values == std::vector<double>{1, 2, 3, 4, 0, 0, 0, 0});
}

TEST_CASE("colours of bytes and of fractions mean the same when they come together") {
  MeshFile source = bare(shapes::grid(1, 2)), target = source;
  source.properties = {{.name = "red", .type = ScalarType::UInt8, .values = {10, 20, 30, 40, 50, 60}}};
  target.properties = {{.name = "red", .type = ScalarType::Float64, .values = {1, 1, 1, 1, 1, 0.2}}};
  const Match match = identity_without(source.mesh, {1});
  std::vector<double> bytes = source.properties[0].values, fractions = target.properties[0].values;
  for (std::uint32_t v = 0; v < 6; ++v) {
    const bool matched = std::any_of(match.vertices.begin(), match.vertices.end(),
                                     [&](const VertexPair& pair) { return pair.source == VertexId(v); });
    if (matched) fractions[v] = source.properties[0].values[v];
    if (!matched) bytes[v] = std::round(255 * target.properties[0].values[v]);
  }
  const MeshFile result = transferred(source, target, match).file;
  CHECK(find_property(result, "red")->type == ScalarType::UInt8);
  CHECK(find_property(result, "red")->values == bytes);
}

TEST_CASE("what the source has not is refused by name of its file, and what was not asked for stays") {
  MeshFile source = bare(shapes::grid(2, 2)), target = flat(2, 2);
  source.path = "a.obj";
  const Match match = identity_without(source.mesh, {});
  const Expected<Transferred> nothing = transfer(source, target, match);
  REQUIRE_FALSE(nothing.has_value());
  CHECK(nothing.error().code == ErrorCode::BadArgument);
  CHECK(nothing.error().describe().starts_with("a.obj: it has none of the data that are to be carried"));
  CHECK(transfer(source, target, match, {.order = true}).has_value());

  MeshFile coloured = source;
  coloured.properties = {{.name = "red", .type = ScalarType::UInt8, .values = std::vector<double>(9, 5)}};
  coloured.normals = IndexedAttribute{3, {0, 0, 1}, std::vector<std::uint32_t>(16, 0)};
  const MeshFile result = transferred(coloured, target, match).file;
  CHECK(result.texture_coordinates->values == target.texture_coordinates->values);
  CHECK(result.texture_coordinates->corner_index == target.texture_coordinates->corner_index);
  CHECK_FALSE(result.normals.has_value());
  TransferOptions normals_only{.carry = Carry::nothing()};
  normals_only.carry.normals = true;
  const MeshFile with_normals = transferred(coloured, target, match, normals_only).file;
  CHECK(with_normals.normals->values == std::vector<double>{0, 0, 1});
  CHECK(with_normals.properties.empty());

  MeshFile nowhere{.mesh = build(soup_of(3, {{0, 1, 2}}))};
  TransferOptions positions{.carry = Carry::nothing()};
  positions.carry.positions = true;
  CHECK(transfer(nowhere, nowhere, identity_without(nowhere.mesh, {}), positions).error().message ==
        "it has no positions to carry; leave positions out");
}

TEST_CASE("in order, a renumbered copy is the source's file again, byte for byte but for its positions") {
  for (const shapes::Model& model : {shapes::shirt(shapes::Sleeves::Long), shapes::bear()}) {
    MeshFile source = file_of(model);
    source.face_records.insert(source.face_records.begin() + 5, {40, "s", "off"});
    std::stable_sort(source.face_records.begin(), source.face_records.end(),
                     [](const FaceRecord& a, const FaceRecord& b) { return a.first_face < b.first_face; });
    const shapes::Renumbered copy = shapes::renumbered(model.soup, 11);
    MeshFile target = bare(copy.soup);
    const Transferred result = transferred(source, target, found(source, target), {.order = true});
    CHECK(result.report.complete());
    CHECK((all_but_vertices(result.file) == all_but_vertices(source)));
    const auto there = source.mesh.positions(), here = result.file.mesh.positions();
    CHECK(std::equal(there.begin(), there.end(), here.begin(), here.end()));
  }
}

TEST_CASE("in order, what is new follows in the target's order, and lines and edges name the new numbers") {
  const std::string_view text =
      "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nv 1 1 0\nv 2 1 0\nv 9 9 9\nvt 0 0\nvt 1 1\n"
      "f 1/1 2/1 5/1 4/1\nl 3 2/2 1/1\nf 2 3 6 5\np 7\n";
  MeshFile source = bare(shapes::grid(1, 1));
  const MeshFile target = parsed(text, Format::Obj);
  // The source's only quad lies on the second of the target, from its third corner on.
  std::vector<VertexPair> vertices;
  for (std::uint32_t i = 0; i < 4; ++i) {
    vertices.push_back({source.mesh.origin(HalfedgeId(i)), target.mesh.origin(HalfedgeId(4 + (2 + i) % 4))});
  }
  std::sort(vertices.begin(), vertices.end(),
            [](const VertexPair& a, const VertexPair& b) { return a.source < b.source; });
  Match match;
  match.regions.push_back({.faces = {{FaceId(0), FaceId(1), 2}}});
  match.vertices = vertices;
  const MeshFile result = transferred(source, target, match, {.order = true}).file;
  for (std::uint32_t i = 0; i < 4; ++i) {
    CHECK(result.mesh.origin(HalfedgeId(i)) == source.mesh.origin(HalfedgeId(i)));
  }
  std::vector<std::uint32_t> place(7, 0);  // of the target's vertices
  for (std::uint32_t v = 0; v < 4; ++v) place[vertices[v].target.value] = v;
  place[0] = 4, place[3] = 5, place[6] = 6;
  CHECK(face(result, 1) == Corners{place[0], place[1], place[4], place[3]});
  for (std::uint32_t v = 0; v < 7; ++v) {
    CHECK(result.mesh.positions()[place[v]] == target.mesh.positions()[v]);
  }
  REQUIRE(result.carried.size() == 2);
  CHECK(result.carried[0].text == "l " + std::to_string(place[2] + 1) + " " + std::to_string(place[1] + 1) + "/2 " +
                                      std::to_string(place[0] + 1) + "/1");
  CHECK(result.carried[1].text == "p 7");
}

TEST_CASE("both copies of a vertex that was torn apart have its data, and only one its number") {
  const MeshFile source = bare(shapes::grid(6, 6));
  MeshFile coloured = source;
  Property number{.name = "number", .type = ScalarType::Int32};
  for (std::uint32_t v = 0; v < 49; ++v) number.values.push_back(v);
  coloured.properties = {number};
  HalfedgeId start;
  for (std::uint32_t h = 0; h < source.mesh.halfedge_count() && !start.valid(); ++h) {
    if (source.mesh.origin(HalfedgeId(h)) == VertexId(3 * 7 + 1) &&
        source.mesh.tip(HalfedgeId(h)) == VertexId(3 * 7 + 2)) {
      start = HalfedgeId(h);
    }
  }
  REQUIRE(start.valid());
  const Expected<shapes::Edit> edit = shapes::rip_edges(shapes::grid(6, 6), start, 3);
  REQUIRE(edit.has_value());
  const MeshFile target = bare(edit->soup);
  REQUIRE(target.mesh.vertex_count() == 51);
  const Match match = found(source, target);
  REQUIRE(match.matched_faces() == 36);
  REQUIRE(match.vertices.size() == 49);
  const Transferred result = transferred(coloured, target, match, {.order = true, .allow_ambiguous = true});
  CHECK(result.report.complete());
  std::vector<double> numbers = find_property(result.file, "number")->values;
  CHECK(std::equal(number.values.begin(), number.values.end(), numbers.begin()));
  CHECK(std::vector<double>(numbers.begin() + 49, numbers.end()) == std::vector<double>{23, 24});
}

TEST_CASE("smooth: constant data stay constant, linear data on a flat grid go on linearly") {
  const MeshFile source = flat(9, 9);
  MeshFile coloured = source;
  coloured.properties = {{.name = "height", .type = ScalarType::Float64},
                         {.name = "same", .type = ScalarType::Float64}};
  for (const Point& point : source.mesh.positions()) {
    coloured.properties[0].values.push_back(0.5 * point[0] + 2 * point[1]);
    coloured.properties[1].values.push_back(0.75);
  }
  coloured.properties.push_back(
      {.name = "area", .domain = Domain::Face, .type = ScalarType::Float64, .values = std::vector<double>(81, 0.3)});
  const MeshFile target = bare(shapes::grid(9, 9));
  const Match match = identity_without(source.mesh, middle_of_nine());
  const Transferred result = transferred(coloured, target, match, {.fill = Fill::Smooth});
  CHECK(entry(result, "height").filled == 16);
  CHECK(entry(result, "texture coordinates").filled == 100);
  for (std::uint32_t h = 0; h < target.mesh.halfedge_count(); ++h) {
    const std::vector<double> is = tuple_at(*result.file.texture_coordinates, HalfedgeId(h));
    const std::vector<double> should = tuple_at(*source.texture_coordinates, HalfedgeId(h));
    REQUIRE(is.size() == 2);
    for (std::size_t c = 0; c < 2; ++c) CHECK(is[c] == doctest::Approx(should[c]).epsilon(1e-9));
  }
  // No seam at the rim: each vertex has one entry, as in the source.
  CHECK(result.file.texture_coordinates->values.size() == source.texture_coordinates->values.size());
  for (const char* const name : {"height", "same", "area"}) {
    const Property& is = *find_property(result.file, name);
    const Property& should = *find_property(coloured, name);
    for (std::size_t i = 0; i < is.values.size(); ++i) CHECK(is.values[i] == doctest::Approx(should.values[i]));
  }
}

TEST_CASE("smooth: unmatched vertices move along with what is around them") {
  const MeshFile target = bare(shapes::grid(9, 9));
  PolygonSoup moved = shapes::grid(9, 9);
  for (Point& point : moved.positions) {
    point = {2 * point[0] + point[1] + 5, point[1] - 3, 0.5 * point[0]};
  }
  MeshFile source = bare(moved);
  TransferOptions options{.carry = Carry::nothing(), .fill = Fill::Smooth};
  options.carry.positions = true;
  const Match match = identity_without(source.mesh, middle_of_nine());
  const Transferred result = transferred(source, target, match, options);
  CHECK(entry(result, "positions").filled == 16);
  for (std::size_t v = 0; v < moved.positions.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(result.file.mesh.positions()[v][c] == doctest::Approx(moved.positions[v][c]).epsilon(1e-9));
    }
  }
  options.fill = Fill::Keep;
  const Transferred kept = transferred(source, target, match, options);
  CHECK(entry(kept, "positions").kept == 16);
  CHECK(kept.file.mesh.positions()[44] == target.mesh.positions()[44]);
}

TEST_CASE("smooth: a seam goes on through new faces, which are stretched over neither side") {
  // A tube cut open along a line for its texture; an inserted ring of quads crosses the line.
  const std::uint32_t around = 12;
  const PolygonSoup tube = shapes::cylinder(around, 6);
  MeshFile source = bare(tube);
  IndexedAttribute pool{2, {}, {}};
  std::map<std::pair<double, double>, std::uint32_t> index_of;
  const auto angle = [](const Point& point) { return std::atan2(point[1], point[0]) / (2 * 3.14159265358979); };
  for (std::uint32_t f = 0; f < source.mesh.face_count(); ++f) {
    double least = 2;
    for (const HalfedgeId h : source.mesh.halfedges(FaceId(f))) {
      const double a = angle(source.mesh.positions()[source.mesh.origin(h).value]);
      least = std::min(least, std::round(around * (a < -1e-9 ? a + 1 : a)));
    }
    for (const HalfedgeId h : source.mesh.halfedges(FaceId(f))) {
      const Point& point = source.mesh.positions()[source.mesh.origin(h).value];
      double u = std::round(around * (angle(point) < -1e-9 ? angle(point) + 1 : angle(point)));
      // The last column runs to the full circle.
      bool crosses = false;
      for (const HalfedgeId other : source.mesh.halfedges(FaceId(f))) {
        const double b = angle(source.mesh.positions()[source.mesh.origin(other).value]);
        crosses = crosses || std::round(around * (b < -1e-9 ? b + 1 : b)) == around - 1;
      }
      if (crosses && u == 0) u = around;
      const std::pair<double, double> key{u, point[2]};
      const auto [place, is_new] = index_of.emplace(key, static_cast<std::uint32_t>(index_of.size()));
      if (is_new) pool.values.insert(pool.values.end(), {key.first, key.second});
      pool.corner_index.push_back(place->second);
    }
  }
  source.texture_coordinates = std::move(pool);
  // An edge along the tube in the middle of it: crossing it, the loop runs round.
  HalfedgeId along;
  for (std::uint32_t h = 4 * 3 * around; h < source.mesh.halfedge_count() && !along.valid(); ++h) {
    const Point& from = source.mesh.positions()[source.mesh.origin(HalfedgeId(h)).value];
    const Point& to = source.mesh.positions()[source.mesh.tip(HalfedgeId(h)).value];
    if (std::abs(from[2] - to[2]) > 1e-6 && source.mesh.twin(HalfedgeId(h)).valid()) along = HalfedgeId(h);
  }
  const Expected<shapes::Edit> edit = shapes::insert_edge_loop(tube, along);
  REQUIRE(edit.has_value());
  REQUIRE(edit->truth.size() == tube.corners.size() / 4 - around);
  const MeshFile target = bare(edit->soup);
  // Two regions, above and below the ring, as they truly are.
  Match match;
  std::map<std::uint32_t, std::uint32_t> vertices;
  std::vector<std::uint8_t> taken(source.mesh.face_count(), 0);
  std::map<std::uint32_t, FacePair> survives;
  for (const FacePair& pair : edit->truth) survives.emplace(pair.source.value, pair);
  for (const auto& [face, pair] : survives) {
    if (taken[face] != 0) continue;
    Region region;
    std::vector<std::uint32_t> to_visit{face};
    taken[face] = 1;
    while (!to_visit.empty()) {
      const std::uint32_t f = to_visit.back();
      to_visit.pop_back();
      region.faces.push_back(survives.at(f));
      for (const HalfedgeId h : source.mesh.halfedges(FaceId(f))) {
        const HalfedgeId here(target.mesh.first(survives.at(f).target).value + source.mesh.corner(h));
        vertices[source.mesh.origin(h).value] = target.mesh.origin(here).value;
        const HalfedgeId across = source.mesh.twin(h);
        if (!across.valid()) continue;
        const std::uint32_t other = source.mesh.face(across).value;
        if (taken[other] != 0 || !survives.contains(other)) continue;
        taken[other] = 1;
        to_visit.push_back(other);
      }
    }
    match.regions.push_back(std::move(region));
  }
  REQUIRE(match.regions.size() == 2);
  for (const auto& [from, to] : vertices) match.vertices.push_back({VertexId(from), VertexId(to)});

  const Transferred result = transferred(source, target, match, {.fill = Fill::Smooth});
  CHECK(entry(result, "texture coordinates").filled == 4 * 2 * around);
  CHECK(entry(result, "texture coordinates").without == 0);
  for (std::uint32_t f = 0; f < target.mesh.face_count(); ++f) {
    double least = 1e9, most = -1e9;
    for (const HalfedgeId h : target.mesh.halfedges(FaceId(f))) {
      const std::vector<double> uv = tuple_at(*result.file.texture_coordinates, h);
      least = std::min(least, uv[0]);
      most = std::max(most, uv[0]);
      CHECK(uv[1] == doctest::Approx(target.mesh.positions()[target.mesh.origin(h).value][2]));
    }
    CHECK(most - least == doctest::Approx(1.0));
  }
}

TEST_CASE("groups and materials: the state of each face, kept, given up, or that of the nearest face") {
  MeshFile source = bare(shapes::grid(4, 1)), target = source;
  source.face_records = {{0, "g", "left"}, {0, "usemtl", "skin"}, {2, "g", "right"}};
  source.material_libraries = {"source.mtl"};
  target.face_records = {{0, "g", "own"}, {0, "s", "3"}, {3, "g", "end"}};
  target.material_libraries = {"target.mtl"};
  const Match match = identity_without(source.mesh, {2, 3});
  using Strings = std::vector<std::string>;
  const Transferred keep = transferred(source, target, match);
  CHECK(states(keep.file, "g") == Strings{"left", "left", "own", "end"});
  CHECK(states(keep.file, "usemtl") == Strings{"skin", "skin", "", ""});
  CHECK(states(keep.file, "s") == Strings{"3", "3", "3", "3"});
  CHECK(keep.file.material_libraries == Strings{"source.mtl"});
  CHECK(entry(keep, "usemtl").without == 2);
  CHECK(states(transferred(source, target, match, {.fill = Fill::None}).file, "g") ==
        Strings{"left", "left", "default", "default"});
  const Transferred smooth = transferred(source, target, match, {.fill = Fill::Smooth});
  CHECK(states(smooth.file, "g") == Strings{"left", "left", "left", "left"});
  CHECK(states(smooth.file, "usemtl") == Strings{"skin", "skin", "skin", "skin"});
  CHECK(entry(smooth, "usemtl").filled == 2);
  TransferOptions materials{.carry = Carry::nothing()};
  materials.carry.materials = true;
  CHECK(states(transferred(source, target, match, materials).file, "g") == Strings{"own", "own", "own", "end"});
}

TEST_CASE("keep: an object whose matched faces take a name takes it whole, others keep theirs") {
  MeshFile source = bare(shapes::grid(6, 1)), target = source;
  source.face_records = {{0, "o", "shirt"}, {2, "o", "button"}};
  target.face_records = {{0, "o", "one"}, {4, "o", "two"}};
  const Transferred result = transferred(source, target, identity_without(source.mesh, {3, 4, 5}));
  CHECK(states(result.file, "o") == std::vector<std::string>{"shirt", "shirt", "button", "shirt", "two", "two"});
  CHECK(entry(result, "o").carried == 3);
  CHECK(entry(result, "o").filled == 1);
  CHECK(entry(result, "o").kept == 2);
}

TEST_CASE("keep: the pool holds what is used of the source's, then of the target's own, as wide as the wider") {
  MeshFile source = flat(2, 1), target = flat(2, 1);
  target.texture_coordinates = IndexedAttribute{3, {}, {0, 0, 0, 0, 1, 1, 1, 2}};
  target.texture_coordinates->values = {9, 9, 9, 8, 8, 8, 7, 7, 7};
  const Match match = identity_without(source.mesh, {1});
  const Transferred result = transferred(source, target, match);
  const IndexedAttribute& pool = *result.file.texture_coordinates;
  CHECK(pool.components == 3);
  CHECK(pool.values.size() == 3 * 6);
  CHECK(tuple_at(pool, HalfedgeId(7)) == std::vector<double>{7, 7, 7});
  CHECK(pool.corner_index[4] == pool.corner_index[5]);
  std::vector<double> padded = tuple_at(*source.texture_coordinates, HalfedgeId(1));
  padded.push_back(0);
  CHECK(tuple_at(pool, HalfedgeId(1)) == padded);
  CHECK(entry(result, "texture coordinates").remarks ==
        std::vector<std::string>{"the source has 2 numbers each and the target 3; those missing became 0"});
  CHECK(entry(result, "texture coordinates").kept == 4);
}

TEST_CASE("ambiguous regions and those of low confidence are left out by name, unless they are allowed") {
  const MeshFile source = flat(2, 1), target = bare(lifted(shapes::grid(2, 1)));
  Match match;
  match.regions.push_back({.faces = {{FaceId(1), FaceId(1), 0}}, .evidence = {1, 4, 4}});
  match.regions.push_back({.faces = {{FaceId(0), FaceId(0), 0}}, .ways = 2, .ambiguous = true});
  for (std::uint32_t v = 0; v < 6; ++v) match.vertices.push_back({VertexId(v), VertexId(v)});
  const Transferred cautious = transferred(source, target, match, {.least_confidence = 0.5});
  REQUIRE(cautious.report.left_out.size() == 2);
  CHECK(cautious.report.left_out[0].reason == LeftOutRegion::Reason::LowConfidence);
  CHECK(cautious.report.left_out[0].confidence == 0.25);
  CHECK(cautious.report.left_out[1].reason == LeftOutRegion::Reason::Ambiguous);
  CHECK(cautious.report.left_out[1].faces == 1);
  CHECK(cautious.report.left_out[1].first_target == FaceId(0));
  CHECK(cautious.report.left_out[1].ways == 2);
  CHECK(cautious.report.matched_faces == 0);
  CHECK(entry(cautious, "texture coordinates").without == 8);

  const Transferred usual = transferred(source, target, match);
  CHECK(usual.report.matched_faces == 1);
  CHECK_FALSE(usual.report.complete());
  const Transferred bold = transferred(source, target, match, {.allow_ambiguous = true});
  CHECK(bold.report.left_out.empty());
  CHECK(bold.report.complete());
}

TEST_CASE("an ambiguous region of which nothing moved is certain, unless something else lies in its place") {
  const auto carried = [](const MeshFile& source, const MeshFile& target, std::uint32_t rotation, bool positions) {
    Match match;
    match.regions.push_back({.faces = {{FaceId(0), FaceId(0), rotation}}, .ways = 4, .ambiguous = true});
    for (std::uint32_t k = 0; k < 4; ++k) {
      match.vertices.push_back({source.mesh.corners()[k], target.mesh.corners()[(k + rotation) % 4]});
    }
    std::sort(match.vertices.begin(), match.vertices.end(),
              [](const VertexPair& a, const VertexPair& b) { return a.source < b.source; });
    return transferred(source, target, match, {.positions = positions}).report.matched_faces == 1;
  };
  const MeshFile source = flat(2, 1), target = bare(shapes::grid(2, 1));
  CHECK(carried(source, target, 0, true));
  CHECK_FALSE(carried(source, target, 0, false));
  CHECK_FALSE(carried(source, target, 1, true));
  CHECK_FALSE(carried(source, bare(lifted(shapes::grid(2, 1))), 0, true));
  PolygonSoup without = shapes::grid(2, 1);
  without.positions.clear();
  CHECK_FALSE(carried(source, bare(std::move(without)), 0, true));

  const PolygonSoup two = shapes::disjoint_union({shapes::grid(1, 1), shapes::grid(1, 1)});
  REQUIRE(two.positions[0] == two.positions[4]);
  MeshFile stacked = bare(two);
  stacked.texture_coordinates = IndexedAttribute{2, {0, 0}, std::vector<std::uint32_t>(8, 0)};
  CHECK_FALSE(carried(stacked, bare(two), 0, true));
}

TEST_CASE("the row beside one that was taken out is certain where it could not be the one that is gone") {
  constexpr std::uint32_t kColumns = 4, kRows = 6;
  // Column 1 is gone, or in the first `turned` rows column 2; what is left of column 2 is in doubt. Without the last
  // two faces column 2 is shorter than column 1.
  const auto left_out = [&](bool shorter, std::uint32_t turned) {
    MeshFile source = flat(kColumns, kRows);
    PolygonSoup there = lifted(shapes::grid(kColumns - 1, kRows)), here = shapes::grid(kColumns, kRows);
    if (shorter) {
      for (PolygonSoup* soup : {&here, &there}) soup->corners.resize(soup->corners.size() - 8);
      source.mesh = build(here);
      source.texture_coordinates->corner_index.resize(here.corners.size());
    }
    Region left, right, doubtful{.ways = 2, .ambiguous = true};
    for (std::uint32_t row = 0; row < kRows; ++row) {
      const auto take = [&](Region& region, std::uint32_t column, std::uint32_t image) {
        const FaceId face(row * kColumns + column);
        if (face.value < source.mesh.face_count()) {
          region.faces.push_back({face, FaceId(row * (kColumns - 1) + image), 0});
        }
      };
      take(left, 0, 0);
      if (row < turned) take(left, 1, 1);
      if (row >= turned) take(doubtful, 2, 1);
      take(right, 3, 2);
    }
    const MeshFile target = bare(there);
    Match match;
    match.regions = {left, right, doubtful};
    std::map<VertexId, VertexId> image, origin;
    for (const Region& region : match.regions) {
      for (const FacePair& pair : region.faces) {
        for (std::uint32_t corner = 0; corner < 4; ++corner) {
          const VertexId v = source.mesh.corners()[4 * pair.source.value + corner];
          const VertexId w = target.mesh.corners()[4 * pair.target.value + corner];
          if (image.contains(v) || origin.contains(w)) continue;
          image[v] = w;
          origin[w] = v;
        }
      }
    }
    for (const auto& [v, w] : image) match.vertices.push_back({v, w});
    const Transferred result = transferred(source, target, match);
    return result.report.complete() ? 0 : result.report.left_out[0].faces;
  };
  CHECK(left_out(false, 0) == kRows);     // the mesh is the same whichever is gone
  CHECK(left_out(true, 0) == 0);          // column 2 is too short to be the row that is gone
  CHECK(left_out(true, 2) == kRows - 3);  // neither of them is gone as a whole
}

TEST_CASE("a match that is not sound for these meshes is refused, with its first fault") {
  const MeshFile source = flat(2, 2), target = bare(shapes::grid(2, 1));
  const Expected<Transferred> result = transfer(source, target, identity_without(source.mesh, {}));
  REQUIRE_FALSE(result.has_value());
  CHECK(result.error().code == ErrorCode::MatchDoesNotFit);
  CHECK(result.error().message.starts_with("the match is not sound for these meshes: "));
}
