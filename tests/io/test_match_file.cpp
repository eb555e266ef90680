// The match file: what DESIGN says it holds, and what it must not.

#include <algorithm>

#include "io_support.hpp"

using namespace quadmatch;
using namespace quadmatch::test;

namespace {

MatchFile match_of(std::string_view text) {
  Expected<MatchFile> file = parse_match(text, "match");
  if (!file) FAIL(file.error().describe());
  return std::move(*file);
}

Error match_error(std::string_view text) {
  const Expected<MatchFile> file = parse_match(text, "match");
  REQUIRE_FALSE(file.has_value());
  return file.error();
}

/// The design's example with one piece of it replaced.
std::string with(std::string_view from, std::string_view to) {
  std::string text(kMatch);
  const std::size_t at = text.find(from);
  REQUIRE(at != text.npos);
  return text.replace(at, from.size(), to);
}

MatchFile sample() {
  MatchFile file{{"a.obj", 9, 4}, {"b.obj", 9, 4}, {}};
  Region large;
  large.orientation = Orientation::Reversing;
  large.faces = {{FaceId(0), FaceId(3), 2}, {FaceId(1), FaceId(2), 0}, {FaceId(2), FaceId(1), 3}};
  large.waves = {1, 3};
  large.evidence = {2, 3, 4};
  Region small;
  small.faces = {{FaceId(3), FaceId(0), 1}};
  file.match.regions = {large, small};
  file.match.vertices = {{VertexId(0), VertexId(8)}, {VertexId(1), VertexId(7)}};
  file.match.complete = false;
  file.settings = {{"algorithm", "lazy-greedy"}, {"a \"b\"", "c\\d"}};
  return file;
}

}  // namespace

TEST_CASE("a match file as the design shows it is read") {
  const MatchFile file = match_of(kMatch);
  CHECK(file.source == MatchSide{"a.obj", 1070, 1042});
  CHECK(file.target == MatchSide{"b.obj", 1071, 1043});
  REQUIRE(file.match.regions.size() == 1);
  CHECK(file.match.regions[0].orientation == Orientation::Preserving);
  CHECK(file.match.regions[0].faces == std::vector<FacePair>{{FaceId(0), FaceId(17), 2}, {FaceId(1), FaceId(4), 0}});
  CHECK(file.match.vertices == std::vector<VertexPair>{{VertexId(0), VertexId(5)}, {VertexId(1), VertexId(9)}});
  CHECK(file.match.complete);
  CHECK(file.settings.empty());
}

TEST_CASE("a match file comes back with everything it held, and the same bytes") {
  const MatchFile file = sample();
  const std::string bytes = format_match(file);
  const MatchFile again = match_of(bytes);
  CHECK(again.source == file.source);
  CHECK(again.target == file.target);
  REQUIRE(again.match.regions.size() == 2);
  for (std::size_t r = 0; r < 2; ++r) {
    CHECK(again.match.regions[r].orientation == file.match.regions[r].orientation);
    CHECK(again.match.regions[r].faces == file.match.regions[r].faces);
    CHECK(again.match.regions[r].waves == file.match.regions[r].waves);
    CHECK(again.match.regions[r].evidence == file.match.regions[r].evidence);
  }
  CHECK(again.match.vertices == file.match.vertices);
  CHECK_FALSE(again.match.complete);
  CHECK(again.settings == file.settings);
  CHECK(format_match(again) == bytes);
}

