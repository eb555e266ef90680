#include <quadmatch/report/report.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <map>

#include <nlohmann/json.hpp>
#include <quadmatch/io/write_mesh.hpp>
#include <quadmatch/match/matcher.hpp>
#include <quadmatch/shapes/bear.hpp>
#include <quadmatch/shapes/edit.hpp>
#include <quadmatch/shapes/renumber.hpp>
#include <quadmatch/shapes/zoo.hpp>

#include "mesh/named_meshes.hpp"

using namespace quadmatch;
using namespace quadmatch::test;
using Json = nlohmann::json;

namespace {

/// The text of the script element with an id.
std::string element(const std::string& html, const std::string& id) {
  const std::size_t opening = html.find("id=\"" + id + "\">");
  REQUIRE(opening != std::string::npos);
  const std::size_t start = html.find('>', opening) + 1;
  return html.substr(start, html.find("</script>", start) - start);
}

std::string decoded(const std::string& base64) {
  std::string bytes;
  std::uint32_t bits = 0;
  int held = 0;
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (const char c : base64) {
    if (c == '=') break;
    bits = bits << 6U | static_cast<std::uint32_t>(digits.find(c));
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> held & 0xffU);
  }
  return bytes;
}

/// A report read back: its header, and its blocks by name.
struct Page {
  Json header;
  std::map<std::string, std::string> blocks;
};

Page read_back(const std::string& html) {
  Page page{Json::parse(element(html, "report-header")), {}};
  const std::string bytes = decoded(element(html, "report-data"));
  std::size_t at = 0;
  for (const Json& block : page.header.at("blocks")) {
    page.blocks[block[0]] = bytes.substr(at, block[1]);
    at += block[1].get<std::size_t>();
  }
  CHECK(at == bytes.size());
  return page;
}

/// Numbers of a block, one after the other.
class Reader {
 public:
  explicit Reader(std::string bytes) : bytes_(std::move(bytes)) {}
  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0;; shift += 7) {
      REQUIRE(at_ < bytes_.size());
      const auto byte = static_cast<unsigned char>(bytes_[at_++]);
      value |= static_cast<std::uint64_t>(byte & 0x7fU) << shift;
      if (byte < 0x80) return value;
    }
  }
  std::uint32_t step(std::uint32_t before) {
    const std::uint64_t zigzag = number();
    const auto way = static_cast<std::int64_t>(zigzag / 2);
    return static_cast<std::uint32_t>(before + (zigzag % 2 == 0 ? way : -way - 1));
  }
  std::vector<std::uint32_t> list() {
    std::vector<std::uint32_t> numbers(number());
    std::uint32_t before = 0;
    for (std::uint32_t& one : numbers) one = before = step(before);
    return numbers;
  }
  [[nodiscard]] bool done() const { return at_ == bytes_.size(); }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

std::size_t count_bits(const std::string& bytes) {
  std::size_t count = 0;
  for (const char byte : bytes) count += static_cast<std::size_t>(__builtin_popcount(static_cast<unsigned char>(byte)));
  return count;
}

/// The corners of a side, whichever way they are stored.
std::vector<std::uint32_t> corners_of(const Page& page, const std::string& side) {
  const std::string& bytes = page.blocks.at(side + ".corners");
  std::vector<std::uint32_t> corners(page.header.at(side).at("corners").get<std::size_t>());
  const std::size_t width = page.header.at(side).at("corner_bits");
  Reader steps(bytes);
  std::uint32_t before = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (width == 0) corners[i] = before = steps.step(before);
    for (std::size_t bit = 0; bit < width; ++bit) {
      const std::size_t at = i * width + bit;
      corners[i] |= (static_cast<unsigned char>(bytes.at(at / 8)) >> (at % 8) & 1U) << bit;
    }
  }
  return corners;
}

std::vector<std::uint32_t> numbers_of(const Mesh& mesh) {
  std::vector<std::uint32_t> numbers;
  for (const VertexId corner : mesh.corners()) numbers.push_back(corner.value);
  return numbers;
}

MeshFile file_of(PolygonSoup soup) { return MeshFile{.mesh = build(std::move(soup)), .path = "mesh.obj"}; }

Page report_of(const MeshFile& source, const MeshFile& target, const Match& match, ReportText text = {}) {
  return read_back(format_report(source, target, match, text));
}

Match matched(const MeshFile& source, const MeshFile& target) {
  MatchOptions options;
  options.waves = true;
  return match(source.mesh, target.mesh, options).match;
}

}  // namespace

TEST_CASE("corners, pairs, rotations and waves come back as they were") {
  const shapes::Model bear = shapes::bear({});
  const MeshFile source = file_of(bear.soup), target = file_of(shapes::renumbered(bear.soup, 5).soup);
  const Match match = matched(source, target);
  REQUIRE(match.matched_faces() == source.mesh.face_count());
  const Page page = report_of(source, target, match);

  CHECK((corners_of(page, "source") == numbers_of(source.mesh)));
  CHECK((corners_of(page, "target") == numbers_of(target.mesh)));

  Reader pairs(page.blocks.at("pairs")), waves(page.blocks.at("waves"));
  FacePair pair{FaceId(0), FaceId(0), 0};
  for (const Region& region : match.regions) {
    CHECK(waves.list() == region.waves);
    for (const FacePair& expected : region.faces) {
      pair.source = FaceId(pairs.step(pair.source.value));
      pair.target = FaceId(pairs.step(pair.target.value));
      pair.rotation = static_cast<std::uint32_t>(pairs.number());
      CHECK(pair == expected);
    }
  }
  CHECK(pairs.done());
  CHECK(waves.done());
  CHECK(page.header.at("regions").at(0).at("faces") == match.regions[0].faces.size());
  CHECK(page.header.at("source").at("all_quads") == true);
}

TEST_CASE("corners are steps where the file goes on where it was, and as short as they can be where it does not") {
  const PolygonSoup grid = shapes::grid(40, 40);
  const MeshFile ordered = file_of(grid), shuffled = file_of(shapes::renumbered(grid, 1).soup);
  const Page page = report_of(ordered, shuffled, {});
  CHECK(page.header.at("source").at("corner_bits") == 0);
  CHECK(page.blocks.at("source.corners").size() <= 6400);
  CHECK(page.header.at("target").at("corner_bits") == 11);  // 1,681 vertices
  CHECK(page.blocks.at("target.corners").size() == 6400 * 11 / 8);
  CHECK((corners_of(page, "source") == numbers_of(ordered.mesh)));
  CHECK((corners_of(page, "target") == numbers_of(shuffled.mesh)));
}

TEST_CASE("positions lie on a grid of 65,536 steps where faces are large enough for it, else they are kept") {
  PolygonSoup soup = shapes::grid(3, 2);
  const Page near = report_of(file_of(soup), file_of(soup), {});
  CHECK(near.header.at("source").at("positions") == "grid");
  const double step = near.header.at("source").at("step");
  CHECK(step == doctest::Approx(3.0 / 65535));
  const std::string& bytes = near.blocks.at("source.positions");
  REQUIRE(bytes.size() == std::size_t{6} * soup.vertex_count);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    const int stored = static_cast<unsigned char>(bytes[i]) + 256 * static_cast<unsigned char>(bytes[i + 1]);
    const double low = near.header.at("source").at("low").at(i / 2 % 3);
    CHECK(low + stored * step == doctest::Approx(soup.positions[i / 6][i / 2 % 3]).epsilon(1e-4));
  }

  // A vertex a million edges away: on a grid all the rest would be one point.
  soup.positions.push_back({3e6, 0, 0});
  ++soup.vertex_count;
  const Page far = report_of(file_of(soup), file_of(soup), {});
  CHECK(far.header.at("source").at("positions") == "float32");
  CHECK(far.blocks.at("source.positions").size() == std::size_t{12} * soup.vertex_count);
}

TEST_CASE("positions that cannot be drawn, or are none, spoil nothing else") {
  PolygonSoup soup = shapes::cube();
  soup.positions[3] = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e200};
  const Page odd = report_of(file_of(soup), file_of(soup), {});
  CHECK(odd.header.at("source").at("step").get<double>() < 1.0);
  soup.positions.assign(soup.vertex_count, {7, 7, 7});
  const Page point = report_of(file_of(soup), file_of(soup), {});
  CHECK(point.header.at("source").at("step") == 0.0);
  CHECK(point.blocks.at("source.positions") == std::string(std::size_t{6} * soup.vertex_count, '\0'));
  soup.positions.clear();
  const Page none = report_of(file_of(soup), file_of(soup), {});
  CHECK(none.header.at("source").at("positions") == "none");
  CHECK(none.blocks.at("source.positions").empty());
  CHECK(none.header.at("source").at("faces") == 6);
}