TEST_CASE("a match file is written as this text") {
  CHECK(format_match(sample()) ==
        "{\"format\": \"quadmatch.match/1\",\n"
        " \"source\": {\"path\": \"a.obj\", \"vertices\": 9, \"faces\": 4},\n"
        " \"target\": {\"path\": \"b.obj\", \"vertices\": 9, \"faces\": 4},\n"
        " \"complete\": false,\n"
        " \"settings\": {\"algorithm\": \"lazy-greedy\", \"a \\\"b\\\"\": \"c\\\\d\"},\n"
        " \"regions\": [\n"
        "  {\"orientation\": \"reversing\",\n"
        "   \"evidence\": {\"agreeing\": 2, \"source_extraordinary\": 3, \"target_extraordinary\": 4},\n"
        "   \"waves\": [1, 3],\n"
        "   \"faces\": [\n"
        "    [0, 3, 2], [1, 2, 0], [2, 1, 3]]},\n"
        "  {\"orientation\": \"preserving\",\n"
        "   \"evidence\": {\"agreeing\": 0, \"source_extraordinary\": 0, \"target_extraordinary\": 0},\n"
        "   \"faces\": [\n"
        "    [3, 0, 1]]}],\n"
        " \"vertices\": [\n"
        "  [0, 8], [1, 7]]}\n");
}

TEST_CASE("an empty match is a match file too") {
  const MatchFile file{{"a", 1, 1}, {"b", 1, 1}, {}};
  CHECK(match_of(format_match(file)).match.regions.empty());
}

TEST_CASE("paths that are no UTF-8 are written with replacement characters") {
  const MatchFile file{{"caf\xe9.obj", 1, 1}, {"\xff\n\"", 1, 1}, {}};
  const MatchFile again = match_of(format_match(file));
  CHECK(again.source.path == "caf\xef\xbf\xbd.obj");
  CHECK(again.target.path == "\xef\xbf\xbd\n\"");
}

TEST_CASE("fields of others are passed over, in any order and depth") {
  const MatchFile file = match_of(
      with(" \"regions\": [{",
           " \"statistics\": {\"faces\": [[1, {\"regions\": [null, -1.5]}]], \"source\": 3}, \"n\": null, \"x\": -1,\n"
           " \"settings\": {\"rounds\": 10, \"deep\": {\"a\": [\"b\"]}, \"algorithm\": \"greedy\", \"fast\": true},\n"
           " \"regions\": [{\"doubtful\": [[0]], \"note\": \"hm\", \"confidence\": 0.5, "));
  CHECK(file.match.matched_faces() == 2);
  CHECK(file.settings == std::vector<std::pair<std::string, std::string>>{{"algorithm", "greedy"}});
}

TEST_CASE("a missing field is named") {
  for (const char* const field : {"format", "source", "target", "regions", "vertices"}) {
    std::string renamed = "\"" + std::string(field) + "\":";
    const Error error = match_error(with(field == std::string("vertices") ? "\"vertices\": [[" : renamed,
                                         field == std::string("vertices") ? "\"other\": [[" : "\"other\":"));
    CHECK(error.code == ErrorCode::Syntax);
    CHECK(error.describe() == "match: the field '" + std::string(field) + "' is missing; match the meshes again");
  }
  CHECK(match_error("{}").message == "the field 'format' is missing; match the meshes again");
}

TEST_CASE("another format is refused by name") {
  CHECK(match_error(with("match/1", "match/2")).describe() ==
        "match:1: the format is 'quadmatch.match/2', but this program reads 'quadmatch.match/1'; match the meshes "
        "again");
}

TEST_CASE("negative, fractional and huge indices are refused, naming region and pair") {
  const auto complaint_about = [](std::string_view number) {
    return match_error(with("[1, 4, 0]", "[1, " + std::string(number) + ", 0]"));
  };
  CHECK(complaint_about("-4").describe() ==
        "match:4: region 0, pair 1: '-4' is not a whole number from 0 to 4294967294; match the meshes again");
  CHECK(complaint_about("4.5").code == ErrorCode::BadNumber);
  CHECK(complaint_about("4e0").code == ErrorCode::BadNumber);
  CHECK(complaint_about("4294967295").code == ErrorCode::BadNumber);
  CHECK(complaint_about("99999999999999999999").code == ErrorCode::BadNumber);
  CHECK(match_error(with("[1, 9]", "[1, -9]")).describe() ==
        "match:5: vertices, pair 1: '-9' is not a whole number from 0 to 4294967294; match the meshes again");
  CHECK(match_error(with("1043", "-1")).describe() ==
        "match:3: 'faces': '-1' is not a whole number from 0 to 4294967294; match the meshes again");
}