TEST_CASE("what is marked: separatrices edge by edge, extraordinary vertices with their codes, crossings, seams") {
  // Each edge of a cube joins two extraordinary vertices.
  const Page cube = report_of(file_of(shapes::cube()), file_of(shapes::prism(5)), {});
  CHECK(count_bits(cube.blocks.at("source.skeleton")) == 12);
  Reader extraordinary(cube.blocks.at("source.extraordinary"));
  REQUIRE(extraordinary.number() == 8);
  std::uint32_t vertex = 0;
  for (std::uint32_t v = 0; v < 8; ++v) {
    vertex = extraordinary.step(vertex);
    CHECK(vertex == v);
    CHECK(extraordinary.number() == 4 * 3);  // valence 3, inside, quads only
  }
  CHECK(extraordinary.done());
  CHECK(cube.header.at("target").at("all_quads") == false);
  Reader sizes(cube.blocks.at("target.sizes"));
  std::map<std::uint64_t, int> count;
  while (!sizes.done()) ++count[sizes.number()];
  CHECK(count == std::map<std::uint64_t, int>{{4, 5}, {5, 2}});

  // Three quads on one edge: it is cut.
  PolygonSoup fins{.vertex_count = 8, .positions = std::vector<Point>(8)};
  for (const std::uint32_t v : {0U, 1U, 2U, 3U, 0U, 1U, 4U, 5U, 0U, 1U, 6U, 7U}) fins.corners.push_back(VertexId(v));
  const Page dirty = report_of(file_of(fins), file_of(fins), {});
  CHECK(Reader(dirty.blocks.at("source.seams")).list() == std::vector<std::uint32_t>{0, 1});
}

TEST_CASE("a border between two regions has both its half-edges, and the rim of what is unmatched none") {
  const MeshFile strip = file_of(shapes::grid(3, 1));
  const Match match{.regions = {{.faces = {{FaceId(0), FaceId(2), 0}}}, {.faces = {{FaceId(1), FaceId(0), 0}}}},
                    .vertices = {}};
  const Page page = report_of(strip, strip, match);
  CHECK(count_bits(page.blocks.at("source.borders")) == 2);
  CHECK(count_bits(page.blocks.at("target.borders")) == 0);
}

TEST_CASE("areas without a partner are named from the largest, source first") {
  const PolygonSoup star = shapes::star(5, 3);
  const MeshFile source = file_of(shapes::disjoint_union({star, shapes::cube(), shapes::grid(3, 3)}));
  const MeshFile target = file_of(shapes::disjoint_union({star, shapes::grid(1, 1)}));
  Match match;
  match.regions.push_back({});
  for (std::uint32_t f = 0; f < 45; ++f) match.regions[0].faces.push_back({FaceId(f), FaceId(f), 0});
  const std::vector<ReportChange> changes = unmatched_areas(source.mesh, target.mesh, match);
  REQUIRE(changes.size() == 3);
  CHECK(changes[0].kind == "only in source");
  CHECK(changes[0].sentence == "9 faces around f51 have no partner");
  CHECK(changes[0].source_faces.size() == 9);
  CHECK(changes[0].target_faces.empty());
  CHECK(changes[1].sentence == "6 faces around f45 have no partner");
  CHECK(changes[2].kind == "only in target");
  CHECK(changes[2].sentence == "f45 has no partner");
  CHECK(changes[2].target_faces == std::vector<FaceId>{FaceId(45)});
}

TEST_CASE("changes of any kind are handed on: kind, sentence, faces of both sides in their order") {
  const MeshFile strip = file_of(shapes::grid(3, 1));
  const ReportText text{.title = "two strips",
                        .program = "test",
                        .figures = {{"matched", "nothing"}},
                        .changes = {{"twist", {FaceId(2), FaceId(0)}, {FaceId(1)}, "a ring was turned"},
                                    {"edge loop", {}, {FaceId(2)}, "a loop was inserted"}}};
  const Page page = report_of(strip, strip, {}, text);
  CHECK(page.header.at("title") == "two strips");
  CHECK(page.header.at("figures") == Json::array({Json::array({"matched", "nothing"})}));
  CHECK(page.header.at("changes") ==
        Json::array({Json::array({"twist", "a ring was turned"}), Json::array({"edge loop", "a loop was inserted"})}));
  Reader changes(page.blocks.at("changes"));
  CHECK(changes.list() == std::vector<std::uint32_t>{2, 0});
  CHECK(changes.list() == std::vector<std::uint32_t>{1});
  CHECK(changes.list().empty());
  CHECK(changes.list() == std::vector<std::uint32_t>{2});
  CHECK(changes.done());
}

TEST_CASE("no name can end the element it stands in, or break the text") {
  MeshFile file = file_of(shapes::cube());
  file.path = "</script><script>alert(1)</script>.obj";
  file.face_records = {{0, "g", "<!--\xff\xfe"}, {3, "usemtl", "a\"b\\c\n"}, {3, "s", "1"}};
  const ReportText text{.title = "<b>&amp;</b>", .program = "<script>"};
  const std::string html = format_report(file, file, {}, text);
  const std::string plain = format_report(file_of(shapes::cube()), file_of(shapes::cube()), {}, {});
  const auto count = [](const std::string& where, std::string_view what) {
    std::size_t found = 0;
    for (std::size_t at = where.find(what); at != std::string::npos; at = where.find(what, at + 1)) ++found;
    return found;
  };
  CHECK(count(html, "<script") == count(plain, "<script"));
  CHECK(count(html, "</script") == count(plain, "</script"));
  CHECK(count(html, "<!--") == count(plain, "<!--"));
  const Page page = read_back(html);
  CHECK(page.header.at("source").at("path") == file.path);
  CHECK(page.header.at("title") == "<b>&amp;</b>");
  CHECK(page.header.at("source").at("names") == Json::array({"<!--\xef\xbf\xbd\xef\xbf\xbd", "a\"b\\c\n"}));
  Reader records(page.blocks.at("source.records"));
  CHECK(records.step(0) == 0);
  CHECK(records.number() == 1);
  CHECK(records.number() == 0);
  CHECK(records.step(0) == 3);
  CHECK(records.number() == 2);
  CHECK(records.number() == 1);
  CHECK(records.done());
}

TEST_CASE("the same input gives the same bytes, and a report loads nothing") {
  const shapes::Model bear = shapes::bear({});
  const MeshFile source = file_of(bear.soup), target = file_of(shapes::renumbered(bear.soup, 5).soup);
  const Match match = matched(source, target);
  const std::string html = format_report(source, target, match, {});
  CHECK((html == format_report(source, target, match, {})));
  CHECK(html.starts_with("<!doctype html>"));
  CHECK(html.find("default-src 'none'") != std::string::npos);
  for (const char* reference : {"<link", " src=", " href=\"http", "@import", "url(http"}) {
    CAPTURE(reference);
    CHECK(html.find(reference) == std::string::npos);
  }
}

TEST_CASE("a report of 20,000 quads a side is at most 2 MB, in whatever order the faces stand") {
  const PolygonSoup sphere = shapes::sphere(58);  // 20,184 quads
  const MeshFile source = file_of(shapes::renumbered(sphere, 1).soup),
                 target = file_of(shapes::renumbered(sphere, 2).soup);
  Match match;
  match.regions.push_back({});
  for (std::uint32_t f = 0; f < source.mesh.face_count(); ++f) {
    const std::uint32_t other = static_cast<std::uint32_t>((f * 7919ULL) % source.mesh.face_count());
    match.regions[0].faces.push_back({FaceId(f), FaceId(other), 3});
  }
  CHECK(format_report(source, target, match, {}).size() <= 2'000'000);
}

TEST_CASE("faces fall into connected areas, each ascending, from the largest and then from the lowest face") {
  const Mesh grid = build(shapes::grid(4, 3));  // rows of four
  const auto numbers = [&](std::initializer_list<std::uint32_t> faces) {
    std::vector<FaceId> wanted;
    for (const std::uint32_t f : faces) wanted.emplace_back(f);
    std::vector<std::vector<std::uint32_t>> areas;
    for (const std::vector<FaceId>& area : connected_areas(grid, wanted)) {
      areas.emplace_back();
      for (const FaceId face : area) areas.back().push_back(face.value);
    }
    return areas;
  };
  using Areas = std::vector<std::vector<std::uint32_t>>;
  CHECK(numbers({}) == Areas{});
  CHECK(numbers({11, 0, 5, 9, 3, 1}) == Areas{{0, 1, 5, 9}, {3}, {11}});  // 9 lies above 5, and corners do not join
  CHECK(numbers({10, 0, 5}) == Areas{{0}, {5}, {10}});
  CHECK(numbers({7, 7, 3}) == Areas{{3, 7}});
}

TEST_CASE("a report says whether it shows a mirror") {
  MeshFile file{.mesh = build(shapes::cube())};
  CHECK(read_back(format_report(file, file, {}, {.title = "a", .program = "b"})).header.at("mirror") == false);
  CHECK(read_back(format_report(file, file, {}, {.title = "a", .program = "b", .mirror = true})).header.at("mirror") ==
        true);
}