TEST_CASE("pairs beyond the counts that the file states are refused") {
  CHECK(match_error(with("[1, 4, 0]", "[1, 1043, 0]")).describe() ==
        "match: region 0, pair 1: there is no face 1043 in the target, which has 1043; match the meshes again");
  CHECK(match_error(with("[1, 4, 0]", "[1042, 4, 0]")).code == ErrorCode::BadIndex);
  CHECK(match_error(with("[1, 9]", "[1, 1071]")).describe() ==
        "match: vertices, pair 1: there is no vertex 1071 in the target, which has 1071; match the meshes again");
  CHECK(match_error(with("\"faces\": [[", "\"waves\": [1, 3], \"faces\": [[")).describe() ==
        "match: region 0: its waves do not rise to its 2 faces; match the meshes again");
}

TEST_CASE("pairs of a wrong number of numbers, and values of a wrong kind, are refused") {
  CHECK(match_error(with("[1, 4, 0]", "[1, 4]")).describe() ==
        "match:4: region 0, pair 1 has 2 numbers instead of 3; match the meshes again");
  CHECK(match_error(with("[1, 9]", "[1, 9, 0]")).message ==
        "vertices, pair 1 has 3 numbers instead of 2; match the meshes again");
  CHECK(match_error(with("[1, 4, 0]", "[1, \"4\", 0]")).message ==
        "region 0, pair 1: a text does not belong here in a match file; match the meshes again");
  CHECK(match_error(with("\"preserving\"", "\"sideways\"")).message ==
        "region 0, 'orientation': 'sideways' is no orientation; write preserving or reversing");
  CHECK(match_error(with("\"a.obj\"", "7")).code == ErrorCode::Syntax);
  CHECK(match_error(with("[[0, 5], [1, 9]]", "{}")).code == ErrorCode::Syntax);
  CHECK(match_error("[]").message == "the file: an array does not belong here in a match file; match the meshes again");
  CHECK(match_error("7").code == ErrorCode::Syntax);
}

TEST_CASE("text that is no JSON is refused at its line, and cut text as cut") {
  CHECK(match_error(with("[1, 4, 0]", "[1, 4; 0]")).describe() ==
        "match:4: this is not JSON at '4;'; match the meshes again");
  CHECK(match_error(kMatch.substr(0, 100)).code == ErrorCode::Truncated);
  CHECK(match_error("").describe() == "match:1: the match file ends too early; match the meshes again");
  CHECK(match_error(std::string(kMatch) + "x").code == ErrorCode::Syntax);
  CHECK(match_error("v 0 0 0\n").code == ErrorCode::Syntax);
}

TEST_CASE("a match file fits the meshes it was made for, and says which one differs") {
  const MatchFile file = match_of(kMatch);
  CHECK(fits(file, {"a.obj", 1070, 1042}, {"b.obj", 1071, 1043}).has_value());
  const Expected<void> other = fits(file, {"bear.obj", 1070, 1043}, {"b.obj", 1071, 1043});
  REQUIRE_FALSE(other.has_value());
  CHECK(other.error().code == ErrorCode::MatchDoesNotFit);
  CHECK(other.error().message ==
        "the match was made for a source of 1042 faces, but bear.obj has 1043; match the meshes again");
  const Expected<void> target = fits(file, {"a.obj", 1070, 1042}, {"bear.obj", 1072, 1043});
  REQUIRE_FALSE(target.has_value());
  CHECK(target.error().message ==
        "the match was made for a target of 1071 vertices, but bear.obj has 1072; match the meshes again");
}

TEST_CASE("arrays nested a million deep neither crash nor hang") {
  const std::string deep(1'000'000, '[');
  CHECK(match_error("{\"x\": " + deep).code == ErrorCode::Truncated);
}
